// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/distance/mask_distance.h"
#include "core/field/wall_field.h"
#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/wall_step.h"
#include "core/surface/zero_set_mesh.h"
#include "core/topology/mask_contacts.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

namespace {

void fill(Volume<std::uint8_t>& mask, const Index3& low, const Index3& high) {
  for (int k = low[2]; k < high[2]; ++k)
    for (int j = low[1]; j < high[1]; ++j)
      for (int i = low[0]; i < high[0]; ++i) mask.at(i, j, k) = 1;
}

Volume<std::uint8_t> emptyMask() {
  Geometry g;
  g.size = {22, 22, 22};
  return Volume<std::uint8_t>(g);
}

/// Two boxes that share an edge or, `raised`, a corner.
Volume<std::uint8_t> twoBoxes(bool raised) {
  Volume<std::uint8_t> mask = emptyMask();
  fill(mask, {3, 3, 4}, {11, 11, 11});
  fill(mask, {11, 11, raised ? 11 : 4}, {18, 18, raised ? 18 : 11});
  return mask;
}

struct Outcome {
  int components = 0, genus = 0;
  MaskContacts contacts;
  Volume<float> phi;
};

Outcome surfaceOf(const Volume<std::uint8_t>& mask, MaskConnectivity connectivity) {
  Outcome out;
  out.phi = smoothMask(distanceOfMask(mask).phi, {});
  out.contacts = settleContacts(out.phi, mask, connectivity);
  const SplineField field = wallField(out.phi, SplineKind::InterpolatingBspline);
  const ZeroSetMesh mesh =
      meshZeroSet(field, SizingParams{}, SurfaceMethod::AdvancingFront, SurfaceBorder::Cap);
  for (const SurfaceComponent& part : mesh.components) {
    ++out.components;
    out.genus += part.genus();
  }
  return out;
}

}  // namespace

class TestMaskContacts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void boxesAreJoinedAsAsked_data() {
    QTest::addColumn<bool>("raised");
    QTest::addColumn<MaskConnectivity>("connectivity");
    QTest::addColumn<int>("components");
    QTest::newRow("edge, faces") << false << MaskConnectivity::Faces << 2;
    QTest::newRow("edge, edges") << false << MaskConnectivity::Edges << 1;
    QTest::newRow("edge, corners") << false << MaskConnectivity::Corners << 1;
    QTest::newRow("corner, faces") << true << MaskConnectivity::Faces << 2;
    QTest::newRow("corner, edges") << true << MaskConnectivity::Edges << 2;
    QTest::newRow("corner, corners") << true << MaskConnectivity::Corners << 1;
  }
  void boxesAreJoinedAsAsked() {
    QFETCH(bool, raised);
    QFETCH(MaskConnectivity, connectivity);
    QFETCH(int, components);
    const Volume<std::uint8_t> mask = twoBoxes(raised);
    const Outcome out = surfaceOf(mask, connectivity);
    QCOMPARE(out.contacts.left, std::size_t{0});
    QCOMPARE(out.components, components);
    QCOMPARE(out.genus, 0);
  }

  /// Each contact is counted once, and the surface passes between its voxels as asked, whichever
  /// way the edge runs.
  void eachContactIsSettledInItsMiddle() {
    for (const MaskConnectivity connectivity : {MaskConnectivity::Faces, MaskConnectivity::Corners})
      for (int axis = 0; axis < 3; ++axis)
        for (const bool raised : {false, true}) {
          if (raised && axis > 0) continue;
          const Volume<std::uint8_t> straight = twoBoxes(raised);
          Volume<std::uint8_t> mask = emptyMask();
          for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const Index3 p = mask.geometry.indexOf(i);
            const auto at = [&](int a) { return p[static_cast<std::size_t>((a + axis) % 3)]; };
            mask.voxels[i] = straight.at(at(0), at(1), at(2));
          }
          Volume<float> phi = smoothMask(distanceOfMask(mask).phi, {});
          const MaskContacts contacts = settleContacts(phi, mask, connectivity);
          QCOMPARE(contacts.left, std::size_t{0});
          QVERIFY(contacts.joined + contacts.parted <= (raised ? 1U : 7U));
          if (raised && connectivity == MaskConnectivity::Corners)
            QCOMPARE(contacts.joined, std::size_t{1});
          QCOMPARE(connectivity == MaskConnectivity::Faces ? contacts.joined : contacts.parted,
                   std::size_t{0});
          const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
          for (int n = 4; n < (raised ? 5 : 11); ++n) {
            Eigen::Vector3d middle;
            for (int a = 0; a < 3; ++a) middle[(a + axis) % 3] = a < 2 ? 10.5 : raised ? 10.5 : n;
            const double value = field.atIndex(middle).value;
            QVERIFY(connectivity == MaskConnectivity::Faces ? value > 0.029 : value < -0.029);
          }
        }
  }

  /// A square ring whose bars touch by edges alone is a ring, or four bars.
  void aRingOfBars() {
    Volume<std::uint8_t> mask = emptyMask();
    fill(mask, {5, 3, 8}, {16, 5, 11});
    fill(mask, {5, 16, 8}, {16, 18, 11});
    fill(mask, {3, 5, 8}, {5, 16, 11});
    fill(mask, {16, 5, 8}, {18, 16, 11});
    const Outcome ring = surfaceOf(mask, MaskConnectivity::Corners);
    QCOMPARE(ring.components, 1);
    QCOMPARE(ring.genus, 1);
    const Outcome bars = surfaceOf(mask, MaskConnectivity::Faces);
    QCOMPARE(bars.components, 4);
    QCOMPARE(bars.genus, 0);
  }

  void whatTouchesNowhereStaysAsItIs() {
    Volume<std::uint8_t> mask = emptyMask();
    fill(mask, {4, 4, 4}, {12, 9, 15});
    Volume<float> phi = distanceOfMask(mask).phi;
    const Volume<float> before = phi;
    const MaskContacts contacts = settleContacts(phi, mask, MaskConnectivity::Faces);
    QCOMPARE(contacts.joined + contacts.parted, std::size_t{0});
    QVERIFY(phi.voxels == before.voxels);
    QVERIFY(contactText(contacts).empty());
  }

  void theConnectivityIsAParameterOfARun() {
    const Volume<std::uint8_t> mask = twoBoxes(false);
    Volume<float> image(mask.geometry);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) image.voxels[i] = mask.voxels[i];
    Pipeline pipeline(makeSource(std::move(image), "boxes"));
    Parameters params;
    params.segmentation.method = SegmentationMethod::Label;
    for (const char* word : {"corners", "faces"}) {
      setFieldFromText(params, "segmentation.connectivity", word);
      const RunResult run = pipeline.run(params);
      const std::size_t parts = word[0] == 'f' ? 2 : 1;
      QCOMPARE(run.surface->origin.components.size(), parts);
      QCOMPARE(run.surface->components.size(), parts);
    }
  }
};

QTEST_APPLESS_MAIN(TestMaskContacts)
#include "tst_mask_contacts.moc"
