// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/image/voxel_box.h"
#include "core/image/voxels.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

class TestVoxelBox : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void boxesLieInTheGrid() {
    const Geometry grid = cube(20);
    const VoxelBox inside = boxAround(grid, {10.0, 10.0, 10.0}, {5, 5, 5});
    QVERIFY(inside.low == (Index3{8, 8, 8}) && inside.high == (Index3{12, 12, 12}));
    const VoxelBox corner = boxAround(grid, {0.0, 19.0, 40.0}, {5, 6, 7});
    QVERIFY(corner.low == (Index3{0, 14, 13}) && corner.high == (Index3{4, 19, 19}));
    const VoxelBox all = boxAround(grid, {3.0, 3.0, 3.0}, {99, 99, 99});
    QVERIFY(all.low == (Index3{0, 0, 0}) && all.high == (Index3{19, 19, 19}));
  }

  void boxesAreWidenedAsFarAsTheGridGoes() {
    const Geometry grid = cube(20);
    const VoxelBox box{{3, 8, 16}, {5, 9, 18}};
    const VoxelBox wide = box.widened(4, grid);
    QCOMPARE(wide, (VoxelBox{{0, 4, 12}, {9, 13, 19}}));
    QCOMPARE(box.seenFrom(wide), (VoxelBox{{3, 4, 4}, {5, 5, 6}}));
    QCOMPARE(box.voxelCount(), std::size_t{18});
    QVERIFY(box.holds({3, 9, 18}) && !box.holds({3, 9, 19}) && !box.holds({2, 9, 18}));
  }

  void pointsAreHeldWithTheirReach() {
    Geometry grid = cube(20);
    grid.spacing = {0.5, 1.0, 2.0};
    const auto box = boxOf(grid, {{2.0, 4.0, 8.0}, {3.0, 4.0, 12.0}}, 1.0);
    QCOMPARE(*box, (VoxelBox{{2, 3, 4}, {8, 5, 6}}));
    QVERIFY(!boxOf(grid, {{-2.1, 4.0, 8.0}}, 1.0));
    QVERIFY(!boxOf(grid, {{2.0, 25.0, 8.0}}, 1.0));
    QCOMPARE(*boxOf(grid, {{-2.0, 0.0, 0.0}}, 2.0), (VoxelBox{{0, 0, 0}, {0, 2, 1}}));
  }

  void partsLieWhereTheyLay() {
    const Geometry grid = oblique(9, 8, 7);
    const auto image = sampled(grid, [](const Eigen::Vector3d& x) { return x[0] - 2.0 * x[1]; });
    const VoxelBox box{{2, 1, 3}, {6, 7, 5}};
    const Volume<float> part = cropped(image, box);
    QCOMPARE(part.voxels.size(), box.voxelCount());
    for (std::size_t i = 0; i < part.voxels.size(); ++i) {
      const Index3 p = part.geometry.indexOf(i);
      const Index3 in{p[0] + 2, p[1] + 1, p[2] + 3};
      QCOMPARE(part.voxels[i], image.at(in[0], in[1], in[2]));
      QVERIFY((voxelCentre(part.geometry, p) - voxelCentre(grid, in)).norm() < 1e-9);
    }
  }
};

QTEST_GUILESS_MAIN(TestVoxelBox)
#include "tst_voxel_box.moc"
