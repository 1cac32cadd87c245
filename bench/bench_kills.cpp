// SPDX-License-Identifier: BSD-3-Clause
// What is left of the edits of a program that is killed while somebody works: a child makes edits
// of all kinds, is killed at a random moment, and its journal is restored.
#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "gui/model/case_models.h"
#include "io/volume/image_write.h"

using namespace angiomesh;

namespace {

constexpr int kPatienceMs = 60000;
/// Edits that the child may have made after the last one that it told.
constexpr int kAhead = 20;

struct Options {
  int kills = 200;
  std::uint64_t seed = 1;
  int everyMs = 40;     ///< between two edits: as a slider that is dragged sends them
  int longestMs = 600;  ///< from the first edit to the kill
  std::string child;    ///< the recovery folder of a child
  std::string volume;
};

double number(std::uint64_t seed, int n, int which) {
  return randomUniform(seed, static_cast<std::uint64_t>(8 * n + which));
}

/// The edit of number n: the same one whenever it is made in the same place of the same sequence.
void edit(CaseDocument& document, std::uint64_t seed, int n) {
  const double value = number(seed, n, 1);
  const Eigen::Vector3d place(value, number(seed, n, 2), number(seed, n, 3));
  switch (static_cast<int>(8.0 * number(seed, n, 0))) {
    case 0:
      document.setField("levelset.xi", 10.0 + 20.0 * value);
      break;
    case 1:
      document.setField("levelset.gamma", value, true);
      break;
    case 2:
      document.addSeed(place);
      break;
    case 3:
      document.removeSeed(0);
      break;
    case 4:
      document.moveSeed(0, place);
      break;
    case 5: {
      CaseNotes notes = document.notes();
      notes.review.remarks.push_back({place, 3, "remark " + std::to_string(n)});
      document.changeNotes(notes, "remark");
      break;
    }
    case 6:
      document.undoStack()->undo();
      break;
    default:
      document.undoStack()->redo();
  }
}

bool waitFor(const std::function<bool()>& done) {
  QElapsedTimer clock;
  clock.start();
  while (!done() && clock.elapsed() < kPatienceMs) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    QThread::msleep(1);
  }
  return done();
}

/// Makes edits until it is killed, and tells the number of each.
int beChild(const Options& options) {
  CaseModels models(makeThreadedJobRunner, options.child);
  models.files.open(QString::fromStdString(options.volume));
  if (!waitFor([&] { return models.document.hasCase(); })) return 1;
  QTimer timer;
  int n = 0;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    edit(models.document, options.seed, ++n);
    std::printf("%d\n", n);
    std::fflush(stdout);
  });
  timer.start(options.everyMs);
  return QCoreApplication::exec();
}

struct Kill {
  int made = 0;       ///< edits that the child told
  int restored = -1;  ///< the last edit that is there again; -1: no state of the child's
};

/// The last number of the child's edits after which it had these parameters and notes.
int editOf(const CaseDocument& restored, const Options& options, std::uint64_t seed, int most) {
  CaseModels models(makeInlineJobRunner);
  models.files.open(QString::fromStdString(options.volume));
  int found = -1;
  for (int n = 0; n <= most; ++n) {
    if (n > 0) edit(models.document, seed, n);
    if (models.document.parameters() == restored.parameters() &&
        models.document.notes() == restored.notes())
      found = n;
  }
  return found;
}

Kill killOne(const Options& options, std::uint64_t seed) {
  const QTemporaryDir recovery;
  QProcess child;
  child.start(QCoreApplication::applicationFilePath(),
              {"--child", recovery.path(), "--volume", QString::fromStdString(options.volume),
               "--seed", QString::number(seed), "--every", QString::number(options.everyMs)});
  Kill kill;
  if (!child.waitForReadyRead(kPatienceMs)) return kill;
  QThread::usleep(static_cast<unsigned long>(1000.0 * options.longestMs * number(seed, 0, 7)));
  child.kill();
  child.waitForFinished(kPatienceMs);
  const QList<QByteArray> lines = child.readAllStandardOutput().split('\n');
  kill.made = lines.size() > 1 ? lines[lines.size() - 2].toInt() : 0;

  CaseModels models(makeInlineJobRunner);
  const std::vector<Recovery> left = findRecoveries(recovery.path().toStdString());
  if (left.empty()) {
    // No edit is on the disk: perhaps none of them had changed anything yet.
    models.files.open(QString::fromStdString(options.volume));
    kill.restored = editOf(models.document, options, seed, kill.made + kAhead);
    return kill;
  }
  CaseRequest request;
  request.folder = left.front().place->folder;
  request.place = left.front().place;
  request.source = options.volume;
  request.restore = true;
  models.files.openCase(std::move(request));
  if (waitFor([&] { return models.document.hasCase(); }))
    kill.restored = editOf(models.document, options, seed, kill.made + kAhead);
  return kill;
}

int killMany(Options options) {
  const QTemporaryDir folder;
  options.volume = folder.filePath("tube.mha").toStdString();
  PhantomParams phantom;
  phantom.kind = PhantomKind::Tube;
  phantom.size = {24, 24, 24};
  writeVolume(makePhantom(phantom).image, options.volume);
  std::vector<int> lost;
  int spoilt = 0, made = 0;
  for (int n = 0; n < options.kills; ++n) {
    const Kill kill = killOne(options, options.seed * 100000 + static_cast<std::uint64_t>(n));
    made += kill.made;
    if (kill.restored < 0)
      ++spoilt;
    else
      lost.push_back(std::max(kill.made - kill.restored, 0));
  }
  std::sort(lost.begin(), lost.end());
  const auto none = std::upper_bound(lost.begin(), lost.end(), 0) - lost.begin();
  const auto one = std::upper_bound(lost.begin(), lost.end(), 1) - lost.begin();
  std::printf("%d kills, %d edits, one every %d ms\n", options.kills, made, options.everyMs);
  std::printf("nothing lost: %d\nthe last edit lost: %d\nmore lost: %d (at most %d edits)\n",
              static_cast<int>(none), static_cast<int>(one - none),
              static_cast<int>(lost.size()) - static_cast<int>(one),
              lost.empty() ? 0 : lost.back());
  std::printf("not to be restored, or to no state that there was: %d\n", spoilt);
  return spoilt > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App program("How many edits a program loses that is killed");
  program.add_option("--kills", options.kills, "How many")->check(CLI::Range(1, 100000));
  program.add_option("--seed", options.seed, "Of edits and moments");
  program.add_option("--every", options.everyMs, "Between two edits, ms");
  program.add_option("--longest", options.longestMs, "From the first edit to the kill, ms");
  program.add_option("--child", options.child)->group("");
  program.add_option("--volume", options.volume)->group("");
  CLI11_PARSE(program, argc, argv);
  QCoreApplication app(argc, argv);
  QCoreApplication::setOrganizationName("AngiomeshBench");
  return options.child.empty() ? killMany(options) : beChild(options);
}
