// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_io.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// An octahedron with uneven, not representable coordinates; faces outward.
TriMesh octahedron() {
  TriMesh mesh;
  const Eigen::Vector3d centre(10.1, -20.3, 0.7);
  for (int a = 0; a < 3; ++a)
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d p = centre;
      p[a] += side * (3.1 + a / 3.0);
      mesh.points.push_back(p);
    }
  for (std::uint32_t x = 0; x < 2; ++x)
    for (std::uint32_t y = 2; y < 4; ++y)
      for (std::uint32_t z = 4; z < 6; ++z) {
        const bool upright = (x + y + z) % 2 == 1;
        // Corners on +x, +y, +z run counter-clockwise; each mirrored axis turns them round.
        mesh.triangles.push_back(upright ? std::array<std::uint32_t, 3>{x, y, z}
                                         : std::array<std::uint32_t, 3>{x, z, y});
      }
  return mesh;
}

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

/// Largest distance between corners of corresponding triangles, whatever the points' numbers.
double largestDifference(const TriMesh& a, const TriMesh& b) {
  if (a.triangles.size() != b.triangles.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(
          largest,
          (a.points[a.triangles[t][c]] - b.points[b.triangles[t][c]]).cwiseAbs().maxCoeff());
  return largest;
}

std::string plyHeader(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement "
         "face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_index\nend_header\n";
}

}  // namespace

