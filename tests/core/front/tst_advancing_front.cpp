// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "core/base/random.h"
#include "core/front/advancing_front.h"
#include "core/front/border_curves.h"
#include "core/front/fill_loop.h"
#include "core/mesh/mesh_faults.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_shape.h"
#include "core/quality/mesh_quality.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;
using Triangle = AdvancingFront::Triangle;

namespace {

// f = 0, with edges of one length everywhere, or that grow along z.
class AnalyticSurface : public FrontSurface {
 public:
  using Function = std::function<double(const Vector3d&)>;

  AnalyticSurface(Function f, double length, double growth = 0.0)
      : f_(std::move(f)), length_(length), growth_(growth) {}

  [[nodiscard]] FrontPoint at(const Vector3d& point) const {
    Vector3d gradient;
    for (int a = 0; a < 3; ++a) {
      const Vector3d step = 1e-6 * Vector3d::Unit(a);
      gradient[a] = f_(point + step) - f_(point - step);
    }
    return {point, gradient.normalized(), lengthAt(point)};
  }
  [[nodiscard]] double off(const Vector3d& point) const { return std::fabs(f_(point)); }

  [[nodiscard]] bool turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                          FrontPoint& apex) const override {
    const Vector3d u = (b.point - a.point).normalized();
    Vector3d up = a.normal + b.normal;
    up = (up - up.dot(u) * u).normalized();
    const auto place = [&](double turned) -> Vector3d {
      return a.point + wish.along * u +
             wish.height * (std::cos(turned) * up.cross(u) + std::sin(turned) * up);
    };
    double low = -shapes::pi / 3.0, high = shapes::pi / 3.0;
    if (f_(place(low)) >= 0.0 || f_(place(high)) <= 0.0) return false;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (f_(place(middle)) < 0.0 ? low : high) = middle;
    }
    apex = at(place(low));
    return apex.normal.dot(up) > 0.3;
  }
  [[nodiscard]] double lengthAt(const Vector3d& point) const override {
    return length_ + growth_ * point.z();
  }
  [[nodiscard]] double slope() const override { return 0.2; }

 private:
  Function f_;
  double length_, growth_;
};

// A ball that after some triangles every third try finds no corner on.
class StubbornBall : public AnalyticSurface {
 public:
  explicit StubbornBall(double length)
      : AnalyticSurface([](const Vector3d& p) { return p.norm() - 1.0; }, length) {}
  [[nodiscard]] bool turn(const FrontPoint& a, const FrontPoint& b, const ApexWish& wish,
                          FrontPoint& apex) const override {
    return (++tries_ < 60 || tries_ % 3 != 0) && AnalyticSurface::turn(a, b, wish, apex);
  }

 private:
  mutable int tries_ = 0;
};

AnalyticSurface unitBall(double length) {
  return {[](const Vector3d& p) { return p.norm() - 1.0; }, length};
}

