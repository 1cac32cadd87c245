// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "tests/io/external_mesher.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

/// Another program's mesher fills what we write, solids with their rims in common included.
class TestFill : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!isInstalled("gmsh")) QSKIP("gmsh is not installed");
  }

  void aTubeOfThreeSolidsIsFilled_data() {
    QTest::addColumn<bool>("metre");
    QTest::newRow("mm") << false;
    QTest::newRow("m") << true;
  }
  void aTubeOfThreeSolidsIsFilled() {
    QFETCH(bool, metre);
    const Folder folder;
    TriMesh mesh = cappedTube(24, 12, 2.0);
    for (auto& p : mesh.points) p += Eigen::Vector3d(80.1, -42.7, 312.3);
    MeshWriteOptions options;
    options.encoding = MeshEncoding::Ascii;
    options.unit = metre ? LengthUnit::Metre : LengthUnit::Millimetre;
    options.patchNames = {"wall", "inlet", "outlet"};
    writeMesh(mesh, folder / "tube.stl", options);
    QString log;
    QVERIFY2(fillsWithTetrahedra(folder / "tube.stl", log), qPrintable(log));
  }

  void anOpenTubeIsNot() {
    const Folder folder;
    MeshWriteOptions options;
    options.encoding = MeshEncoding::Ascii;
    writeMesh(shapes::openTube(24, 12, 2.0), folder / "tube.stl", options);
    QString log;
    QVERIFY2(!fillsWithTetrahedra(folder / "tube.stl", log), qPrintable(log));
  }
};

QTEST_GUILESS_MAIN(TestFill)
#include "tst_fill.moc"
