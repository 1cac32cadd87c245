// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "render/surface/ray_caster.h"

using namespace angiomesh;

namespace {

constexpr int kPixels = 48;
constexpr double kEyeMm = -60.0;

/// Values between 0 and 100 without order, and a brighter ball of 5 mm around (20, 14, 11).
std::shared_ptr<const Volume<float>> scene() {
  Geometry g;
  g.size = {37, 29, 23};
  auto image = std::make_shared<Volume<float>>(g);
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const double away = Eigen::Vector3d(i - 20, j - 14, k - 11).norm();
        const auto noise = static_cast<float>((i * 7919 + j * 104729 + k * 1299709) % 101);
        image->at(i, j, k) =
            std::max(noise, 100.0F + 100.0F * static_cast<float>(std::clamp(6.0 - away, 0.0, 1.0)));
      }
  return image;
}

/// Along z from outside, upwards y.
CastView alongZ() {
  CastView view;
  view.eye = {18.0, 14.0, kEyeMm};
  view.forward = {0.0, 0.0, 1.0};
  view.right = {0.3, 0.0, 0.0};
  view.up = {0.0, 0.3, 0.0};
  view.lightAxes = view.eyeAxes = {0.0, 0.0, -1.0};
  view.width = view.height = kPixels;
  return view;
}

std::uint8_t opacityAt(const std::vector<std::uint8_t>& picture, int x, int y) {
  return picture[4 * static_cast<std::size_t>(y * kPixels + x) + 3];
}

/// The pixel through (20, 14) in the middle of the ball's depth.
constexpr int kBallX = 26, kBallY = 24;

VolumeLook litAbove(double value) {
  return {RayKind::Lit, {{value, {1.0, 0.0, 0.0}, 0.0}, {value + 50.0, {1.0, 0.0, 0.0}, 0.9}}};
}

}  // namespace

