// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/files.h"

#include <QTest>
#include <set>

#include "core/base/error.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

class TestFiles : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textAndPicturesAreWrittenWhole() {
    const Folder folder;
    writeText(folder / "a.json", "one");
    writeText(folder / "a.json", "two");
    QCOMPARE(readText(folder / "a.json"), std::string("two"));
    fs::create_symlink(folder / "a.json", folder / "link.json");
    writeText(folder / "link.json", "three");
    QVERIFY(fs::is_symlink(folder / "link.json"));
    QCOMPARE(readText(folder / "a.json"), std::string("three"));
    QVERIFY_THROWS_EXCEPTION(IoError, writeText("/dev/full", "x"));
    QVERIFY(fs::exists("/dev/full") && !fs::is_regular_file("/dev/full"));
    QVERIFY_THROWS_EXCEPTION(IoError, readText(folder / "none"));
    QVERIFY_THROWS_EXCEPTION(IoError, readText(folder.path()));

    Picture picture{2, 3, {}};
    for (int i = 0; i < 18; ++i) picture.rgb.push_back(static_cast<std::uint8_t>(10 * i));
    writePng(picture, folder / "p.png");
    const std::string png = bytesOf(folder / "p.png");
    QVERIFY(png.starts_with("\x89PNG"));
    QVERIFY(png.find("IEND") != std::string::npos);
    QCOMPARE(static_cast<int>(png[19]), 2);  // width and height stand in IHDR
    QCOMPARE(static_cast<int>(png[23]), 3);
    QVERIFY_THROWS_EXCEPTION(InputError, writePng(Picture{2, 3, {}}, folder / "q.png"));
    QCOMPARE(entriesOf(folder.path()), 3);
  }

  void aWriterThatThrowsLeavesNothing() {
    const Folder folder;
    save(folder / "a.txt", "old");
    QVERIFY_THROWS_EXCEPTION(InputError,
                             writeAtomically(folder / "a.txt", [](const fs::path& temporary) {
                               save(temporary, "half");
                               throw InputError("x", "y", "z");
                             }));
    QCOMPARE(bytesOf(folder / "a.txt"), std::string("old"));
    QCOMPARE(entriesOf(folder.path()), 1);
    std::set<std::string> names;
    for (int i = 0; i < 3; ++i)
      writeAtomically(folder / "b.nii.gz", [&](const fs::path& temporary) {
        QCOMPARE(temporary.parent_path(), folder.path());
        QVERIFY(temporary.string().ends_with(".nii.gz"));
        names.insert(temporary.string());
        save(temporary, "x");
      });
    QCOMPARE(names.size(), std::size_t{3});
  }
};

QTEST_APPLESS_MAIN(TestFiles)
#include "tst_files.moc"