class TestMeshIo : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTestMeshPointsOutward() { QVERIFY(signedVolume(octahedron()) > 10.0); }

  void meshesSurviveARoundTrip_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<bool>("metre");
    QTest::addColumn<bool>("ras");
    for (const char* extension : {".ply", ".stl", ".obj", ".vtp"})
      for (const bool metre : {false, true})
        for (const bool ras : {false, true})
          QTest::addRow("%s %s %s", extension, metre ? "m" : "mm", ras ? "RAS" : "LPS")
              << QString(extension) << metre << ras;
  }
  void meshesSurviveARoundTrip() {
    QFETCH(QString, extension);
    QFETCH(bool, metre);
    QFETCH(bool, ras);
    const Folder folder;
    const fs::path path = folder / ("m" + extension.toStdString());
    const TriMesh mesh = octahedron();
    writeMesh(mesh, path,
              {metre ? LengthUnit::Metre : LengthUnit::Millimetre, ras ? Frame::Ras : Frame::Lps,
               "0123abc"});
    const TriMesh back = readMesh(path);
    QCOMPARE(back.points.size(), mesh.points.size());
    const double difference = largestDifference(mesh, back);
    if (extension == ".stl")
      QVERIFY(difference < 2e-6);
    else if (metre)
      QVERIFY(difference < 1e-13);
    else
      QCOMPARE(difference, 0.0);
    QVERIFY(std::fabs(signedVolume(back) / signedVolume(mesh) - 1.0) < 1e-6);
    QCOMPARE(entriesOf(folder.path()), 1);

    const std::string bytes = bytesOf(path);
    if (extension == ".vtp") return;
    QVERIFY(bytes.find(ras ? "SPACE=RAS" : "SPACE=LPS") != std::string::npos);
    QVERIFY(bytes.find(metre ? "UNIT=m" : "UNIT=mm") != std::string::npos);
    QVERIFY(bytes.find("0123abc") != std::string::npos);
  }

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
    QVERIFY_EXCEPTION_THROWN(readMesh(folder / "cut.stl"), IoError);
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

  void badInputIsRefusedInOneLine_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<bool>("isInput");
    const auto row = [](const char* title, const char* name, const std::string& file, bool input) {
      QTest::newRow(title) << QString(name) << QByteArray::fromStdString(file) << input;
    };
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.vtp", "m.vtk"}) {
      row((std::string("empty ") + name).c_str(), name, "", false);
      row((std::string("text ") + name).c_str(), name, "hello world\n", true);
    }
    row("unknown extension", "m.step", "hello", true);
    row("noise stl", "m.stl", std::string(500, '\x7b'), false);
    row("points only", "m.ply", plyHeader("ascii", 1, 0) + "0 0 0 0\n", true);
    row("no faces obj", "m.obj", "v 0 0 0\n", true);
    row("index too large ply", "m.ply",
        plyHeader("ascii", 3, 1) + "0 0 0 0\n1 0 0 0\n0 1 0 0\n3 0 1 3\n", true);
    row("negative index ply", "m.ply",
        plyHeader("ascii", 3, 1) + "0 0 0 0\n1 0 0 0\n0 1 0 0\n3 0 1 -1\n", true);
    row("index too large obj", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", true);
    row("index zero obj", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", true);
    row("index too large vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
        "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 7\n",
        true);
    row("NaN", "m.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true);
    row("word in a vertex", "m.obj", "v 0 0 x\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true);
    row("image data vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n",
        true);
    row("cut vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0", false);
    row("cut vtp", "m.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData>\n",
        false);
    const auto vtp = [](const char* corners, const char* ends) {
      return std::string(
                 "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>"
                 "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points>"
                 "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
                 "0 0 0 1 0 0 0 1 0</DataArray></Points><Polys>"
                 "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">") +
             corners + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
             ends + "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
    };
    row("index too large vtp", "m.vtp", vtp("0 1 4294967297", "3"), true);
    row("end too large vtp", "m.vtp", vtp("0 1 2", "3000000"), false);
    row("negative end vtp", "m.vtp", vtp("0 1 2", "-3"), false);
    row("cut cells vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
        "0 0 0 1 0 0 0 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0",
        false);
    row("wrong count of corners vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
        "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n900 0 1 2\n",
        false);
    row("absurd sizes vtk", "m.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 99999999999999 float\n0 0 "
        "0\n",
        false);
    row("broken vtp", "m.vtp",
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"></Piece></PolyData></VTKFile>\n",
        false);
  }
  void badInputIsRefusedInOneLine() {
    QFETCH(QString, name);
    QFETCH(QByteArray, file);
    QFETCH(bool, isInput);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    save(path, file.toStdString());
    QString message;
    bool input = false;
    TerminalCapture terminal;
    try {
      readMesh(path);
    } catch (const InputError& error) {
      message = error.what();
      input = true;
    } catch (const IoError& error) {
      message = error.what();
    }
    QCOMPARE(terminal.text(), QString());
    QVERIFY(!message.isEmpty());
    QVERIFY2(input == isInput, qPrintable(message));
    QVERIFY(!message.contains('\n'));
  }

  void truncationIsFoundAtEveryLength_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {".ply", ".stl", ".vtp"}) QTest::newRow(extension) << extension;
  }
  void truncationIsFoundAtEveryLength() {
    QFETCH(QString, extension);
    const Folder folder;
    const fs::path path = folder / ("m" + extension.toStdString());
    writeMesh(octahedron(), path);
    std::string whole = bytesOf(path);
    while (whole.back() == '\n') whole.pop_back();
    QString missed;
    TerminalCapture terminal;
    for (std::size_t length = 0; length < whole.size(); length += 17) {
      save(path, whole.substr(0, length));
      bool refused = false;
      try {
        readMesh(path);
      } catch (const Error&) {
        refused = true;
      }
      if (!refused) missed += QString(" %1").arg(length);
    }
    QCOMPARE(terminal.text(), QString());
    QVERIFY2(missed.isEmpty(), qPrintable(missed));
  }

  void damagedBytesNeverCrash() {
    const Folder folder;
    TerminalCapture terminal;
    for (const char* extension : {".ply", ".stl", ".obj", ".vtp"}) {
      const fs::path path = folder / (std::string("m") + extension);
      writeMesh(octahedron(), path);
      const std::string whole = bytesOf(path);
      for (std::size_t at = 0; at < whole.size(); at += 11) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        save(path, damaged);
        try {
          const TriMesh mesh = readMesh(path);
          for (const auto& t : mesh.triangles)
            for (const auto corner : t)
              if (corner >= mesh.points.size()) QFAIL("an index out of range");
        } catch (const Error&) {
          continue;
        }
      }
    }
    QCOMPARE(terminal.text(), QString());
  }

  void badPlacesAndFullDisksLeaveNothingBehind() {
    const Folder folder;
    save(folder / "file", "x");
    fs::create_directory(folder / "folder.ply");
    const TriMesh mesh = octahedron();
    for (const char* name : {"none/m.ply", "file/m.stl", "folder.ply", "none/m.vtp"})
      QVERIFY_EXCEPTION_THROWN(writeMesh(mesh, folder / name), IoError);
    QVERIFY_EXCEPTION_THROWN(writeMesh(mesh, folder / "m.step"), InputError);
    QCOMPARE(entriesOf(folder.path()), 2);
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.vtp"}) {
      save(folder / name, "old");
      TerminalCapture terminal;
      bool refused = false;
      {
        const FullDisk full(200);
        try {
          writeMesh(mesh, folder / name);
        } catch (const IoError&) {
          refused = true;
        }
      }
      QCOMPARE(terminal.text(), QString());
      QVERIFY2(refused, name);
      QCOMPARE(bytesOf(folder / name), std::string("old"));
    }
    QCOMPARE(entriesOf(folder.path()), 6);
  }

  void aRealSurfaceIsRead() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const TriMesh mesh = readMesh(fs::path(data.toStdString()) / "avf-mra/avf.vtk");
    QVERIFY(mesh.triangles.size() > 1000);
    QVERIFY(std::fabs(signedVolume(mesh)) > 1.0);
  }
};

QTEST_APPLESS_MAIN(TestMeshIo)
#include "tst_mesh_io.moc"