class TestRayCaster : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void blocksHoldTheRangeOfTheirCells() {
    const auto drawn = drawnVolume(scene());
    QCOMPARE(drawn->blocks, (Index3{5, 4, 3}));
    const auto greatest = *std::max_element(drawn->greatest.begin(), drawn->greatest.end());
    QCOMPARE(greatest, 200.0F);
    // The ball reaches from 14 to 26 along x: not into the last block.
    QCOMPARE(drawn->greatest[4], 100.0F);
    QVERIFY(!drawnVolume(nullptr));
    Geometry flat;
    flat.size = {5, 5, 1};
    QVERIFY(!drawnVolume(std::make_shared<Volume<float>>(flat)));
  }

  void aProjectionIsTheGreatestSampleOfItsRay() {
    const auto image = scene();
    const CastView view = alongZ();
    constexpr double step = 0.7;
    const auto picture = castRays(*drawnVolume(image), projectionLook(0.0, 200.0), view, step);
    int differing = 0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) {
        const Eigen::Vector3d perMm = view.forward +
                                      (2.0 * (x + 0.5) / kPixels - 1.0) * view.right +
                                      (2.0 * (y + 0.5) / kPixels - 1.0) * view.up;
        double best = 0.0;
        for (int n = 0; n < 200; ++n) {
          const Eigen::Vector3d index = view.eye + n * step * perMm;
          bool inside = true;
          for (int a = 0; a < 3; ++a)
            inside = inside && index[a] >= 0.0 &&
                     index[a] <= image->geometry.size[static_cast<std::size_t>(a)] - 1;
          if (inside) best = std::max(best, interpolateLinear(*image, index));
        }
        const double expected = 255.0 * best / 200.0;
        differing += std::abs(opacityAt(picture, x, y) - expected) > 1.5;
      }
    QVERIFY2(differing <= kPixels / 16, qPrintable(QString::number(differing)));  // at the border
  }

  void whatIsInsideIsAShape() {
    Geometry g;
    g.size = {40, 40, 40};
    auto phi = std::make_shared<Volume<float>>(g);
    for (int k = 0; k < 40; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i)
          phi->at(i, j, k) =
              static_cast<float>(Eigen::Vector3d(i - 20, j - 20, k - 20).norm() - 8.0);
    CastView view = alongZ();
    view.eye = {20.0, 20.0, -1e4};
    view.right = {15.0 / 1e4, 0.0, 0.0};
    view.up = {0.0, 15.0 / 1e4, 0.0};
    const auto drawn = drawnVolume(phi);
    const auto picture = castRays(*drawn, lookOf(VolumeView::Inside, *drawn), view, 0.5);
    double area = 0.0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) area += opacityAt(picture, x, y) / 255.0;
    const double pixelMm = 30.0 / kPixels;
    const double radius = std::sqrt(area * pixelMm * pixelMm / M_PI);
    QVERIFY2(std::abs(radius - 8.0) < 0.15, qPrintable(QString::number(radius)));
  }

  void whatIsLitEndsAtSurfaces() {
    const auto drawn = drawnVolume(scene());
    const VolumeLook look = litAbove(120.0);
    const auto at = [&](double endMm) {
      const std::vector<float> depths(kPixels * kPixels, static_cast<float>(endMm));
      return opacityAt(castRays(*drawn, look, alongZ(), 0.25, depths), kBallX, kBallY);
    };
    QCOMPARE(opacityAt(castRays(*drawn, look, alongZ(), 0.25), 2, 2), std::uint8_t(0));
    QVERIFY(opacityAt(castRays(*drawn, look, alongZ(), 0.25), kBallX, kBallY) > 240);
    QCOMPARE(at(-kEyeMm + 3.0), std::uint8_t(0));  // the ball begins at z = 5
    QVERIFY(at(-kEyeMm + 11.0) > 240);
  }

  void whatIsLitIsBrightTowardsTheLight() {
    const auto drawn = drawnVolume(scene());
    CastView view = alongZ();
    const VolumeLook look = litAbove(120.0);
    const auto redAt = [&](const CastView& from) {
      return castRays(*drawn, look, from, 0.25)[4 * (kBallY * kPixels + kBallX)];
    };
    const int lit = redAt(view);
    view.lightAxes = -view.lightAxes;
    const int dark = redAt(view);
    QVERIFY2(lit > 2 * dark && dark > 20, qPrintable(QString("%1 %2").arg(lit).arg(dark)));
  }

  void opacityDoesNotFollowTheStep() {
    Geometry g;
    g.size = {30, 30, 30};
    auto image = std::make_shared<Volume<float>>(g, 10.0F);
    image->at(0, 0, 0) = 0.0F;
    CastView view = alongZ();
    view.eye = {15.0, 15.0, kEyeMm};
    const VolumeLook look{RayKind::Lit, {{0.0, {1, 1, 1}, 0.0}, {20.0, {1, 1, 1}, 0.1}}};
    const auto drawn = drawnVolume(image);
    const int fine = opacityAt(castRays(*drawn, look, view, 0.25), 24, 24);
    const int coarse = opacityAt(castRays(*drawn, look, view, 1.0), 24, 24);
    QVERIFY(fine > 150 && fine < 250);
    QVERIFY(std::abs(fine - coarse) < 8);
  }

  void presetsFollowTheVolume() {
    const auto drawn = drawnVolume(scene());
    const VolumeLook mr = lookOf(VolumeView::MrAngio, *drawn);
    QVERIFY(mr.kind == RayKind::Lit);
    QCOMPARE(mr.transfer.front().value, drawn->vessels[0]);
    QCOMPARE(mr.transfer.front().opacity, 0.0);
    QCOMPARE(lookOf(VolumeView::CtAngio, *drawn).transfer.front().value, 130.0);
    QVERIFY(lookOf(VolumeView::Mip, *drawn).kind == RayKind::Greatest);
  }
};

QTEST_GUILESS_MAIN(TestRayCaster)
#include "tst_ray_caster.moc"
