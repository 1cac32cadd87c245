// SPDX-License-Identifier: BSD-3-Clause
// How soon the window answers a slider: the whole window is driven, on the screen.
#include <CLI/CLI.hpp>
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "gui/job/file_jobs.h"
#include "gui/main_window.h"
#include "gui/pane/view_grid.h"
#include "gui/view/open_gl.h"
#include "gui/view/slice_view.h"

using namespace angiomesh;

namespace {

constexpr int kPatienceMs = 600000;

bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatienceMs); }

/// The place deepest inside the vessels.
Eigen::Vector3d deepest(const Volume<float>& phi) {
  const auto at = std::min_element(phi.voxels.begin(), phi.voxels.end()) - phi.voxels.begin();
  const Index3 p = phi.geometry.indexOf(static_cast<std::size_t>(at));
  return phi.geometry.toPhysical(Eigen::Vector3d(p[0], p[1], p[2]));
}

double share(std::vector<double>& sample, double fraction) {
  std::sort(sample.begin(), sample.end());
  return sample[static_cast<std::size_t>(fraction * static_cast<double>(sample.size() - 1))];
}

/// Moves a slider at random, and waits each time for the first frame that shows something new and
/// for the preview that stays.
void measure(MainWindow& window, const Field& field, int moves) {
  auto* editor = window.findChild<QWidget*>(QString::fromStdString("field:" + field.key));
  auto* slider = editor ? editor->findChild<QSlider*>("slider") : nullptr;
  if (!slider || !slider->isEnabled()) return;
  LivePreview& live = window.models().live;
  SliceView* pane = window.views().slice(2);
  std::vector<double> first, settled;
  std::mt19937 random(1);
  const int before = slider->value(), width = (slider->maximum() - slider->minimum()) / 8;
  for (int move = 0; move < moves; ++move) {
    const int step = static_cast<int>(random() % static_cast<unsigned>(2 * width + 1)) - width;
    const int to =
        std::clamp(before + (step == 0 ? 1 : step), slider->minimum(), slider->maximum());
    if (to == slider->value()) continue;
    const auto shown = live.phi();
    double firstMs = -1.0;
    QElapsedTimer clock;
    const auto frame = QObject::connect(pane, &VtkView::rendered, pane, [&] {
      if (firstMs < 0.0 && live.phi() != shown)
        firstMs = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    });
    clock.start();
    slider->setValue(to);
    if (!waitFor([&] { return firstMs >= 0.0 && !live.working(); })) return;
    settled.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    first.push_back(firstMs);
    QObject::disconnect(frame);
  }
  slider->setValue(before);
  waitFor([&] { return !live.working(); });
  if (first.empty()) return;
  std::printf("%-28s %6.0f %6.0f ms   %6.0f %6.0f ms\n", field.key.c_str(), share(first, 0.5),
              share(first, 0.95), share(settled, 0.5), share(settled, 0.95));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App options("How soon a preview answers a slider");
  int size = 128, side = LivePreview::kUsualSide, moves = 20;
  std::string input;
  options.add_option("INPUT", input, "a scan; by default a noisy tree");
  options.add_option("--size", size, "of the tree, voxels along each axis");
  options.add_option("--side", side, "of the box, voxels");
  options.add_option("--moves", moves, "of each slider");
  CLI11_PARSE(options, argc, argv);
  prepareOpenGl();
  QApplication application(argc, argv);
  MainWindow window{MainWindowOptions()};
  window.resize(1280, 860);
  window.show();
  window.findChild<QAction*>("workspaceTune")->trigger();
  if (input.empty())
    window.models().files.take(makeSampleSource(size, {}));
  else
    window.open(QString::fromStdString(input));
  CaseModels& models = window.models();
  if (!waitFor([&] { return models.document.hasCase(); })) return 1;
  models.runs.run(Step::Evolve);
  if (!waitFor([&] { return !models.runs.running(); }) || !models.results.evolveResult()) return 1;
  window.views().setCrosshair(deepest(*models.results.evolveResult()->phi));
  window.findChild<QSpinBox*>("liveSide")->setValue(side);
  const Index3& n = models.document.image()->geometry.size;
  std::printf("%d x %d x %d voxels, a box of %d^3, %d moves of each slider\n", n[0], n[1], n[2],
              side, moves);
  std::printf("%-28s %16s   %16s\n", "", "first frame", "settled");
  std::printf("%-28s %6s %6s      %6s %6s\n", "", "p50", "p95", "p50", "p95");
  for (const Field& field : parameterFields())
    if (field.step == Step::Evolve && field.main) measure(window, field, moves);
  return 0;
}
