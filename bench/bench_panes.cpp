// SPDX-License-Identifier: BSD-3-Clause
// Frames per second of the panes: each event is followed by the frame that shows it, read back.
#include <vtkRenderWindow.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>
#include <string>

#include "gui/view/open_gl.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

using namespace angiomesh;

namespace {

constexpr int kFrames = 40;

std::shared_ptr<Volume<float>> makeImage(int size) {
  Geometry g;
  g.size = {size, size, size};
  g.spacing = {0.5, 0.5, 0.5};
  auto image = std::make_shared<Volume<float>>(g);
  for (std::size_t p = 0; p < image->voxels.size(); ++p)
    image->voxels[p] = static_cast<float>((p * 7919) % 251);
  return image;
}

/// A torus of about `triangles` triangles.
std::shared_ptr<TriMesh> makeMesh(std::size_t triangles, double sizeMm) {
  const auto around = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles)));
  const auto across = static_cast<std::uint32_t>(triangles / (2 * around));
  auto mesh = std::make_shared<TriMesh>();
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(0.5 * sizeMm);
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double r = sizeMm * (0.3 + 0.1 * std::cos(v));
      mesh->points.emplace_back(
          middle + Eigen::Vector3d(r * std::cos(u), r * std::sin(u), 0.1 * sizeMm * std::sin(v)));
      const auto id = [&](std::uint32_t a, std::uint32_t b) {
        return (a % around) * across + b % across;
      };
      mesh->triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh->triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return mesh;
}

void mouse(QWidget& widget, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
           Qt::MouseButtons held) {
  QMouseEvent event(type, at, widget.mapToGlobal(at), button, held, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}

void wheel(QWidget& widget, int notches, Qt::KeyboardModifiers modifiers) {
  const QPointF at = widget.rect().center();
  QWheelEvent event(at, widget.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                    modifiers, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

/// Rows whose name does not hold this are left out.
std::string only;

/// Of all threads of the program: what a frame costs on a machine that has other work, too.
double processorMs() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Median and slowest of what each of kFrames events and its frame take, and the mean of what the
/// processor does for them.
void measure(const char* what, VtkView& view, const std::function<void(int)>& event) {
  if (std::string(what).find(only) == std::string::npos) return;
  view.grabFramebuffer();
  std::vector<double> milliseconds;
  const double before = processorMs();
  for (int frame = 0; frame < kFrames; ++frame) {
    QElapsedTimer timer;
    timer.start();
    event(frame);
    view.grabFramebuffer();
    milliseconds.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
  }
  const double processor = (processorMs() - before) / kFrames;
  std::sort(milliseconds.begin(), milliseconds.end());
  const double median = milliseconds[milliseconds.size() / 2];
  std::printf("%-34s %8.1f ms %8.1f ms %8.1f ms %8.1f /s\n", what, median, milliseconds.back(),
              processor, 1e3 / median);
}

void drag(const char* what, VtkView& view, Qt::MouseButton button) {
  const QPointF from = view.rect().center();
  mouse(view, QEvent::MouseButtonPress, from, button, button);
  measure(what, view, [&](int frame) {
    mouse(view, QEvent::MouseMove, from + QPointF(5.0 + 2.0 * frame, 3.0 + frame), Qt::NoButton,
          button);
  });
  mouse(view, QEvent::MouseButtonRelease, from, button, Qt::NoButton);
}

void measureSlices(const std::shared_ptr<Volume<float>>& image, double slabMm, int pixels) {
  constexpr std::array<const char*, 3> names{"sagittal", "coronal", "axial"};
  for (int plane = 0; plane < 3; ++plane) {
    const std::string name = names[static_cast<std::size_t>(plane)];
    SliceView view;
    view.resize(pixels, pixels);
    view.setPlane(plane);
    view.setImage(image);
    view.setWindowLimits({0.0, 250.0, 250.0});
    view.show();
    QApplication::processEvents();
    view.setSlice(view.sliceCount() / 3);
    const auto scroll = [&](int) { wheel(view, 1, Qt::NoModifier); };
    measure((name + ", scroll").c_str(), view, scroll);
    drag((name + ", window and level").c_str(), view, Qt::LeftButton);
    drag((name + ", pan").c_str(), view, Qt::MiddleButton);
    drag((name + ", zoom").c_str(), view, Qt::RightButton);
    view.resetView();
    for (const bool turned : {false, true}) {
      PlaneTurn turn;
      if (turned)
        turn = turn.turnedBy(
            (plane + 1) % 3, 0.5,
            planeNormals(image->geometry, turn)[static_cast<std::size_t>((plane + 1) % 3)],
            view.cursor());
      view.setTurn(turn);
      view.setSlice(view.sliceCount() / 3);
      const std::string which = name + (turned ? ", turned" : "");
      if (turned) measure((which + ", scroll").c_str(), view, scroll);
      view.setSlab({SlabMode::Mip, slabMm});
      measure((which + ", slab, scroll").c_str(), view, scroll);
      view.setSlab({});
    }
  }
}

void measureSurface(const std::shared_ptr<Volume<float>>& image, std::size_t triangles,
                    int pixels) {
  SurfaceView view;
  view.resize(pixels, pixels);
  view.setImage(image);
  view.setSurface(makeMesh(triangles, image->geometry.size[0] * image->geometry.spacing[0]));
  view.show();
  QApplication::processEvents();
  const std::array<std::pair<VolumeView, const char*>, 3> views{
      {{VolumeView::None, "3D, surface, turn"},
       {VolumeView::Mip, "3D, surface and MIP, turn"},
       {VolumeView::MrAngio, "3D, surface and shaded, turn"}}};
  for (const auto& [volume, what] : views) {
    view.setVolumeView(volume);
    drag(what, view, Qt::LeftButton);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App options("How many frames a second the panes show");
  int size = 256, pixels = 500;
  double slabMm = 20.0;
  std::size_t triangles = 1000000;
  options.add_option("--size", size, "Voxels along each axis");
  options.add_option("--pixels", pixels, "Of a pane's sides");
  options.add_option("--slab", slabMm, "Thickness, mm");
  options.add_option("--only", only, "A part of the names of the rows wanted");
  options.add_option("--triangles", triangles, "Of the surface");
  CLI11_PARSE(options, argc, argv);
  prepareOpenGl();
  QApplication application(argc, argv);
  const auto image = makeImage(size);
  std::printf("%d^3 voxels of 0.5 mm, slabs of %g mm, %zu triangles, panes of %d x %d pixels\n",
              size, slabMm, triangles, pixels, pixels);
  std::printf("%-34s %11s %11s %11s %10s\n", "", "median", "slowest", "processor", "frames");
  measureSlices(image, slabMm, pixels);
  measureSurface(image, triangles, pixels);
  return 0;
}
