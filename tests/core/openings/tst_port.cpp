// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/openings/held_planes.h"
#include "core/openings/port.h"
#include "tests/core/mesh_shapes.h"

using namespace angiomesh;

namespace {

// A cube far from the origin whose sides x = 0 and x = 1 are the patches 1 and 2.
TriMesh boxWithPorts() {
  TriMesh mesh = shapes::moved(shapes::cube(), {120.0, -80.0, 700.0});
  mesh.patch.assign(12, 0);
  mesh.patch[8] = mesh.patch[9] = 1;
  mesh.patch[10] = mesh.patch[11] = 2;
  return mesh;
}

std::vector<Port> named(std::vector<Port> ports) {
  for (std::size_t n = 0; n < ports.size(); ++n) ports[n].name = "p" + std::to_string(n + 1);
  return ports;
}

}  // namespace

class TestPort : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void measuresAreThoseOfTheSides() {
    const std::vector<Port> ports = measurePatches(boxWithPorts(), 3);
    QCOMPARE(ports.size(), std::size_t{3});
    for (const std::size_t n : {0, 1}) {
      const double side = n == 0 ? 0.0 : 1.0;
      QVERIFY(std::abs(ports[n].areaMm2 - 1.0) < 1e-12);
      QVERIFY((ports[n].centreLps - Eigen::Vector3d(120.0 + side, -79.5, 700.5)).norm() < 1e-12);
      QVERIFY((ports[n].normalLps - Eigen::Vector3d(2.0 * side - 1.0, 0, 0)).norm() < 1e-12);
      QVERIFY(std::abs(ports[n].equivalentDiameterMm() - 2.0 / std::sqrt(shapes::pi)) < 1e-12);
    }
    QCOMPARE(ports[2].areaMm2, 0.0);
  }

  // A box of one voxel in a grid: its sides in the outermost planes are caps, and its corners stay
  // in them, whatever the axes' directions are.
  void sidesInBordersAreHeld() {
    for (const bool mirrored : {false, true})
      for (int grid = 0; grid < 8; ++grid) {
        Index3 size{};
        for (std::size_t a = 0; a < 3; ++a) size[a] = (grid >> a & 1) != 0 ? 3 : 2;
        const Geometry g = shapes::obliqueGeometry(size, mirrored);
        TriMesh mesh = shapes::cube();
        for (Eigen::Vector3d& p : mesh.points) p = g.toPhysical(p);
        const HeldPlanes held(mesh, &g, {});
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
          const auto& [a, b, c] = mesh.triangles[t];
          // Bit a of a corner's number: x, y, z = 1.
          const unsigned low = ~(a | b | c) & 7U, high = a & b & c;
          bool border = low != 0;
          for (unsigned axis = 0; axis < 3; ++axis)
            border = border || ((high >> axis & 1U) != 0 && size[axis] == 2);
          QCOMPARE(held.isCap(t), border);
        }
        for (std::uint32_t v = 0; v < 8; ++v) {
          int planes = 0;
          for (unsigned axis = 0; axis < 3; ++axis)
            planes += (v >> axis & 1U) == 0 || size[axis] == 2 ? 1 : 0;
          QCOMPARE(held.count(v), std::min(planes, 2));
        }
        const HeldPlanes free(mesh, nullptr, {});
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) QVERIFY(!free.isCap(t));
      }
  }

  void aPortOpensInItsPlaneAlone() {
    Port port;
    port.centreLps = {120.0, -80.0, 700.0};
    port.normalLps = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
    port.areaMm2 = shapes::pi;
    const Eigen::Vector3d aside = port.normalLps.unitOrthogonal();
    QVERIFY(port.opensAt(port.centreLps + aside));
    QVERIFY(!port.opensAt(port.centreLps + 7.0 * aside));
    for (const double off : {-3.0, -0.5, -0.01, 0.01, 0.5, 3.0})
      QVERIFY(!port.opensAt(port.centreLps + aside + off * port.normalLps));
  }

  void aPortThatIsAnotherIsFound() {
    const TriMesh mesh = boxWithPorts();
    const std::vector<Port> ports = named(measurePatches(mesh, 2));
    QVERIFY(portFaults(ports, mesh).empty());

    TriMesh swapped = mesh;
    for (auto& patch : swapped.patch)
      patch = patch == 0 ? 0 : static_cast<std::uint16_t>(3 - patch);
    QCOMPARE(portFaults(ports, swapped).size(), std::size_t{2});

    TriMesh half = mesh;
    half.patch[8] = 0;
    const std::vector<std::string> faults = portFaults(ports, half);
    QCOMPARE(faults.size(), std::size_t{1});
    QVERIFY(faults[0].find("'p1' has an area of 0.5 mm2") != std::string::npos);

    TriMesh none = mesh;
    none.patch.assign(12, 0);
    QCOMPARE(portFaults(ports, none).size(), std::size_t{2});
    none.patch.clear();
    QCOMPARE(portFaults(ports, none).size(), std::size_t{2});

    TriMesh tilted = mesh;
    tilted.points = shapes::moved(shapes::cube(), {120.0, -80.0, 700.0}).points;
    for (auto& p : tilted.points) p.x() += 0.05 * (p.z() - 700.5);
    QCOMPARE(portFaults(ports, tilted).size(), std::size_t{2});
  }
};

QTEST_APPLESS_MAIN(TestPort)
#include "tst_port.moc"