Vector3d onBall(double polar, double around) {
  return {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
}

TriMesh meshOf(const AdvancingFront& front) {
  TriMesh mesh;
  for (const FrontPoint& p : front.vertices()) mesh.points.push_back(p.point);
  mesh.triangles = front.triangles();
  return mesh;
}

// A first triangle around the south pole of the ball.
void startAtSouthPole(AdvancingFront& front, const AnalyticSurface& ball, double length) {
  Triangle first{};
  // Seen from outside, from below, the angle about z runs clockwise.
  for (std::size_t k = 0; k < 3; ++k)
    first[k] = front.addVertex(ball.at(onBall(shapes::pi - length / std::sqrt(3.0),
                                              -2.0 * shapes::pi * static_cast<double>(k) / 3)));
  front.startAt(first);
}

std::size_t countOf(const AdvancingFront& front, FaceOrigin origin) {
  return static_cast<std::size_t>(
      std::count(front.origins().begin(), front.origins().end(), origin));
}

// The share of the edges whose flip would enlarge the smaller of the two least angles beside them.
double worthFlipping(const TriMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> opposite;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) opposite[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  std::size_t worth = 0, all = 0;
  for (const auto& [edge, left] : opposite) {
    const auto right = opposite.find({edge.second, edge.first});
    if (right == opposite.end() || edge.first > edge.second) continue;
    const Vector3d &a = mesh.points[edge.first], &b = mesh.points[edge.second],
                   &c = mesh.points[left], &d = mesh.points[right->second];
    ++all;
    const double before = std::max(largestCosine(a, b, c), largestCosine(b, a, d));
    const double after = std::max(largestCosine(a, d, c), largestCosine(d, b, c));
    if (after < before - 1e-6 && opposite.count({left, right->second}) == 0) ++worth;
  }
  return static_cast<double>(worth) / static_cast<double>(all);
}

// The area of a polygon's triangles.
double areaOf(const std::vector<Triangle>& triangles, const std::vector<FrontPoint>& vertices) {
  double sum = 0.0;
  for (const Triangle& t : triangles)
    sum += 0.5 * (vertices[t[1]].point - vertices[t[0]].point)
                     .cross(vertices[t[2]].point - vertices[t[0]].point)
                     .norm();
  return sum;
}

struct Polygon {
  std::vector<FrontPoint> vertices;
  std::vector<std::uint32_t> loop;

  explicit Polygon(const std::vector<Vector3d>& corners) {
    for (const Vector3d& p : corners) {
      loop.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back({p, Vector3d::UnitZ(), 1.0});
    }
  }
  static Polygon regular(int n) {
    std::vector<Vector3d> corners;
    for (int i = 0; i < n; ++i)
      corners.emplace_back(std::cos(2.0 * shapes::pi * i / n), std::sin(2.0 * shapes::pi * i / n),
                           0.0);
    return Polygon(corners);
  }
  [[nodiscard]] std::vector<Triangle> filled(
      const std::function<bool(std::uint32_t, std::uint32_t)>& taken = [](auto, auto) {
        return false;
      }) const {
    return fillLoop(loop, vertices, taken);
  }
};

}  // namespace

