// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/mesh/outward.h"
#include "core/openings/port.h"
#include "core/openings/port_colour.h"
#include "io/mesh/mesh_io.h"
#include "io/vessel/patch_files.h"
#include "tests/io/io_test.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

using Names = std::vector<std::string>;
using Patches = std::vector<std::uint16_t>;

constexpr int kAround = 24, kRings = 9;
constexpr double kRadius = 2.0;

/// A tube somewhere in patient space, the triangles of its patches in turn.
TriMesh tube() {
  TriMesh mesh = cappedTube(kAround, kRings, kRadius);
  for (auto& p : mesh.points) p += Eigen::Vector3d(80.1, -42.7, 312.3);
  TriMesh mixed{mesh.points, {}, {}};
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t t = i * 5 % count;  // each once: no multiple of 5
    mixed.triangles.push_back(mesh.triangles[t]);
    mixed.patch.push_back(mesh.patch[t]);
  }
  return mixed;
}

MeshWriteOptions named(const Names& names, bool ascii = false) {
  MeshWriteOptions options;
  options.patchNames = names;
  options.encoding = ascii ? MeshEncoding::Ascii : MeshEncoding::Binary;
  return options;
}

std::string facet(int z) {
  return QString(
             "facet normal 0 0 1\nouter loop\nvertex 0 0 %1\nvertex 1 0 %1\nvertex 0 1 %1\n"
             "endloop\nendfacet\n")
      .arg(z)
      .toStdString();
}

std::string solid(const std::string& name, int z) {
  return "solid " + name + "\n" + facet(z) + "endsolid " + name + "\n";
}

/// A point, a line, three triangles and a strip of two, with a face each; as VTK writes them.
vtkSmartPointer<vtkPolyData> withFaces(const std::vector<int>& faces, bool active) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i) points->InsertNextPoint(i / 2, i % 2, 0.1 * i);
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  const auto add = [](vtkCellArray* cells, const std::vector<vtkIdType>& corners) {
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  };
  add(vertices, {0});
  add(lines, {0, 1});
  add(polygons, {0, 2, 1});
  add(polygons, {1, 2, 3});
  add(polygons, {2, 4, 5, 3});
  add(strips, {0, 1, 2, 3});
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  vtkNew<vtkIntArray> ids;
  ids->SetName("ModelFaceID");
  for (const int face : faces) ids->InsertNextValue(face);
  if (active)
    data->GetCellData()->SetScalars(ids);
  else
    data->GetCellData()->AddArray(ids);
  vtkNew<vtkIntArray> others;  // of the points, no faces
  others->SetName("ModelFaceID");
  others->SetNumberOfValues(6);
  others->Fill(7);
  data->GetPointData()->AddArray(others);
  return data;
}

}  // namespace

