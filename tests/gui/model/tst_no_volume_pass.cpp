// SPDX-License-Identifier: BSD-3-Clause
#include <sys/mman.h>
#include <unistd.h>

#include <QTest>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <set>
#include <thread>
#include <utility>

#include "core/parameters/field.h"
#include "gui/findings/case_ports.h"
#include "gui/model/case_models.h"
#include "tests/gui/small_case.h"

using namespace angiomesh;

namespace {

// Volumes whose pages nobody may touch. A touch is counted and then allowed.
struct Guarded {
  std::uintptr_t begin = 0, end = 0;
};
constexpr int kMostGuarded = 16;
Guarded guarded[kMostGuarded];
std::atomic<int> guardedCount{0}, touched{0};

void allow(const Guarded& volume) {
  mprotect(reinterpret_cast<void*>(volume.begin), volume.end - volume.begin,
           PROT_READ | PROT_WRITE);
}

void onTouch(int signal, siginfo_t* info, void* /*context*/) {
  const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
  for (int i = 0; i < guardedCount; ++i) {
    if (at >= guarded[i].begin && at < guarded[i].end) {
      ++touched;
      allow(guarded[i]);
      return;
    }
  }
  std::signal(signal, SIG_DFL);
}

void guard(const std::shared_ptr<const Volume<float>>& volume) {
  if (!volume) {
    return;
  }
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(volume->voxels.data());
  const std::uintptr_t last = first + volume->voxels.size() * sizeof(float);
  const Guarded range{(first + page - 1) / page * page, last / page * page};
  QVERIFY(range.end > range.begin && guardedCount < kMostGuarded);
  guarded[guardedCount++] = range;
  QCOMPARE(mprotect(reinterpret_cast<void*>(range.begin), range.end - range.begin, PROT_NONE), 0);
}

void allowAll() {
  for (int i = 0; i < guardedCount; ++i) {
    allow(guarded[i]);
  }
  guardedCount = 0;
}

/// Work waits until the test lets it run, on a thread of its own.
class HeldRunner final : public JobRunner {
 public:
  ~HeldRunner() override { all().erase(this); }
  void start(std::function<void()> work) override {
    work_ = std::move(work);
    all().insert(this);
  }
  [[nodiscard]] bool running() const override { return static_cast<bool>(work_); }
  void wait() override {
    if (work_) {
      std::thread(std::exchange(work_, nullptr)).join();
    }
    all().erase(this);
  }
  static void letAllRun() {
    while (!all().empty()) {
      (*all().begin())->wait();
    }
  }

 private:
  static std::set<HeldRunner*>& all() {
    static std::set<HeldRunner*> runners;
    return runners;
  }
  std::function<void()> work_;
};

/// Lets workers work, and the window take what they made, until nothing is left to do.
void settle(CaseModels& models) {
  for (int round = 0; round < 20; ++round) {
    HeldRunner::letAllRun();
    models.timer.poll();
  }
}

/// All that forms, lists and tables ask for after each change.
void look(CaseModels& models) {
  const FieldContext context = models.results.fieldContext();
  for (const Field& field : parameterFields()) {
    (void)sliderRange(field, context);
    (void)suggestedValue(field, models.document.parameters(), context);
  }
  for (int step = 0; step < kStepCount; ++step) {
    (void)models.runs.state(static_cast<Step>(step));
    (void)models.results.seconds(static_cast<Step>(step));
  }
  (void)models.presets.current();
  (void)models.results.components();
  (void)models.results.layer(Layer::Speed);
  (void)models.results.estimatedTriangles();
  (void)models.results.expectationWarnings();
  (void)models.results.phi();
  (void)models.results.ports(MeshKind::Exported);
}

/// Every kind of edit, and back.
void edit(CaseModels& models) {
  const Geometry& g = models.document.image()->geometry;
  const Eigen::Vector3d low = g.toPhysical({2.0, 2.0, 2.0});
  const Eigen::Vector3d high = g.toPhysical({g.size[0] - 3.0, g.size[1] - 3.0, g.size[2] - 3.0});
  for (const char* key : {"levelset.xi", "surface.rho", "vesselness.alpha", "smooth.lambda"}) {
    for (const double value : {0.6, 0.5, 0.4}) {
      models.document.setField(key, value, true);
      look(models);
    }
  }
  models.document.setRoi(std::array<double, 6>{low[0], low[1], low[2], high[0], high[1], high[2]});
  look(models);
  models.document.addSeed(0.5 * (low + high));
  models.presets.apply("thesis");
  models.results.setComponentTicked(0, false);
  look(models);
  for (int i = 0; i < 8; ++i) {
    models.document.undoStack()->undo();
    look(models);
  }
}

}  // namespace

/// Whatever is edited or asked for, the window's thread goes through no volume: those of the image
/// and of all results lie in memory that it must not touch.
class TestNoVolumePass : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    struct sigaction action = {};
    action.sa_sigaction = onTouch;
    action.sa_flags = SA_SIGINFO;
    QCOMPARE(sigaction(SIGSEGV, &action, nullptr), 0);
  }

  void aTouchIsCounted() {
    const auto volume = std::make_shared<const Volume<float>>(Geometry{{32, 32, 32}}, 1.0F);
    guard(volume);
    touched = 0;
    QCOMPARE(valueRange(*volume)[1], 1.0F);
    QCOMPARE(touched.load(), 1);
    allowAll();
  }

  void editsAndQuestionsTouchNoVolume() {
    CaseModels models([] { return std::make_unique<HeldRunner>(); });
    CasePorts ports(models, [] { return std::make_unique<HeldRunner>(); });
    models.files.take(test::twoTubes());
    settle(models);
    QVERIFY(models.document.hasCase());
    touched = 0;
    guard(models.document.image());
    edit(models);
    allowAll();
    QCOMPARE(touched.load(), 0);

    models.runs.run();
    settle(models);
    QVERIFY(models.results.meshFresh());
    ports.cutEnds(2.0);
    settle(models);
    guard(models.document.image());
    guard(models.results.layer(Layer::Vesselness));
    guard(models.results.evolveResult()->phi);
    guard(models.results.meshRun()->surface->phi);
    edit(models);
    ports.cutHere(models.document.image()->geometry.toPhysical({10.0, 10.0, 10.0}));
    allowAll();
    QCOMPARE(touched.load(), 0);
    settle(models);
  }
};

QTEST_GUILESS_MAIN(TestNoVolumePass)
#include "tst_no_volume_pass.moc"