class TestAdvancingFront : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // A closed surface that the front knows by its turns alone.
  void goesRoundAnAnalyticSurface_data() {
    QTest::addColumn<bool>("torus");
    QTest::addColumn<double>("length");
    for (const double length : {0.3, 0.2, 0.11})
      QTest::addRow("ball %g", length) << false << length;
    for (const double length : {0.25, 0.12}) QTest::addRow("torus %g", length) << true << length;
  }
  void goesRoundAnAnalyticSurface() {
    QFETCH(bool, torus);
    QFETCH(double, length);
    const double ring = 1.0, tube = 0.45;
    const AnalyticSurface surface(
        [&](const Vector3d& p) {
          return torus ? analytic::torus(p, Vector3d::Zero(), ring, tube) : p.norm() - 1.0;
        },
        length);
    AdvancingFront front(surface);
    if (torus) {
      const auto at = [&](double around, double across) {
        const double r = ring + tube * std::cos(across);
        return surface.at({r * std::cos(around), r * std::sin(around), tube * std::sin(across)});
      };
      const double step = length / (ring + tube);
      front.startAt({front.addVertex(at(0.0, 0.0)), front.addVertex(at(step, 0.0)),
                     front.addVertex(at(0.5 * step, 0.87 * length / tube))});
    } else {
      startAtSouthPole(front, surface, length);
    }
    front.run({});
    QCOMPARE(front.close(), std::size_t{0});
    const TriMesh mesh = meshOf(front);
    const MeshFaults faults = findFaults(mesh, true);
    QVERIFY2(faults.none(), faults.text().c_str());
    const MeshQuality q = measureQuality(mesh);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.components, 1);
    QCOMPARE(q.euler, torus ? 0 : 2);
    QCOMPARE(countOf(front, FaceOrigin::Front), front.triangles().size());
    for (const Vector3d& p : mesh.points) QVERIFY(surface.off(p) < 1e-9);
    QVERIFY2(std::fabs(q.edgeMeanMm / length - 1.0) < 0.08,
             qPrintable(QString::number(q.edgeMeanMm / length)));
    QVERIFY2(q.minAngleMin > 20.0, qPrintable(QString::number(q.minAngleMin)));
    QVERIFY2(q.radiusRatioMean > 0.9, qPrintable(QString::number(q.radiusRatioMean)));
    // Edges are flipped as the front goes on.
    QVERIFY2(worthFlipping(mesh) < 0.005, qPrintable(QString::number(worthFlipping(mesh))));
    const double truth =
        torus ? 2.0 * shapes::pi * shapes::pi * ring * tube * tube : 4.0 / 3.0 * shapes::pi;
    // Inscribed: short by about the mean height of the surface over its triangles.
    const double volume = enclosedVolumeMm3(mesh);
    QVERIFY(volume < truth && volume > truth * (1.0 - 0.4 * length * length / (tube * tube)));
  }

  // Edges that grow from one pole to the other by a factor of seven.
  void edgesGrowAsTheyAreAskedTo() {
    const AnalyticSurface ball([](const Vector3d& p) { return p.norm() - 1.0; }, 0.16, 0.12);
    AdvancingFront front(ball);
    startAtSouthPole(front, ball, 0.04);
    front.run({});
    QCOMPARE(front.close(), std::size_t{0});
    const TriMesh mesh = meshOf(front);
    const MeshQuality q = measureQuality(mesh);
    QVERIFY(q.closed && q.oriented);
    QCOMPARE(q.euler, 2);
    double sum = 0.0;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d &a = mesh.points[t[k]], &b = mesh.points[t[(k + 1) % 3]];
        const double ratio = (b - a).norm() / ball.lengthAt(0.5 * (a + b));
        QVERIFY2(ratio > 0.4 && ratio < 2.2, qPrintable(QString::number(ratio)));
        sum += ratio / static_cast<double>(3 * mesh.triangles.size());
      }
    QVERIFY2(std::fabs(sum - 1.0) < 0.1, qPrintable(QString::number(sum)));
    QVERIFY2(worthFlipping(mesh) < 0.005, qPrintable(QString::number(worthFlipping(mesh))));
  }

  // From a rim that is finer than the wall edges grow no faster than they may, wherever that is.
  void edgesGrowSlowlyFromAFineRim() {
    std::size_t usual = 0;
    for (const Vector3d& centre : {Vector3d(0, 0, 0), Vector3d(40, -30, 60)}) {
      const AnalyticSurface ball([&](const Vector3d& p) { return (p - centre).norm() - 1.0; }, 0.3);
      AdvancingFront front(ball);
      const Vector3d pole = centre - Vector3d::UnitZ();
      Triangle first{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double turn = -2.0 * shapes::pi * static_cast<double>(k) / 3;
        FrontPoint point = ball.at(
            centre +
            (pole - centre + 0.02 * Vector3d(std::cos(turn), std::sin(turn), 0)).normalized());
        point.length = 0.035;
        first[k] = front.addVertex(point);
      }
      front.startAt(first);
      front.run({});
      // Of edges of the wall's length alone there would be fewer.
      const std::size_t count = front.triangles().size();
      if (usual == 0) usual = count;
      QVERIFY(count > 100);
      QVERIFY(isNear(static_cast<double>(count) / static_cast<double>(usual), 1.0, 0.1));
    }
  }

  // Where no new corner can be had edges connect to what is there: nothing is left to be filled.
  void connectsWhereNothingNewIsToBeHad() {
    const StubbornBall ball(0.1);
    AdvancingFront front(ball);
    startAtSouthPole(front, ball, 0.1);
    front.run({});
    QCOMPARE(front.close(), std::size_t{0});
    QCOMPARE(measureQuality(meshOf(front)).euler, 2);
    QCOMPARE(countOf(front, FaceOrigin::Closing), std::size_t{0});
  }

  // Where vertices of finished triangles lie the surface is meshed: no front grows over them.
  // Those of another sheet, whose normals point the other way, are in nobody's way.
  void keepsOffWhatIsMeshed_data() {
    QTest::addColumn<bool>("otherSheet");
    QTest::newRow("same sheet") << false;
    QTest::newRow("other sheet") << true;
  }
  void keepsOffWhatIsMeshed() {
    QFETCH(bool, otherSheet);
    const double length = 0.2;
    const AnalyticSurface ball = unitBall(length);
    AdvancingFront front(ball);
    for (int ring = 0; ring < 5; ++ring)
      for (int i = 0; i < std::max(6 * ring, 1); ++i) {
        FrontPoint p = ball.at(onBall(0.13 * ring, 2.0 * shapes::pi * i / std::max(6 * ring, 1)));
        if (otherSheet) p.normal = -p.normal;
        front.addVertex(p);
      }
    const std::size_t finished = front.vertices().size();
    startAtSouthPole(front, ball, length);
    front.run({});
    double least = 10.0;
    for (std::size_t v = finished; v < front.vertices().size(); ++v)
      for (std::size_t u = 0; u < finished; ++u)
        least = std::min(least, (front.vertices()[v].point - front.vertices()[u].point).norm());
    QVERIFY(front.vertices().size() > finished + 200);
    if (otherSheet) {
      QVERIFY(least < 0.3 * length);
      QCOMPARE(front.close(), std::size_t{0});
      QCOMPARE(measureQuality(meshOf(front)).euler, 2);
    } else {
      QVERIFY2(least >= 0.59 * length, qPrintable(QString::number(least)));
    }
  }

  // From an uneven rim the front starts with poor triangles: their edges are flipped as it goes on.
  void flipsEdgesWhereThatIsBetter() {
    double worth = 0.0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const AnalyticSurface ball = unitBall(0.15);
      AdvancingFront front(ball);
      std::vector<std::uint32_t> loop;
      double around = 0.0;
      for (std::uint64_t i = 0; around < 2.0 * shapes::pi - 0.1; ++i) {
        const double polar = 0.9 + 0.2 * randomUniform(seed, 2 * i);
        loop.push_back(front.addVertex(ball.at(onBall(polar, around))));
        around += 0.05 + 0.4 * randomUniform(seed, 2 * i + 1);
      }
      front.startAlong(loop);
      front.run({});
      const TriMesh mesh = meshOf(front);
      QVERIFY(mesh.triangles.size() > 100);
      worth += worthFlipping(mesh) * 1.5 * static_cast<double>(mesh.triangles.size());
    }
    // A triangle is looked at once, when it is new: a few are left.
    QVERIFY2(worth < 20.0, qPrintable(QString::number(worth)));
  }

  void fillsWhatFrontsLeave() {
    const AnalyticSurface ball = unitBall(0.2);
    AdvancingFront front(ball);
    std::vector<std::uint32_t> loop;
    for (int i = 0; i < 14; ++i)
      loop.push_back(front.addVertex(ball.at(onBall(0.5, 2.0 * shapes::pi * i / 14))));
    front.startAlong(loop);
    QCOMPARE(front.close(), std::size_t{0});
    QCOMPARE(front.triangles().size(), std::size_t{12});
    QCOMPARE(countOf(front, FaceOrigin::Closing), std::size_t{12});
    const TriMesh mesh = meshOf(front);
    const MeshQuality q = measureQuality(mesh);
    QVERIFY(q.oriented);
    QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices, std::size_t{0});
    QCOMPARE(q.boundaryLoops, std::size_t{1});
    QCOMPARE(q.euler, 1);
    // To the left of the loop, seen from outside.
    for (const auto& t : mesh.triangles)
      QVERIFY(
          (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).z() >
          0.0);
    // Nothing is left to fill.
    QCOMPARE(front.close(), std::size_t{0});
    QCOMPARE(front.triangles().size(), std::size_t{12});
  }

  void fillsNothingThatUsesAnEdgeTwice() {
    const AnalyticSurface ball = unitBall(0.2);
    AdvancingFront front(ball);
    std::vector<std::uint32_t> square, all;
    for (int i = 0; i < 4; ++i)
      square.push_back(front.addVertex(ball.at(onBall(0.3, 0.5 * shapes::pi * i))));
    const std::uint32_t south = front.addVertex(ball.at(onBall(0.5, 1.0)));
    front.startAlong(square);
    // Fronts along both diagonals: each loop of three is filled, the square cannot be.
    front.startAlong({square[0], square[2], south});
    front.startAlong({square[1], square[3], south});
    QCOMPARE(front.close(), std::size_t{1});
    QCOMPARE(front.triangles().size(), std::size_t{2});
  }

  // Too long a loop stays open, and is counted; others are filled all the same.
  void countsWhatItCannotFill() {
    const AnalyticSurface ball = unitBall(0.2);
    AdvancingFront front(ball);
    for (const auto& [n, polar] : {std::pair{300, 0.5}, std::pair{8, 2.5}}) {
      std::vector<std::uint32_t> loop;
      for (int i = 0; i < n; ++i)
        loop.push_back(front.addVertex(
            ball.at(onBall(polar, (polar < 1.0 ? 2.0 : -2.0) * shapes::pi * i / n))));
      front.startAlong(loop);
    }
    QCOMPARE(front.close(), std::size_t{1});
    QCOMPARE(front.triangles().size(), std::size_t{6});
  }

  // Of an edge of the volume that passes in and out of vessels, what is inside is the caps',
  // whichever axis it runs along and from whichever end.
  void edgesOfTheVolumeAreCapsWhereTheyAreInside() {
    const Geometry g = analytic::cube(40);
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 4; ++side) {
        Vector3d edge = Vector3d::Zero();
        edge[(axis + 1) % 3] = side % 2 * 39.0;
        edge[(axis + 2) % 3] = side / 2 * 39.0;
        const Vector3d along = Vector3d::Unit(axis);
        const SplineField field = analytic::fieldOf(analytic::sampled(g, [&](const Vector3d& p) {
          double least = 1e9;
          for (const auto& [at, radius] : {std::pair{0.0, 4.3}, std::pair{11.0, 3.4},
                                           std::pair{22.5, 4.8}, std::pair{33.0, 3.1}})
            least = std::min(least, analytic::ball(p, edge + at * along, radius));
          return least;
        }));
        const GuidanceField size(field, SizingParams::printed());
        const BorderCurves curves = borderCurves(field, size, EndPlanes(g), {}, true);
        std::size_t inside = 0;
        for (std::size_t v = 0; v < curves.points.size(); ++v) {
          if (curves.place[v].wall || curves.place[v].planes() != 2) continue;
          ++inside;
          QVERIFY(field.valueAt(curves.points[v].point) < 0.0);
        }
        QVERIFY(inside > 10);
        std::size_t caps = 0;
        for (const auto& loops : curves.caps) caps += loops.size();
        QCOMPARE(caps, std::size_t{9});
      }
  }

  void fillingsCoverTheirPolygon() {
    for (const int n : {3, 4, 5, 12, 100, 256}) {
      const Polygon polygon = Polygon::regular(n);
      const auto filled = polygon.filled();
      QCOMPARE(filled.size(), static_cast<std::size_t>(n - 2));
      const double area = 0.5 * n * std::sin(2.0 * shapes::pi / n);
      QVERIFY(std::fabs(areaOf(filled, polygon.vertices) / area - 1.0) < 1e-9);
    }
    QVERIFY(Polygon::regular(2).filled().empty());
    QVERIFY(Polygon::regular(257).filled().empty());
    // An L, which fillings with a fold would leave.
    const Polygon l({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
    QVERIFY(std::fabs(areaOf(l.filled(), l.vertices) - 5.0) < 1e-12);
  }

  void fillingsTakeTheEvenTrianglesThatTheyMay() {
    // A kite: across its short diagonal both triangles are blunt, along the long one thin.
    const Polygon kite({{-1, 0, 0}, {0, -2, 0}, {1, 0, 0}, {0, 2, 0}});
    const auto usesEdge = [](const std::vector<Triangle>& filled, std::uint32_t a,
                             std::uint32_t b) {
      return std::all_of(filled.begin(), filled.end(), [&](const Triangle& t) {
        return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
      });
    };
    const auto filled = kite.filled();
    QCOMPARE(filled.size(), std::size_t{2});
    QVERIFY(usesEdge(filled, 0, 2));
    const auto other = kite.filled([](std::uint32_t a, std::uint32_t b) {
      return std::min(a, b) == 0 && std::max(a, b) == 2;
    });
    QCOMPARE(other.size(), std::size_t{2});
    QVERIFY(usesEdge(other, 1, 3));
    QVERIFY(kite.filled([](auto, auto) { return true; }).empty());
  }
};

QTEST_GUILESS_MAIN(TestAdvancingFront)
#include "tst_advancing_front.moc"
