// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/io/io_test.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

double signedVolume(const TriMesh& mesh) {
  double six = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.points[t[0]];
    const Eigen::Vector3d& b = mesh.points[t[1]];
    const Eigen::Vector3d& c = mesh.points[t[2]];
    six += a.x() * (b.y() * c.z() - b.z() * c.y()) - a.y() * (b.x() * c.z() - b.z() * c.x()) +
           a.z() * (b.x() * c.y() - b.y() * c.x());
  }
  return six / 6.0;
}

}  // namespace

class TestMeshIo : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTestMeshPointsOutward() { QVERIFY(signedVolume(octahedron()) > 10.0); }

  void framesDifferByTheTwoSigns() {
    const Folder folder;
    const TriMesh mesh = octahedron();
    writeMesh(mesh, folder / "m.obj", {LengthUnit::Millimetre, Frame::Ras, {}});
    std::string text = bytesOf(folder / "m.obj");
    text.replace(text.find("SPACE=RAS"), 9, "SPACE=LPS");
    save(folder / "lps.obj", text);
    const TriMesh asLps = readMesh(folder / "lps.obj");
    const Eigen::Vector3d p = mesh.points[0];
    QCOMPARE(asLps.points[0], Eigen::Vector3d(-p.x(), -p.y(), p.z()));
    QVERIFY(signedVolume(asLps) > 0.0);
  }

  void stlIsWhatTheFormatAsksFor() {
    const Folder folder;
    const TriMesh mesh = octahedron();
    writeMesh(mesh, folder / "m.stl", {LengthUnit::Metre, Frame::Lps, std::string(200, 'k')});
    const std::string bytes = bytesOf(folder / "m.stl");
    QCOMPARE(bytes.size(), 84 + 50 * mesh.triangles.size());
    QVERIFY(!bytes.starts_with("solid"));
    QVERIFY(bytes.substr(0, 80).find("UNIT=m ") != std::string::npos);
    // The normals point outward, away from the centre of the octahedron.
    float first[12];
    std::memcpy(first, bytes.data() + 84, sizeof(first));
    const Eigen::Vector3f normal(first[0], first[1], first[2]);
    const Eigen::Vector3f corner(first[3], first[4], first[5]);
    QVERIFY(std::fabs(normal.norm() - 1.0F) < 1e-5F);
    QVERIFY(normal.dot(corner - Eigen::Vector3f(0.0101F, -0.0203F, 0.0007F)) > 0.0F);
  }

  void theFirstWordOfAnStlFileDoesNotDecide() {
    const Folder folder;
    writeMesh(octahedron(), folder / "m.stl");
    std::string bytes = bytesOf(folder / "m.stl");
    bytes.replace(0, 9, "solid abc");
    save(folder / "m.stl", bytes);
    QCOMPARE(readMesh(folder / "m.stl").triangles.size(), std::size_t{8});
  }

  void asciiStlIsRead() {
    const Folder folder;
    std::string text = "solid test\n";
    const TriMesh mesh = octahedron();
    for (const auto& t : mesh.triangles) {
      text += "facet normal 0 0 0\r\n outer loop\r\n";
      for (const auto corner : t) {
        const Eigen::Vector3d& p = mesh.points[corner];
        text += QString("  vertex %1 %2 +%3\r\n")
                    .arg(p.x(), 0, 'e', 17)
                    .arg(p.y(), 0, 'e', 17)
                    .arg(p.z() + 100.0, 0, 'e', 17)
                    .toStdString();
      }
      text += " endloop\nendfacet\n";
    }
    save(folder / "m.stl", text + "endsolid test\n");
    const TriMesh back = readMesh(folder / "m.stl");
    QCOMPARE(back.points.size(), std::size_t{6});
    QCOMPARE(back.triangles.size(), std::size_t{8});
    QVERIFY(std::fabs(signedVolume(back) / signedVolume(mesh) - 1.0) < 1e-9);
    save(folder / "cut.stl", text);
    QVERIFY_THROWS_EXCEPTION(IoError, readMesh(folder / "cut.stl"));
  }

  void plyOfAnyEncodingIsRead() {
    const Folder folder;
    const float points[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::string ascii = plyHeader("ascii", 4, 1);
    std::string big = plyHeader("binary_big_endian", 4, 1);
    const auto swapped = [&](auto value) {
      std::string raw;
      append(raw, value);
      std::reverse(raw.begin(), raw.end());
      big += raw;
    };
    for (const auto& p : points) {
      for (const float x : p) {
        ascii += std::to_string(x) + " ";
        swapped(x);
      }
      ascii += "255\n";
      big += '\xff';
    }
    ascii += "4 0 1 2 3\n";
    big += '\x04';
    for (const std::int32_t corner : {0, 1, 2, 3}) swapped(corner);
    save(folder / "a.ply", ascii);
    save(folder / "b.ply", big);
    for (const char* name : {"a.ply", "b.ply"}) {
      const TriMesh mesh = readMesh(folder / name);
      QCOMPARE(mesh.points.size(), std::size_t{4});
      QCOMPARE(mesh.triangles.size(), std::size_t{2});
      QVERIFY((mesh.points[2] - Eigen::Vector3d(1, 1, 0)).norm() < 1e-6);
    }
  }

  void polygonsAreCutAlongTheirInside() {
    // An arrow head whose corner 3 points inward: a fan from corner 0 would leave the polygon.
    const Folder folder;
    save(folder / "m.obj",
         "v 0 0 0\nv 4 -3 0\nv 1 0 0\nv 4 3 0\nvt 0 0\nvn 0 0 1\nf 2/1/1 3/1/1 4/1/1 1/1/1\n");
    const TriMesh mesh = readMesh(folder / "m.obj");
    QCOMPARE(mesh.triangles.size(), std::size_t{2});
    double area = 0.0;
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d a = mesh.points[t[1]] - mesh.points[t[0]];
      const Eigen::Vector3d b = mesh.points[t[2]] - mesh.points[t[0]];
      const double z = a.x() * b.y() - a.y() * b.x();
      QVERIFY(z > 0.0);
      area += z / 2.0;
    }
    QVERIFY(std::fabs(area - 3.0) < 1e-9);
  }

  void legacyVtkWithStripsIsRead() {
    const Folder folder;
    save(folder / "m.vtk",
         "# vtk DataFile Version 3.0\n3D Slicer output. SPACE=RAS\nASCII\nDATASET POLYDATA\n"
         "POINTS 5 double\n0 0 0 1 0 0 0 1 0 1 1 0 0 2 0\n"
         "POLYGONS 1 4\n3 2 3 4\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
    const TriMesh mesh = readMesh(folder / "m.vtk");
    QCOMPARE(mesh.points[1], Eigen::Vector3d(-1, 0, 0));
    QCOMPARE(mesh.triangles.size(), std::size_t{3});
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d a = mesh.points[t[1]] - mesh.points[t[0]];
      const Eigen::Vector3d b = mesh.points[t[2]] - mesh.points[t[0]];
      QCOMPARE(a.x() * b.y() - a.y() * b.x(), 1.0);
    }
  }

  void legacyVtkOfAnyKindIsRead() {
    const Folder folder;
    std::string binary =
        "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nFIELD FieldData 1\n"
        "TIME 1 2 double\n" +
        std::string(16, '\0') + "\nPOINTS 3 float\n";
    const auto swapped = [&](auto value) {
      std::string raw;
      append(raw, value);
      std::reverse(raw.begin(), raw.end());
      binary += raw;
    };
    for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) swapped(x);
    binary += "\nLINES 1 3\n";
    for (const std::int32_t i : {2, 0, 1}) swapped(i);
    binary += "\nPOLYGONS 1 4\n";
    for (const std::int32_t i : {3, 0, 1, 2}) swapped(i);
    binary += "\nPOINT_DATA 3\nanything";
    save(folder / "binary.vtk", binary);
    save(folder / "five.vtk",
         "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
         "0 0 0 1 0 0 0 1 0\nMETADATA\nINFORMATION 0\n\nPOLYGONS 2 3\n"
         "OFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n");
    for (const char* name : {"binary.vtk", "five.vtk"}) {
      const TriMesh mesh = readMesh(folder / name);
      QCOMPARE(mesh.points.size(), std::size_t{3});
      QCOMPARE(mesh.points[2], Eigen::Vector3d(0, 1, 0));
      QCOMPARE(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
    }
  }

  void onlyThePipelinesKeyIsTakenForOne() {
    const Folder folder;
    for (const std::string key :
         {"0123456789abcdef", "Doe", "19700101", "0123456789ABCDEF", "0123456789abcdef0"}) {
      save(folder / "m.obj", "# KEY=" + key + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
      QCOMPARE(loadMesh(folder / "m.obj").key, key == "0123456789abcdef" ? key : std::string());
    }
  }

  void solidsOfAnyNameAreRead() {
    const Folder folder;
    const auto facet = [](int z) {
      return QString(
                 "facet normal 0 0 1\nouter loop\nvertex 0 0 %1\nvertex 1 0 %1\n"
                 "vertex 0 1 %1\nendloop\nendfacet\n")
          .arg(z)
          .toStdString();
    };
    save(folder / "m.stl", "solid wall UNIT=m\n" + facet(0) + facet(1) +
                               "endsolid wall\nsolid facet vertex\n" + facet(2) +
                               "endsolid facet vertex\nsolid\n" + facet(3) +
                               "endsolid\nsolid empty\nendsolid empty\n");
    const LoadedMesh mesh = loadMesh(folder / "m.stl");
    QCOMPARE(mesh.mesh.triangles.size(), std::size_t{4});
    QCOMPARE(mesh.mesh.points[1].x(), 1000.0);
    QCOMPARE(mesh.patchNames,
             (std::vector<std::string>{"wall", "facet_vertex", "patch_2", "empty"}));
    QCOMPARE(mesh.mesh.patch, (std::vector<std::uint16_t>{0, 0, 1, 2}));
  }

  void theUserKnowsFrameAndUnitBetter() {
    const Folder folder;
    const std::string triangle = "v 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 3\n";
    save(folder / "none.obj", triangle);
    save(folder / "lps.obj", "# COLORSPACE=sRGB SPACE=LPS, UNIT=mm\n" + triangle);
    const LoadedMesh plain = loadMesh(folder / "none.obj");
    QVERIFY(!plain.frameStated && !plain.unitStated && plain.warnings.empty());
    QCOMPARE(plain.mesh.points[0], Eigen::Vector3d(1, 2, 3));
    for (const char* name : {"none.obj", "lps.obj"}) {
      const LoadedMesh told = loadMesh(folder / name, {Frame::Ras, LengthUnit::Metre});
      QCOMPARE(told.mesh.points[0], Eigen::Vector3d(-1000, -2000, 3000));
      QVERIFY(told.frame == Frame::Ras && told.unit == LengthUnit::Metre);
    }
    QCOMPARE(loadMesh(folder / "none.obj", {Frame::Ras, {}}).warnings.size(), std::size_t{0});
    QCOMPARE(loadMesh(folder / "lps.obj", {Frame::Ras, {}}).warnings.size(), std::size_t{1});
    QCOMPARE(loadMesh(folder / "lps.obj", {Frame::Lps, {}}).warnings.size(), std::size_t{0});

    save(folder / "unknown.obj", "# SPACE=LAS UNIT=cm\n" + triangle);
    QCOMPARE(loadMesh(folder / "unknown.obj").warnings.size(), std::size_t{2});
    save(folder / "both.obj", "# SPACE=LPS\n# SPACE=RAS\n" + triangle);
    QVERIFY_THROWS_EXCEPTION(InputError, readMesh(folder / "both.obj"));
    QCOMPARE(loadMesh(folder / "both.obj", {Frame::Lps, {}}).mesh.points[0],
             Eigen::Vector3d(1, 2, 3));
  }

  void largePolygonsAreCutInTime() {
    const Folder folder;
    std::string text;
    constexpr int kCorners = 2000;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * M_PI * i / kCorners;
      const double radius = 10.0 + (i % 2);
      text += QString("v %1 %2 0\n")
                  .arg(radius * std::cos(angle))
                  .arg(radius * std::sin(angle))
                  .toStdString();
    }
    text += "f";
    for (int i = 1; i <= kCorners; ++i) text += " " + std::to_string(i);
    save(folder / "m.obj", text + "\n");
    QCOMPARE(readMesh(folder / "m.obj").triangles.size(), std::size_t{kCorners - 2});
  }

  void vtpOfAnyKindIsRead_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<int>("packer");
    QTest::addColumn<bool>("wide");
    QTest::addColumn<bool>("big");
    QTest::addColumn<bool>("base64");
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
      for (const int packer :
           {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA})
        for (const bool wide : {false, true})
          for (const bool big : {false, true})
            for (const bool base64 : {false, true})
              QTest::addRow("mode %d packer %d%s%s%s", mode, packer, wide ? " wide" : "",
                            big ? " big" : "", base64 ? " base64" : "")
                  << mode << packer << wide << big << base64;
  }
  void vtpOfAnyKindIsRead() {
    QFETCH(int, mode);
    QFETCH(int, packer);
    QFETCH(bool, wide);
    QFETCH(bool, big);
    QFETCH(bool, base64);
    const Folder folder;
    const std::string path = (folder / "m.vtp").string();
    const TriMesh mesh = randomMesh(3);
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& p : mesh.points) points->InsertNextPoint(p.data());
    vtkNew<vtkCellArray> polygons, strips, lines;
    for (std::size_t i = 1; i < mesh.triangles.size(); ++i) {
      polygons->InsertNextCell(3);
      for (const std::uint32_t corner : mesh.triangles[i]) polygons->InsertCellPoint(corner);
    }
    strips->InsertNextCell(3);
    lines->InsertNextCell(2);
    for (const std::uint32_t corner : mesh.triangles[0]) strips->InsertCellPoint(corner);
    for (const vtkIdType end : {0, 1}) lines->InsertCellPoint(end);
    data->SetPoints(points);
    data->SetPolys(polygons);
    data->SetStrips(strips);
    data->SetLines(lines);
    vtkNew<vtkStringArray> space;
    space->SetName("SPACE");
    space->InsertNextValue("RAS");
    data->GetFieldData()->AddArray(space);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(path.c_str());
    writer->SetDataMode(mode);
    writer->SetCompressorType(packer);
    writer->SetHeaderType(wide ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
    writer->SetByteOrder(big ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
    writer->SetEncodeAppendedData(base64);
    QCOMPARE(writer->Write(), 1);

    const LoadedMesh back = loadMesh(path, {Frame::Lps, {}});
    QVERIFY(back.frameStated && back.warnings.size() == 1);
    QCOMPARE(back.mesh.points.size(), mesh.points.size());
    TriMesh turned = mesh;  // the strip comes last
    std::rotate(turned.triangles.begin(), turned.triangles.begin() + 1, turned.triangles.end());
    QVERIFY(largestDifference(turned, back.mesh) < (mode == vtkXMLWriter::Ascii ? 1e-7 : 1e-300));
  }

  void piecesOfAVtpAreJoined() {
    const Folder folder;
    const std::string piece =
        "<Piece NumberOfPoints='3' NumberOfPolys = \"1\"><!-- <Piece> --><Points><DataArray "
        "type='Float32' NumberOfComponents='3' format='ascii'>0 0 0\n1 0 0 0 1 0"
        "<InformationKey name='a'><Value index='0'>7</Value></InformationKey></DataArray></Points>"
        "<Polys><DataArray type='UInt8' Name='offsets'>3</DataArray><DataArray type='Int32' "
        "Name='connectivity'>0 1 2</DataArray></Polys></Piece>";
    save(folder / "m.vtp", "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='0'/>" +
                               piece + piece + "</PolyData></VTKFile>");
    MeshReadOptions keep;
    keep.keepPoints = true;
    const TriMesh mesh = loadMesh(folder / "m.vtp", keep).mesh;
    QCOMPARE(mesh.points.size(), std::size_t{6});
    QCOMPARE(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 4, 5}}));
  }

  void aRealSurfaceLiesOnItsVesselsWall() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const fs::path folder = fs::path(data.toStdString()) / "avf-mra";
    const Volume<float> image = readImage(folder / "avf_float_32.nrrd").image;
    const std::vector<double> range = percentiles(image, {0.5, 0.999});
    // How much brighter it is one voxel within the surface than one outside.
    const auto drop = [&](const TriMesh& mesh) {
      const double step = image.geometry.voxelMm();
      double sum = 0.0;
      for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d &a = mesh.points[t[0]], &b = mesh.points[t[1]],
                              &c = mesh.points[t[2]];
        const Eigen::Vector3d out = step * (b - a).cross(c - a).normalized();
        const auto at = [&](const Eigen::Vector3d& x) {
          return interpolateLinear(image, image.geometry.toIndex(x));
        };
        sum += at((a + b + c) / 3.0 - out) - at((a + b + c) / 3.0 + out);
      }
      return sum / static_cast<double>(mesh.triangles.size()) / (range[1] - range[0]);
    };
    const double ras = drop(loadMesh(folder / "avf.vtk", {Frame::Ras, {}}).mesh);
    const double lps = drop(loadMesh(folder / "avf.vtk", {Frame::Lps, {}}).mesh);
    QVERIFY2(ras > 0.2 && lps < 0.02, qPrintable(QString("%1 %2").arg(ras).arg(lps)));
  }

  void aRealSurfaceIsRead() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const TriMesh mesh = readMesh(fs::path(data.toStdString()) / "avf-mra/avf.vtk");
    QVERIFY(mesh.triangles.size() > 1000);
    QVERIFY(std::fabs(signedVolume(mesh)) > 1.0);
    // The file does not say that it is in RAS.
    const LoadedMesh turned =
        loadMesh(fs::path(data.toStdString()) / "avf-mra/avf.vtk", {Frame::Ras, {}});
    QVERIFY(!turned.frameStated && turned.warnings.size() == 1);
    QVERIFY(turned.warnings[0].find("93 points that lie at the place") == 0);
    QCOMPARE(turned.mesh.points[0],
             Eigen::Vector3d(-mesh.points[0].x(), -mesh.points[0].y(), mesh.points[0].z()));
  }
};

QTEST_APPLESS_MAIN(TestMeshIo)
#include "tst_mesh_io.moc"
