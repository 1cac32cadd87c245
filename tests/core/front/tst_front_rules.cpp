// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/front/front_rules.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// The plane z = 0, with edges of one length everywhere.
class Plane : public FrontSurface {
 public:
  explicit Plane(double length = 1.0) : length_(length) {}
  [[nodiscard]] bool turn(const FrontPoint&, const FrontPoint&, const ApexWish&,
                          FrontPoint&) const override {
    return false;
  }
  [[nodiscard]] double lengthAt(const Vector3d&) const override { return length_; }
  [[nodiscard]] double slope() const override { return 0.0; }

 private:
  double length_;  // of edges
};

const double kHigh = std::sqrt(0.75);  // of an equilateral triangle

// A front in the plane, whose first edge, from (0, 0) to (1, 0), is the base; above it nothing is
// meshed.
class Sheet : private Plane, public FrontRules {
 public:
  using FrontRules::addVertex;
  using FrontRules::Class;
  using FrontRules::dropEdge;
  using FrontRules::Edge;
  using FrontRules::halfCornerTangent;
  using FrontRules::legal;
  using FrontRules::meshedAt;
  using FrontRules::none;

  explicit Sheet(double length = 1.0)
      : Plane(length), FrontRules(static_cast<const FrontSurface&>(*this)), length_(length) {
    from = vertex(0.0, 0.0);
    to = vertex(1.0, 0.0);
    base = edge(from, to);
    join(base, base);
  }
  std::uint32_t vertex(double x, double y, const Vector3d& normal = Vector3d::UnitZ(),
                       double z = 0.0) {
    return addVertex({{x, y, z}, normal, length_});
  }
  std::uint32_t edge(std::uint32_t a, std::uint32_t b) { return newEdge(a, b); }
  // Each edge goes on with the next, the last with the first.
  void loop(const std::vector<std::uint32_t>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) join(edges[i], edges[(i + 1) % edges.size()]);
  }
  // An edge of another front and back, with nothing between.
  void sliver(std::uint32_t a, std::uint32_t b) { loop({edge(a, b), edge(b, a)}); }

  void look(double radius = 10.0, bool relaxed = false) {
    const Frame frame = frameOf(edges_[base]);
    collect(frame, frame.origin, radius, length_, relaxed);
  }
  [[nodiscard]] bool clear(double x, double y, double length = 1.0) {
    look();
    return clearAround(edges_[base], {{x, y, 0.0}, Vector3d::UnitZ(), length});
  }
  [[nodiscard]] bool sees(std::uint32_t v) const {
    return std::any_of(near_.begin(), near_.end(), [&](const Near& n) { return n.vertex == v; });
  }
  [[nodiscard]] ApexWish wish() const { return wishFor(frameOf(edges_[base]), base); }
  [[nodiscard]] bool mayHave(std::uint32_t apex, double x, double y, bool relaxed = false) {
    look(10.0, relaxed);
    const Frame frame = frameOf(edges_[base]);
    return legal(frame, base, apex, frame.flat({x, y, 0.0}), relaxed);
  }
  FrontPoint& point(std::uint32_t v) { return vertices_[v]; }
  [[nodiscard]] std::size_t edgesKept() const { return edges_.size(); }

  std::uint32_t from = 0, to = 0, base = 0;

 private:
  double length_;
};

// A zero set in a volume of 33 mm, and the corners that bases along x turn to.
class Turned {
 public:
  explicit Turned(const std::function<double(const Vector3d&)>& phi)
      : field_(analytic::fieldOf(analytic::sampled(analytic::cube(33), phi))),
        size_(field_, SizingParams{}) {}
  // Of a triangle with sides of 16 mm in the plane z = 16 unless said.
  template <class Surface>
  [[nodiscard]] std::optional<FrontPoint> corner(const Vector3d& middle = {16.0, 8.0, 16.0}) const {
    const FrontPoint a{middle - 8.0 * Vector3d::UnitX(), Vector3d::UnitZ(), 16.0};
    const FrontPoint b{middle + 8.0 * Vector3d::UnitX(), Vector3d::UnitZ(), 16.0};
    FrontPoint apex;
    if (!Surface(field_, size_).turn(a, b, {8.0, 16.0 * kHigh}, apex)) return std::nullopt;
    return apex;
  }

 private:
  SplineField field_;
  GuidanceField size_;
};

}  // namespace

