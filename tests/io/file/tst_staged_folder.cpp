// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/staged_folder.h"

#include <sys/wait.h>
#include <unistd.h>

#include <QTest>
#include <csignal>
#include <functional>

#include "core/base/error.h"
#include "io/file/files.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

void addText(const StagedFolder& folder, const std::string& name, const std::string& text) {
  folder.add(name, [&](const fs::path& place) { writeText(place, text); });
}

void write(const fs::path& folder, const std::vector<std::pair<std::string, std::string>>& files,
           bool replace = false) {
  StagedFolder staged(folder, {"a", "b", "sub/c"}, replace);
  for (const auto& [name, text] : files) addText(staged, name, text);
  staged.commit();
}

/// A program that ends by SIGKILL in what `work` does.
void killedIn(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::kill(::getpid(), SIGKILL);
  }
  QVERIFY(child > 0);
  int status = 0;
  ::waitpid(child, &status, 0);
  QVERIFY(WIFSIGNALED(status));
}

/// A folder as commit() leaves it that is killed after its first renames: b is still the former
/// one.
void killedInCommit(const Folder& folder) {
  write(folder.path(), {{"a", "1"}, {"b", "1"}, {"sub/c", "1"}});
  killedIn([&] {
    StagedFolder staged(folder.path(), {"a", "b", "sub/c"}, true);
    addText(staged, "b", "2");
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (fs::is_directory(entry) && entry.path().filename().string().starts_with(".angiomesh"))
        writeText(entry.path() / kCommitNote, R"({"names": ["a", "b"], "gone": ["sub/c"]})");
    save(folder / "a", "2");
    ::kill(::getpid(), SIGKILL);
  });
}

template <class E>
bool throws(const std::function<void()>& work) {
  try {
    work();
  } catch (const E&) {
    return true;
  }
  return false;
}

}  // namespace

