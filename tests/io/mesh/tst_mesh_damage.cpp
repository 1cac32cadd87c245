// SPDX-License-Identifier: BSD-3-Clause
#include <QElapsedTimer>
#include <QTest>

#include "core/base/error.h"
#include "io/mesh/mesh_io.h"
#include "tests/io/io_test.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// Leaves the program two gigabytes of addresses while the object lives. The sanitizers need more.
class SmallMemory {
 public:
  SmallMemory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    ::getrlimit(RLIMIT_AS, &before_);
    rlimit small = before_;
    small.rlim_cur = rlim_t{2} << 30U;
    ::setrlimit(RLIMIT_AS, &small);
#endif
  }
  ~SmallMemory() {
    if (before_.rlim_cur != 0) ::setrlimit(RLIMIT_AS, &before_);
  }
  SmallMemory(const SmallMemory&) = delete;
  SmallMemory& operator=(const SmallMemory&) = delete;

 private:
  rlimit before_{};
};

}  // namespace

class TestMeshDamage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void noMemoryIsSetAsideForAClaim_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("file");
    const auto row = [](const char* title, const char* name, const std::string& file) {
      QTest::newRow(title) << QString(name) << QByteArray::fromStdString(file);
    };
    const auto ply = [](const std::string& format, const char* vertices, const char* faces) {
      return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
             "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
             "\nproperty list int int vertex_indices\nend_header\n";
    };
    const std::string little = "binary_little_endian";
    row("ply vertices", "m.ply", ply(little, "4000000000", "1") + std::string(100, '\0'));
    row("ply ascii vertices", "m.ply", ply("ascii", "4000000000", "1") + "0 0 0\n");
    row("ply faces", "m.ply", ply(little, "1", "4000000000") + std::string(100, '\0'));
    std::string list = ply(little, "1", "1") + std::string(12, '\0');
    append(list, std::int32_t{1000000000});
    row("ply list", "m.ply", list + std::string(100, '\0'));
    row("ply ascii list", "m.ply", ply("ascii", "1", "1") + "0 0 0\n1000000000 0 0 0\n");
    std::string stl(84, ' ');
    put(stl, 80, std::uint32_t{4000000000U});
    row("stl triangles", "m.stl", stl + std::string(100, '\0'));
    const std::string vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n";
    row("vtk points", "m.vtk", vtk + "POINTS 4000000000 float\n0 0 0\n");
    row("vtk polygons", "m.vtk",
        vtk + "POINTS 1 float\n0 0 0\nPOLYGONS 4000000000 16000000000\n3 0 0 0\n");
    row("vtk corners", "m.vtk", vtk + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n1000000000 0 0 0\n");
    row("vtk field", "m.vtk", vtk + "FIELD f 4000000000\na 4000000000 4000000000 float\n1\n");
    for (const char* what : {"Points", "Polys", "Strips", "Verts"})
      row((std::string("vtp ") + what).c_str(), "m.vtp",
          std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" ") +
              "compressor=\"vtkZLibDataCompressor\">\n<PolyData><Piece NumberOf" + what +
              "=\"4000000000\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
              "format=\"ascii\">0 0 0</DataArray></Points></Piece></PolyData></VTKFile>\n");
    for (const bool packed : {false, true}) {
      const auto vtp = [&](const std::string& data) {
        return std::string("<VTKFile type=\"PolyData\" ") +
               (packed ? "compressor=\"vtkZLibDataCompressor\"" : "") +
               "><PolyData><Piece NumberOfPoints=\"4000000000\"><Points><DataArray "
               "type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>"
               "</Points></Piece></PolyData><AppendedData encoding=\"raw\">_" +
               data + "</AppendedData></VTKFile>\n";
      };
      // Blocks, and the size of each: many, none, huge.
      const std::vector<std::array<std::uint32_t, 4>> heads{{4000000000U, 4000000000U, 7, 8},
                                                            {0, 4000000000U, 4000000000U, 8},
                                                            {1, 4000000000U, 0, 8},
                                                            {1, 0, 0, 4000000000U}};
      for (std::size_t i = 0; i < heads.size(); ++i) {
        std::string data;
        for (const std::uint32_t word : heads[i]) append(data, word);
        row(qPrintable(QString("vtp blocks %1 %2").arg(packed).arg(i)), "m.vtp",
            vtp(data + std::string(64, '\0')));
      }
    }
    std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 1000000; ++i) face += " 1 2 3";
    row("obj corners", "m.obj", face + "\n");
  }
  void noMemoryIsSetAsideForAClaim() {
    QFETCH(QString, name);
    QFETCH(QByteArray, file);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    save(path, file.toStdString());
    QString message;
    QElapsedTimer clock;
    clock.start();
    try {
      const SmallMemory small;
      readMesh(path);
    } catch (const Error& error) {
      message = error.what();
    }
    const qint64 milliseconds = clock.elapsed();
    QVERIFY2(message.contains(name), qPrintable(message));
    QVERIFY2(milliseconds < 2000, qPrintable(QString::number(milliseconds)));
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
      QVERIFY_THROWS_EXCEPTION(IoError, writeMesh(mesh, folder / name));
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / "m.step"));
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
};

QTEST_APPLESS_MAIN(TestMeshDamage)
#include "tst_mesh_damage.moc"