class TestMeshPatches : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyFormatKeepsPatches_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("ascii");
    QTest::addColumn<bool>("metre");
    for (const bool metre : {false, true}) {
      QTest::addRow("ply %d", metre) << "m.ply" << false << metre;
      QTest::addRow("ply ascii %d", metre) << "m.ply" << true << metre;
      QTest::addRow("stl ascii %d", metre) << "m.stl" << true << metre;
      QTest::addRow("obj %d", metre) << "m.obj" << false << metre;
      QTest::addRow("vtp %d", metre) << "m.vtp" << false << metre;
    }
  }
  void everyFormatKeepsPatches() {
    QFETCH(QString, name);
    QFETCH(bool, ascii);
    QFETCH(bool, metre);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    const TriMesh mesh = tube();
    MeshWriteOptions options = named({"wall", "inlet 1\n", "outlet"}, ascii);
    if (metre) {
      options.unit = LengthUnit::Metre;
      options.frame = Frame::Ras;
    }
    options.quality = options.normals = metre && (name == "m.ply" || name == "m.vtp");
    QVERIFY(writeMesh(mesh, path, options).empty());
    const LoadedMesh back = loadMesh(path);
    QCOMPARE(back.patchNames, (Names{"wall", "inlet_1_", "outlet"}));
    QVERIFY(back.warnings.empty());
    QVERIFY(isClosed(back.mesh));
    QCOMPARE(back.mesh.points.size(), mesh.points.size());
    QCOMPARE(back.hasQuality, options.quality);
    for (const std::uint16_t patch : {0, 1, 2})
      QCOMPARE(std::count(back.mesh.patch.begin(), back.mesh.patch.end(), patch),
               patch == 0 ? 2L * kAround * (kRings - 1) : long{kAround});
    const double area = 0.5 * kAround * kRadius * kRadius * std::sin(2.0 * M_PI / kAround);
    const std::vector<Port> ports = measurePatches(back.mesh, 2);
    for (const std::size_t n : {0, 1}) {
      QVERIFY(std::fabs(ports[n].areaMm2 / area - 1.0) < 1e-9);
      QVERIFY((ports[n].normalLps - Eigen::Vector3d(0, 0, n == 0 ? -1 : 1)).norm() < 1e-9);
      QVERIFY((ports[n].centreLps.head<2>() - Eigen::Vector2d(80.1, -42.7)).norm() < 1e-9);
    }
    QVERIFY(std::fabs(ports[0].centreLps.z() - 312.3) < 1e-9);
    checkMeshFile(mesh, path, options);
  }

  void solidsAndGroupsStandTogetherTheWallFirst() {
    const Folder folder;
    for (const char* name : {"m.stl", "m.obj"}) {
      writeMesh(tube(), folder / name, named({"wall", "in", "out"}, true));
      const Patches patch = loadMesh(folder / name).mesh.patch;
      QVERIFY(std::is_sorted(patch.begin(), patch.end()));
      const std::string text = bytesOf(folder / name);
      for (const std::string word : {"wall", "in", "out"}) {
        const std::string line = (name[2] == 's' ? "solid " : "g ") + word;
        QVERIFY2(text.find("\n" + line) != std::string::npos || text.starts_with(line),
                 line.c_str());
      }
    }
  }

  /// OpenFOAM takes all of the line for the name.
  void theLineOfASolidHoldsItsNameAlone() {
    const Folder folder;
    MeshWriteOptions options = named({"wall", "in", "out"}, true);
    const auto linesOf = [&] {
      writeMesh(tube(), folder / "m.stl", options);
      QStringList lines;
      for (const QString& line : QString::fromStdString(bytesOf(folder / "m.stl")).split('\n'))
        if (line.contains("solid")) lines.append(line);
      return lines;
    };
    QCOMPARE(linesOf(), (QStringList{"solid wall", "endsolid wall SPACE=LPS UNIT=mm", "solid in",
                                     "endsolid in SPACE=LPS UNIT=mm", "solid out",
                                     "endsolid out SPACE=LPS UNIT=mm"}));
    QVERIFY(loadMesh(folder / "m.stl").frameStated);
    // 3D Slicer takes a file for LPS that does not begin with another frame.
    options.frame = Frame::Ras;
    QCOMPARE(linesOf()[0], QString("solid wall SPACE=RAS UNIT=mm"));
    QCOMPARE(linesOf()[2], QString("solid in"));
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName((folder / "m.stl").c_str());
    reader->Update();
    QCOMPARE(reader->GetOutput()->GetNumberOfPolys(),
             static_cast<vtkIdType>(tube().triangles.size()));
    QVERIFY(std::string(reader->GetHeader()).find("SPACE=RAS") != std::string::npos);
  }

  void patchZeroIsTheOneCalledWall() {
    const Folder folder;
    const auto load = [&](const std::string& text) {
      save(folder / "m.stl", text);
      return loadMesh(folder / "m.stl");
    };
    const LoadedMesh last = load(solid("out", 0) + solid("in", 1) + solid("wall", 2));
    QCOMPARE(last.patchNames, (Names{"wall", "out", "in"}));
    QCOMPARE(last.mesh.patch, (Patches{1, 2, 0}));
    const LoadedMesh loud = load(solid("in", 0) + solid("WALL", 1));
    QCOMPARE(loud.patchNames, (Names{"WALL", "in"}));
    QCOMPARE(loud.mesh.patch, (Patches{1, 0}));
    const LoadedMesh both = load(solid("Wall", 0) + solid("wall", 1));
    QCOMPARE(both.patchNames, (Names{"wall", "Wall"}));
    const LoadedMesh twice = load(solid("in", 0) + solid("wall", 1) + solid("in", 2));
    QCOMPARE(twice.mesh.patch, (Patches{1, 0, 1}));
  }

  void namesStayWhereThereIsNoWall() {
    const Folder folder;
    save(folder / "a.stl", solid("vein", 0) + solid("artery", 1));
    const LoadedMesh first = loadMesh(folder / "a.stl");
    QCOMPARE(first.patchNames, (Names{"wall", "vein", "artery"}));
    QCOMPARE(first.mesh.patch, (Patches{1, 2}));
    for (const char* name : {"b.stl", "b.ply", "b.obj", "b.vtp"}) {
      const MeshWriteOptions options = named(first.patchNames, name[2] == 's');
      writeMesh(first.mesh, folder / name, options);
      checkMeshFile(first.mesh, folder / name, options);
      const LoadedMesh again = loadMesh(folder / name);
      QCOMPARE(again.patchNames, first.patchNames);
      QCOMPARE(again.mesh.patch, first.mesh.patch);
    }
    QVERIFY(bytesOf(folder / "b.stl").find("wall") == std::string::npos);
  }

  void aFileWithOnePatchHasNone() {
    const Folder folder;
    save(folder / "m.stl", solid("vessel", 0));
    save(folder / "g.obj", "g vessel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    save(folder / "none.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* name : {"m.stl", "g.obj"}) {
      QVERIFY(loadMesh(folder / name).mesh.patch.empty());
      QCOMPARE(loadMesh(folder / name).patchNames, (Names{"vessel"}));
    }
    QVERIFY(loadMesh(folder / "none.obj").patchNames.empty());
    TriMesh mesh = octahedron();
    mesh.patch.assign(8, 3);
    for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
      const MeshWriteOptions options = named({"a", "b", "c", "d"}, name[2] == 's');
      writeMesh(mesh, folder / name, options);
      checkMeshFile(mesh, folder / name, options);
    }
    mesh.patch.clear();
    for (const Names& names : {Names{}, Names{"wall"}, Names{"vessel", "unused"}}) {
      writeMesh(mesh, folder / "m.stl", named(names, true));
      checkMeshFile(mesh, folder / "m.stl", named(names, true));
      QCOMPARE(loadMesh(folder / "m.stl").patchNames[0], names.empty() ? "surface" : names[0]);
    }
  }

  void namesAreOneWordAndDifferent() {
    const Folder folder;
    TriMesh mesh = octahedron();
    mesh.patch = {0, 1, 2, 3, 4, 5, 6, 0};
    const Names names{"wall", "wall", "SPACE=RAS", "", "out\xc3\xa9 x", "wall-2"};
    for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
      const MeshWriteOptions options = named(names, name[2] == 's');
      writeMesh(mesh, folder / name, options);
      const LoadedMesh back = loadMesh(folder / name);
      QCOMPARE(back.patchNames,
               (Names{"wall", "wall-2", "SPACE_RAS", "patch_3", "out___x", "wall-2-2", "patch_6"}));
      QVERIFY(back.frame == Frame::Lps && back.warnings.empty());
      checkMeshFile(mesh, folder / name, options);
    }
  }

  void aPortWithoutTrianglesKeepsItsPlace() {
    const Folder folder;
    TriMesh mesh = tube();
    for (auto& patch : mesh.patch) patch = patch == 2 ? 3 : patch;
    for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
      const MeshWriteOptions options = named({"wall", "in", "lost", "out"}, name[2] == 's');
      writeMesh(mesh, folder / name, options);
      const LoadedMesh back = loadMesh(folder / name);
      QCOMPARE(back.patchNames, options.patchNames);
      QCOMPARE(*std::max_element(back.mesh.patch.begin(), back.mesh.patch.end()), std::uint16_t{3});
      checkMeshFile(mesh, folder / name, options);
    }
  }

  void aBinaryStlFileSaysWhatItLoses() {
    const Folder folder;
    const std::vector<std::string> warnings =
        writeMesh(tube(), folder / "m.stl", named({"wall", "in", "out"}));
    QCOMPARE(warnings.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(warnings[0]).contains("3 patches are lost"));
    checkMeshFile(tube(), folder / "m.stl", named({"wall", "in", "out"}));
    QVERIFY(loadMesh(folder / "m.stl").mesh.patch.empty());
    TriMesh plain = tube();
    plain.patch.clear();
    QVERIFY(writeMesh(plain, folder / "m.stl").empty());
  }

  void plyWithoutNamesIsNumbered() {
    const Folder folder;
    const auto ply = [](const std::string& type, const std::string& comments, const char* last) {
      return "ply\nformat ascii 1.0\n" + comments +
             "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 3\nproperty " +
             type +
             " patch\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
             "0 3 0 1 2\n5 3 0 1 2\n" +
             last + " 3 0 1 2\n";
    };
    const auto load = [&](const std::string& text) {
      save(folder / "m.ply", text);
      return loadMesh(folder / "m.ply");
    };
    const LoadedMesh plain = load(ply("int", "", "2"));
    QCOMPARE(plain.patchNames, (Names{"wall", "patch_2", "patch_5"}));
    QCOMPARE(plain.mesh.patch, (Patches{0, 2, 1}));
    const LoadedMesh some = load(ply("uchar", "comment patch 5 in\ncomment patch x y\n", "2"));
    QCOMPARE(some.patchNames, (Names{"wall", "patch_2", "in"}));
    for (const char* odd : {"-1", "2.5", "nan", "1e30"}) {
      const LoadedMesh none = load(ply("double", "comment patch 0 wall\n", odd));
      QVERIFY(none.mesh.patch.empty() && none.patchNames.empty());
      QCOMPARE(none.warnings.size(), std::size_t{1});
      QVERIFY(QString::fromStdString(none.warnings[0]).contains("whole numbers"));
    }
  }

  void groupsOfAnObjGoBeforeObjects() {
    const Folder folder;
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", face = "f 1 2 3\n";
    const auto load = [&](const std::string& text) {
      save(folder / "m.obj", points + text);
      return loadMesh(folder / "m.obj");
    };
    const LoadedMesh groups =
        load("o one\ng wall\n" + face + "o two\ng in top\n" + face + "g wall\n" + face);
    QCOMPARE(groups.patchNames, (Names{"wall", "in_top"}));
    QCOMPARE(groups.mesh.patch, (Patches{0, 1, 0}));
    const LoadedMesh objects = load("o one\n" + face + "usemtl red\no two\n" + face);
    QCOMPARE(objects.patchNames, (Names{"wall", "one", "two"}));
    const LoadedMesh before = load(face + "g in\nf 1 2 3\nf 1 2 3\n");
    QCOMPARE(before.patchNames, (Names{"wall", "default", "in"}));
    std::string many;
    for (int i = 0; i < 70000; ++i) many += "g a" + std::to_string(i) + "\n" + face;
    const LoadedMesh tooMany = load(many);
    QCOMPARE(tooMany.mesh.triangles.size(), std::size_t{70000});
    QVERIFY(tooMany.mesh.patch.empty() && tooMany.warnings.size() == 1);
  }

  void polygonsOfAPatchAreCutWithinIt() {
    const Folder folder;
    save(folder / "m.obj",
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\n"
         "g a\nf 1 2 3 4\ng b\nf 1 2 5\ng a\nf 2 6 5\n");
    QCOMPARE(loadMesh(folder / "m.obj").mesh.patch, (Patches{1, 1, 2, 1}));
  }

  void facesOfSimVascularAreRead_data() {
    QTest::addColumn<bool>("active");
    for (const bool active : {false, true}) QTest::addRow("active %d", active) << active;
  }
  void facesOfSimVascularAreRead() {
    QFETCH(bool, active);
    const Folder folder;
    const auto data = withFaces({9, 9, 3, 1, 8, 3}, active);
    // Three polygons, of which the last has four corners, then the strip of two triangles.
    const Patches wanted{2, 1, 3, 3, 2, 2};
    const auto check = [&](const char* name) {
      const LoadedMesh mesh = loadMesh(folder / name);
      QCOMPARE(mesh.patchNames, (Names{"wall", "face_1", "face_3", "face_8"}));
      QCOMPARE(mesh.mesh.patch, wanted);
    };
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetInputData(data);
      writer->SetFileName((folder / "m.vtp").c_str());
      writer->SetDataMode(mode);
      writer->Write();
      check("m.vtp");
    }
    for (const int version : {42, 51})
      for (const int type : {VTK_ASCII, VTK_BINARY}) {
        vtkNew<vtkPolyDataWriter> writer;
        writer->SetInputData(data);
        writer->SetFileName((folder / "m.vtk").c_str());
        writer->SetFileVersion(version);
        writer->SetFileType(type);
        writer->Write();
        check("m.vtk");
      }
  }

  void otherProgramsReadThePatches() {
    const Folder folder;
    const TriMesh mesh = tube();
    writeMesh(mesh, folder / "m.vtp", named({"wall", "in", "out"}));
    vtkNew<vtkXMLPolyDataReader> vtp;
    vtp->SetFileName((folder / "m.vtp").c_str());
    vtp->Update();
    auto* faces =
        vtkIntArray::SafeDownCast(vtp->GetOutput()->GetCellData()->GetArray("ModelFaceID"));
    QVERIFY(faces != nullptr);
    for (std::size_t t = 0; t < mesh.patch.size(); ++t)
      QCOMPARE(faces->GetValue(static_cast<vtkIdType>(t)), mesh.patch[t] + 1);
    auto* names = vtkStringArray::SafeDownCast(
        vtp->GetOutput()->GetFieldData()->GetAbstractArray("ModelFaceNames"));
    QVERIFY(names != nullptr && names->GetNumberOfValues() == 3);
    QVERIFY(names->GetValue(1) == "in" && names->GetValue(2) == "out");

    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    for (const bool ascii : {false, true}) {
      const MeshWriteOptions options = named({"wall", "in", "out"}, ascii);
      writeMesh(mesh, folder / "m.ply", options);
      vtkNew<vtkPLYReader> ply;
      ply->SetFileName((folder / "m.ply").c_str());
      ply->Update();
      QCOMPARE(ply->GetOutput()->GetNumberOfPolys(), static_cast<vtkIdType>(mesh.triangles.size()));
      auto* colours = ply->GetOutput()->GetCellData()->GetArray("RGB");
      QVERIFY(colours != nullptr && colours->GetNumberOfComponents() == 3);
      for (std::size_t t = 0; t < mesh.patch.size(); ++t) {
        const double* rgb = colours->GetTuple3(static_cast<vtkIdType>(t));
        const std::size_t port = mesh.patch[t] - 1U;
        for (std::size_t c = 0; c < 3; ++c)
          QVERIFY(std::fabs(rgb[c] - (mesh.patch[t] == 0 ? 204.0 : 255.0 * portColour(port)[c])) <
                  0.51);
      }
      Mesh read;
      OpenMesh::IO::Options custom = OpenMesh::IO::Options::Custom;
      QVERIFY(OpenMesh::IO::read_mesh(read, (folder / "m.ply").string(), custom));
      OpenMesh::FPropHandleT<int> patch;
      QVERIFY(read.get_property_handle(patch, "patch"));
      for (const auto face : read.faces())
        QCOMPARE(read.property(patch, face), int{mesh.patch[static_cast<std::size_t>(face.idx())]});
    }
  }

  void theCheckFindsPatchesThatDiffer() {
    const Folder folder;
    const TriMesh mesh = tube();
    const MeshWriteOptions options = named({"wall", "in", "out"});
    const auto complaint = [&](const TriMesh& written, const Names& names) {
      writeMesh(written, folder / "m.ply", named(names));
      return messageOf([&] { checkMeshFile(mesh, folder / "m.ply", options); });
    };
    QCOMPARE(complaint(mesh, options.patchNames), QString());
    QVERIFY(complaint(mesh, {"wall", "out", "in"}).contains("wall out in instead of wall in out"));
    TriMesh other = mesh;
    other.patch.clear();
    QVERIFY(complaint(other, options.patchNames).contains("none instead of wall in out"));
    other = mesh;
    *std::find(other.patch.begin(), other.patch.end(), 1) = 0;
    QVERIFY(complaint(other, options.patchNames).contains("triangles of wall: 385 instead of 384"));
    // As many triangles, but others.
    other = mesh;
    for (auto& patch : other.patch) patch = patch == 0 ? 0 : 3 - patch;
    QVERIFY(complaint(other, options.patchNames).contains("the port 'in' has its centre"));
  }

  void patchesGoToFilesOfTheirOwn() {
    const Folder folder;
    for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
      const MeshWriteOptions options = named({"wall", "../in", "a/IN"});
      const auto files = writePatchFiles(insideOut(tube()), folder / name, options);
      QCOMPARE(files.size(), std::size_t{3});
      const std::string end = fs::path(name).extension().string();
      QCOMPARE(files[0], folder / ("m_wall" + end));
      QCOMPARE(files[1], folder / ("m__._in" + end));
      QCOMPARE(files[2], folder / ("m_a_IN" + end));
      const TriMesh cap = readMesh(files[1]);
      QCOMPARE(cap.triangles.size(), std::size_t{kAround});
      QCOMPARE(cap.points.size(), std::size_t{kAround + 1});
      TriMesh patch = cap;
      patch.patch.assign(patch.triangles.size(), 1);
      QVERIFY((measurePatches(patch, 1)[0].normalLps + Eigen::Vector3d::UnitZ()).norm() < 1e-6);
    }
    QCOMPARE(fileWords({"In", "in", ".x", "a b"}), (Names{"In", "in-2", "_x", "a_b"}));
    QVERIFY_THROWS_EXCEPTION(IoError, writePatchFiles(tube(), folder / "none" / "m.stl"));
  }
};

QTEST_APPLESS_MAIN(TestMeshPatches)
#include "tst_mesh_patches.moc"