class TestStagedFolder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void appearsAsAWholeOrNotAtAll() {
    const Folder folder;
    {
      const StagedFolder staged(folder / "up/out", {"a"}, false);
      addText(staged, "a", "1");
      QVERIFY(!fs::exists(folder / "up/out"));
    }
    QCOMPARE(entriesOf(folder.path()), 0);
    write(folder / "up/out", {{"a", "1"}, {"sub/c", "3"}});
    QCOMPARE(entriesOf(folder / "up"), 1);
    QCOMPARE(entriesOf(folder / "up/out"), 2);
    QCOMPARE(bytesOf(folder / "up/out/sub/c"), std::string("3"));
  }

  void replacesAllOfAFormerResultWhenAskedTo() {
    const Folder folder;
    save(folder / "mine", "user's");
    write(folder.path(), {{"a", "1"}, {"sub/c", "3"}});
    QVERIFY(throws<InputError>([&] { write(folder.path(), {{"b", "2"}}); }));
    write(folder.path(), {{"a", "new"}, {"b", "2"}}, true);
    QCOMPARE(bytesOf(folder / "a"), std::string("new"));
    QVERIFY(fs::exists(folder / "b") && !fs::exists(folder / "sub/c"));
    QCOMPARE(bytesOf(folder / "mine"), std::string("user's"));
    QCOMPARE(entriesOf(folder.path()), 4);  // with the empty sub
  }

  void aFailureInTheMiddleTakesAllBack() {
    const Folder folder;
    write(folder.path(), {{"a", "1"}, {"b", "2"}});
    StagedFolder staged(folder.path(), {"a", "b", "sub/c"}, true);
    addText(staged, "a", "new");
    addText(staged, "sub/c", "new");
    // There cannot be a folder of this name any more.
    save(folder / "sub", "a file");
    QVERIFY(throws<IoError>([&] { staged.commit(); }));
    QCOMPARE(bytesOf(folder / "a"), std::string("1"));
    QCOMPARE(bytesOf(folder / "b"), std::string("2"));
  }

  void oneProgramAtATime() {
    const Folder folder;
    fs::create_directory(folder / "there");
    for (const char* name : {"there", "new"}) {
      StagedFolder first(folder / name, {"a"}, false);
      QVERIFY(throws<InputError>([&] { const StagedFolder second(folder / name, {"a"}, true); }));
      addText(first, "a", "1");
      first.commit();
    }
    QCOMPARE(entriesOf(folder.path()), 2);
    QCOMPARE(entriesOf(folder / "there"), 1);
  }

  void nothingThatAppearedMeanwhileIsReplaced() {
    const Folder folder;
    StagedFolder fresh(folder / "new", {"a"}, false);
    addText(fresh, "a", "1");
    fs::create_directory(folder / "new");
    QVERIFY(throws<InputError>([&] { fresh.commit(); }));
    QCOMPARE(entriesOf(folder / "new"), 0);

    StagedFolder staged(folder / "new", {"a"}, false);
    addText(staged, "a", "1");
    save(folder / "new/a", "somebody's");
    QVERIFY(throws<InputError>([&] { staged.commit(); }));
    QCOMPARE(bytesOf(folder / "new/a"), std::string("somebody's"));
  }

  void whatAKilledProgramLeftGoes() {
    const Folder folder;
    fs::create_directory(folder / "there");
    for (const char* name : {"there", "new"}) {
      killedIn([&] {
        const StagedFolder staged(folder / name, {"a"}, false);
        addText(staged, "a", "1");
        ::kill(::getpid(), SIGKILL);
      });
    }
    killedIn([&] {
      writeAtomically(folder / "file.txt", [](const fs::path&) { ::kill(::getpid(), SIGKILL); });
    });
    QCOMPARE(entriesOf(folder.path()), 2);  // there, and file.txt's: it began with new's
    QCOMPARE(entriesOf(folder / "there"), 2);
    write(folder / "there", {{"a", "2"}});
    QCOMPARE(entriesOf(folder / "there"), 1);
    write(folder / "new", {{"a", "2"}});
    QCOMPARE(entriesOf(folder.path()), 2);
  }

  void whatAProgramIsWritingStays() {
    const Folder folder;
    const TemporaryPlace held(folder.path(), TemporaryPlace::Kind::File, ".txt");
    removeLeftovers(folder.path());
    QVERIFY(fs::exists(held.path()));
    QVERIFY(!isLeftover(held.path()));
    save(folder / ".angiomesh-notes.txt", "user's");
    removeLeftovers(folder.path());
    QVERIFY(fs::exists(folder / ".angiomesh-notes.txt"));
  }

  void aCommitThatWasKilledIsFinished() {
    const Folder folder;
    killedInCommit(folder);
    QCOMPARE(bytesOf(folder / "b"), std::string("1"));
    { const StagedFolder next(folder.path(), {"a", "b", "sub/c"}, true); }
    QCOMPARE(bytesOf(folder / "a"), std::string("2"));
    QCOMPARE(bytesOf(folder / "b"), std::string("2"));
    QVERIFY(!fs::exists(folder / "sub/c"));
    QCOMPARE(entriesOf(folder.path()), 3);
  }

  void aCommitThatWasKilledIsFinishedBeforeAFileIsWritten() {
    const Folder folder;
    killedInCommit(folder);
    writeText(folder / "b", "3");
    QCOMPARE(bytesOf(folder / "a"), std::string("2"));
    QCOMPARE(entriesOf(folder.path()), 3);
    // What is newer stays.
    { const StagedFolder next(folder.path(), {"a", "b", "sub/c"}, true); }
    QCOMPARE(bytesOf(folder / "b"), std::string("3"));
  }

  void noLinkIsFollowed() {
    const Folder folder;
    const Folder elsewhere;
    save(elsewhere / "a", "secret");
    fs::create_symlink(elsewhere / "a", folder / "a");
    QVERIFY(throws<IoError>([&] { write(folder.path(), {{"a", "1"}}, true); }));
    fs::remove(folder / "a");
    fs::create_symlink(elsewhere / "none", folder / "b");
    QVERIFY(throws<IoError>([&] { write(folder.path(), {{"b", "1"}}, true); }));
    fs::remove(folder / "b");
    fs::create_directory_symlink(elsewhere.path(), folder / "sub");
    QVERIFY(throws<IoError>([&] { write(folder.path(), {{"sub/c", "1"}}, true); }));
    QCOMPARE(bytesOf(elsewhere / "a"), std::string("secret"));
    QCOMPARE(entriesOf(elsewhere.path()), 1);
    QVERIFY(throws<IoError>([&] { (void)placeIn(folder.path(), "x/../../y"); }));
    QVERIFY(throws<IoError>([&] { (void)placeIn(folder.path(), "/etc/passwd"); }));
    // The folder itself may be one: the user gave it.
    fs::remove(elsewhere / "a");
    fs::create_directory_symlink(elsewhere.path(), folder / "named");
    write(folder / "named", {{"b", "1"}});
    QVERIFY(fs::exists(elsewhere / "b"));
  }
};

QTEST_GUILESS_MAIN(TestStagedFolder)
#include "tst_staged_folder.moc"