class TestFrontRules : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // However phi bends on the way, the corner turns to where it is 0 and keeps its distance.
  void cornersTurnToTheWall() {
    const double high = 16.0 * kHigh;
    for (const double steep : {0.05, 0.5, 1.2})
      for (const double turn : {-1.0, -0.3, 0.1, 0.3, 0.9}) {
        const double wall = 16.0 + high * std::sin(turn);
        const auto apex = Turned([&](const Vector3d& p) {
                            return std::atan(steep * (p.z() - wall));
                          }).corner<WallSurface>();
        QVERIFY(apex.has_value());
        const double off = (apex->point - Vector3d(16.0, 8.0 + high * std::cos(turn), wall)).norm();
        QVERIFY(isBelow(off, 0.05));
        QVERIFY((apex->normal - Vector3d::UnitZ()).norm() < 1e-9);
      }
    // Not by more than 60 degrees.
    for (const double wall : {16.0 - 1.01 * high, 16.0 + 1.01 * high})
      QVERIFY(!Turned([&](const Vector3d& p) { return p.z() - wall; }).corner<WallSurface>());
  }

  // Caps are flat, and end at the wall and at the volume's edges.
  void cornersOfCapsStayInside() {
    const Turned vessel([](const Vector3d& p) { return p.y() - 24.0; });
    const double high = 16.0 * kHigh;
    for (const double y : {8.0, 23.9 - high}) {
      const auto apex = vessel.corner<CapSurface>({16.0, y, 0.0});
      QVERIFY(apex && (apex->point - Vector3d(16.0, y + high, 0.0)).norm() < 1e-12);
    }
    QVERIFY(!vessel.corner<CapSurface>({16.0, 24.1 - high, 0.0}));
    const Turned everywhere([](const Vector3d&) { return -1.0; });
    QVERIFY(everywhere.corner<CapSurface>({16.0, 31.9 - high, 0.0}));
    QVERIFY(!everywhere.corner<CapSurface>({16.0, 32.1 - high, 0.0}));
  }

  // A front takes as much room as it is long, however far it went.
  void edgesThatWentMakeRoomForNewOnes() {
    Sheet sheet;
    const std::uint32_t a = sheet.vertex(2.0, 0.0), b = sheet.vertex(2.0, 1.0);
    const std::size_t kept = sheet.edgesKept() + 2;
    for (int n = 0; n < 10; ++n) {
      const std::uint32_t there = sheet.edge(a, b), back = sheet.edge(b, a);
      sheet.loop({there, back});
      sheet.dropEdge(there);
      sheet.dropEdge(back);
      QCOMPARE(sheet.edgesKept(), kept);
    }
  }

  // What is left beside a free corner must hold triangles without small angles: it keeps about
  // three quarters of an edge from vertices and half of one from edges.
  void aFreeCornerKeepsOffVertices() {
    for (const auto& [gap, clear] : {std::pair{0.65, false}, std::pair{0.8, true}})
      for (const double x : {0.5, 0.4, 0.6}) {
        Sheet sheet;
        const std::uint32_t p = sheet.vertex(x, kHigh + gap);
        sheet.sliver(p, sheet.vertex(x, kHigh + gap + 2.0));
        QCOMPARE(sheet.clear(0.5, kHigh), clear);
      }
  }

  void aFreeCornerKeepsOffEdges() {
    for (const auto& [gap, clear] : {std::pair{0.42, false}, std::pair{0.56, true}}) {
      Sheet sheet;
      sheet.sliver(sheet.vertex(-2.0, kHigh + gap), sheet.vertex(3.0, kHigh + gap));
      QCOMPARE(sheet.clear(0.5, kHigh), clear);
    }
    // The base is no obstacle to a corner that is close to it.
    QVERIFY(Sheet().clear(0.5, 0.3));
  }

  void sidesOfAFreeCornerKeepOffVertices() {
    for (const auto& [gap, clear] : {std::pair{0.38, false}, std::pair{0.5, true}})
      for (const double side : {-1.0, 1.0}) {
        // Beside the lower part of a side, seen from its corner of the base.
        const Vector2d corner(side < 0.0 ? 0.0 : 1.0, 0.0), apex(0.5, kHigh);
        const Vector2d out(side * kHigh, 0.5);
        const Vector2d p = apex + 0.75 * (corner - apex) + gap * out;
        Sheet sheet;
        const Vector2d q = p + 2.0 * out;
        sheet.sliver(sheet.vertex(p.x(), p.y()), sheet.vertex(q.x(), q.y()));
        QCOMPARE(sheet.clear(apex.x(), apex.y()), clear);
      }
  }

  // Distances are shares of the wanted length, or of the side where that is much shorter.
  void clearancesFollowTheLength() {
    const auto clear = [](double gap, double length) {
      Sheet sheet;
      sheet.sliver(sheet.vertex(0.5, kHigh + gap), sheet.vertex(0.5, kHigh + gap + 3.0));
      return sheet.clear(0.5, kHigh, length);
    };
    QVERIFY(clear(0.4, 0.5) && !clear(0.32, 0.5));
    QVERIFY(clear(1.0, 5.0) && !clear(0.85, 5.0));
  }

  void whatIsNearOnTheSheetIsMeshed() {
    Sheet sheet;
    sheet.vertex(5.0, 5.0);
    const auto meshed = [&](double away, double length, const Vector3d& normal) {
      return sheet.meshedAt({{5.0 + away, 5.0, 0.0}, normal.normalized(), length});
    };
    QVERIFY(meshed(0.54, 1.0, {0.0, 0.0, 1.0}) && !meshed(0.66, 1.0, {0.0, 0.0, 1.0}));
    QVERIFY(meshed(0.54 * 2.0, 2.0, {0.0, 0.0, 1.0}));
    QVERIFY(!meshed(0.66 * 0.5, 0.5, {0.0, 0.0, 1.0}));
    // Another sheet's normal.
    QVERIFY(meshed(0.3, 1.0, {1.0, 0.0, 0.4}) && !meshed(0.3, 1.0, {1.0, 0.0, 0.05}));
    QVERIFY(!meshed(0.3, 1.0, {0.0, 0.0, -1.0}));
  }

  void otherSheetsAreNotSeen() {
    const auto seen = [](double cosine, double slope, bool relaxed) {
      Sheet sheet;
      const Vector3d normal(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      // In the middle of the base's other side, at an angle to its plane.
      const std::uint32_t p = sheet.vertex(0.5, std::sqrt(1.0 - slope * slope), normal, slope);
      sheet.sliver(p, sheet.vertex(0.5, 3.0));
      sheet.look(10.0, relaxed);
      return sheet.sees(p);
    };
    QVERIFY(seen(0.3, 0.0, false) && !seen(0.1, 0.0, false));
    QVERIFY(seen(0.0, 0.0, true) && !seen(-0.2, 0.0, true));
    QVERIFY(seen(1.0, 0.65, false) && !seen(1.0, 0.75, false));
    QVERIFY(seen(1.0, -0.65, false) && !seen(1.0, -0.75, false));
    QVERIFY(seen(1.0, 0.98, true));
  }

  void cornersAreMeasuredWhereNothingIsMeshed() {
    for (int degrees = 5; degrees < 360; degrees += 5) {
      Sheet sheet;
      const double angle = degrees * M_PI / 180.0;
      const std::uint32_t in =
          sheet.edge(sheet.vertex(std::cos(angle), std::sin(angle)), sheet.from);
      const double tangent = sheet.halfCornerTangent(in, sheet.base);
      QVERIFY(std::fabs(std::sin(0.5 * angle) - std::cos(0.5 * angle) * tangent) <
              1e-9 * std::max(1.0, std::fabs(tangent)));
    }
  }

  // Along a straight front corners are wished for at equilateral triangles.
  void wishesForEvenTriangles() {
    Sheet sheet;
    sheet.loop({sheet.base, sheet.edge(sheet.to, sheet.vertex(2.0, 0.0)),
                sheet.edge(sheet.vertex(-1.0, 0.0), sheet.from)});
    const ApexWish wish = sheet.wish();
    QVERIFY(std::fabs(wish.along - 0.5) < 1e-12 && std::fabs(wish.height - kHigh) < 1e-12);
    // Two triangles share a corner of the front evenly: half-way between that and equal sides.
    for (const double corner : {1.6, 2.0, 2.4, 2.6}) {
      Sheet bent;
      bent.loop({bent.base, bent.edge(bent.to, bent.vertex(2.0, 0.0)),
                 bent.edge(bent.vertex(std::cos(corner), std::sin(corner)), bent.from)});
      const double ta = std::tan(0.5 * corner), tb = std::sqrt(3.0);
      const ApexWish shared = bent.wish();
      QVERIFY(std::fabs(shared.along - 0.5 * (0.5 + tb / (ta + tb))) < 1e-12);
      const double height = std::clamp(ta * tb / (ta + tb), 0.7 * kHigh, 1.3 * kHigh);
      QVERIFY(std::fabs(shared.height - 0.5 * (kHigh + height)) < 1e-12);
    }
    // Too narrow, or too wide, a corner is not shared.
    for (const double corner : {1.4, 2.8}) {
      Sheet bent;
      bent.loop({bent.base, bent.edge(bent.to, bent.vertex(2.0, 0.0)),
                 bent.edge(bent.vertex(std::cos(corner), std::sin(corner)), bent.from)});
      QVERIFY(std::fabs(bent.wish().along - 0.5) < 1e-12);
      QVERIFY(std::fabs(bent.wish().height - kHigh) < 1e-12);
    }
  }

  // Sides get the length that is wanted where they end, within bounds that keep triangles whole.
  void wishesForTheWantedLengths() {
    const auto wished = [](double length) {
      Sheet sheet(length);
      sheet.loop({sheet.base, sheet.edge(sheet.to, sheet.vertex(2.0, 0.0)),
                  sheet.edge(sheet.vertex(-1.0, 0.0), sheet.from)});
      return sheet.wish();
    };
    for (const double length : {0.8, 1.2, 1.5}) {
      const double high = std::sqrt(length * length - 0.25);
      const ApexWish wish = wished(length);
      QVERIFY(std::fabs(wish.along - 0.5) < 1e-12);
      const double even = std::clamp(kHigh, 0.7 * high, 1.3 * high);
      QVERIFY(std::fabs(wish.height - 0.5 * (high + even)) < 1e-12);
    }
    QVERIFY(std::fabs(wished(30.0).height - wished(1.6).height) < 1e-12);
    QVERIFY(std::fabs(wished(0.01).height - wished(0.625).height) < 1e-12);
    // Of unequal ends the corner goes to the shorter side.
    Sheet uneven;
    uneven.point(uneven.from).length = 0.9;
    uneven.point(uneven.to).length = 1.1;
    uneven.loop({uneven.base, uneven.edge(uneven.to, uneven.vertex(2.0, 0.0)),
                 uneven.edge(uneven.vertex(-1.0, 0.0), uneven.from)});
    const ApexWish wish = uneven.wish();
    QVERIFY(wish.along < 0.5 - 0.01);
    QVERIFY(wish.along > 0.25);
  }

  void triangulationsNeitherCrossNorTurnOver() {
    // Beside a front that runs down to the base's end: the corner must stay on its open side.
    Sheet sheet;
    const std::uint32_t before = sheet.vertex(0.2, 1.0), after = sheet.vertex(0.8, 1.0);
    sheet.loop({sheet.base, sheet.edge(sheet.to, after), sheet.edge(after, before),
                sheet.edge(before, sheet.from)});
    QVERIFY(sheet.mayHave(sheet.none, 0.5, 0.5));
    QVERIFY(!sheet.mayHave(sheet.none, 0.5, -0.5));
    QVERIFY(!sheet.mayHave(sheet.none, 0.05, 0.5));  // beyond the edge before
    QVERIFY(!sheet.mayHave(sheet.none, 0.95, 0.5));  // beyond the edge after
    QVERIFY(!sheet.mayHave(sheet.none, 0.5, 1.5));   // across the opposite edge
    QVERIFY(sheet.mayHave(before, 0.2, 1.0) && sheet.mayHave(after, 0.8, 1.0));
    // A triangle that another vertex lies in.
    Sheet around;
    around.sliver(around.vertex(0.5, 0.4), around.vertex(0.5, 3.0));
    QVERIFY(!around.mayHave(around.none, 0.5, 0.9));
    QVERIFY(around.mayHave(around.none, 0.5, 0.3));
    // A corner of the front whose normal the triangle would turn away from.
    for (const auto& [cosine, strict, relaxed] :
         {std::tuple{0.5, true, true}, std::tuple{0.1, false, true}}) {
      Sheet steep;
      const Vector3d normal(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      const std::uint32_t apex = steep.vertex(0.5, 0.9, normal);
      steep.sliver(apex, steep.vertex(0.5, 3.0));
      QCOMPARE(steep.mayHave(apex, 0.5, 0.9), strict);
      QCOMPARE(steep.mayHave(apex, 0.5, 0.9, true), relaxed);
    }
  }
};

QTEST_GUILESS_MAIN(TestFrontRules)
#include "tst_front_rules.moc"
