// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <set>
#include <utility>

#include "core/mesh/box_tree.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Eigen::AlignedBox3d boxOf(const TriMesh& mesh, std::size_t t, double more) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.points[v]);
  box.min().array() -= more;
  box.max().array() += more;
  return box;
}

Pairs pairsByBoxes(const TriMesh& mesh, double more) {
  Pairs pairs;
  for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a)
    for (std::uint32_t b = a + 1; b < mesh.triangles.size(); ++b)
      if (boxOf(mesh, a, more).intersects(boxOf(mesh, b, more))) pairs.emplace(a, b);
  return pairs;
}

}  // namespace

class TestBoxTree : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Wherever the mesh lies: the pairs whose boxes meet, each once, and hardly any others.
  void findsEachPairOnce() {
    TriMesh mesh = shapes::icosphere(2);
    shapes::append(mesh, shapes::moved(shapes::torus(20, 12, 0.9, 0.3), {0.4, -0.2, 0.5}));
    const Pairs meeting = pairsByBoxes(mesh, 0.0), near = pairsByBoxes(mesh, 1e-5);
    for (const Vector3d& by :
         {Vector3d(0, 0, 0), Vector3d(-400, 300, 1200), Vector3d(3e6, 0, -2e6)}) {
      const TriMesh moved = shapes::moved(mesh, by);
      const BoxTree tree(moved);
      Pairs found;
      std::size_t calls = 0, strange = 0;
      for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf)
        tree.forEachPair(leaf, [&](std::uint32_t a, std::uint32_t b) {
          const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(a, b);
          found.insert(pair);
          ++calls;
          strange += 1 - near.count(pair);
        });
      QCOMPARE(calls, found.size());
      QCOMPARE(strange, std::size_t{0});
      for (const auto& pair : meeting) QVERIFY(found.count(pair) != 0);
    }
  }
};

QTEST_APPLESS_MAIN(TestBoxTree)
#include "tst_box_tree.moc"
