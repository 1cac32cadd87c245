// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/mesh/outward.h"
#include "core/mesh/triangle_shape.h"
#include "io/mesh/mesh_io.h"
#include "tests/io/io_test.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

MeshWriteOptions withExtras(MeshEncoding encoding, LengthUnit unit, Frame frame) {
  MeshWriteOptions options;
  options.encoding = encoding;
  options.unit = unit;
  options.frame = frame;
  options.normals = options.quality = true;
  return options;
}

/// A point of the mesh as the file in metres and RAS has it.
Eigen::Vector3d inRasMetres(const Eigen::Vector3d& p) {
  return {-1e-3 * p.x(), -1e-3 * p.y(), 1e-3 * p.z()};
}

}  // namespace

class TestMeshWrite : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyWayKeepsTheMesh_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<bool>("ascii");
    QTest::addColumn<bool>("metre");
    QTest::addColumn<bool>("ras");
    for (const char* extension : {".ply", ".stl", ".obj", ".off", ".vtp"})
      for (const bool ascii : {false, true})
        for (const bool metre : {false, true})
          for (const bool ras : {false, true})
            if (!ascii || QString(extension) != ".vtp")
              QTest::addRow("%s%s %s %s", extension, ascii ? " ascii" : "", metre ? "m" : "mm",
                            ras ? "RAS" : "LPS")
                  << QString(extension) << ascii << metre << ras;
  }
  void everyWayKeepsTheMesh() {
    QFETCH(QString, extension);
    QFETCH(bool, ascii);
    QFETCH(bool, metre);
    QFETCH(bool, ras);
    MeshWriteOptions options;
    options.unit = metre ? LengthUnit::Metre : LengthUnit::Millimetre;
    options.frame = ras ? Frame::Ras : Frame::Lps;
    options.key = "0123456789abcdef";
    options.encoding = ascii ? MeshEncoding::Ascii : MeshEncoding::Binary;
    const bool single = extension == ".stl" && !ascii;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      options.normals = options.quality =
          seed % 3 == 0 && (extension == ".ply" || extension == ".vtp");
      const Folder folder;
      const fs::path path = folder / ("m" + extension.toStdString());
      const TriMesh mesh = randomMesh(seed);
      QVERIFY(writeMesh(mesh, path, options).empty());
      const LoadedMesh back = loadMesh(path);
      QVERIFY(back.warnings.empty());
      QVERIFY(back.frameStated && back.frame == options.frame);
      QVERIFY(back.unitStated && back.unit == options.unit);
      QCOMPARE(back.key, options.key);
      QCOMPARE(back.mesh.points.size(), mesh.points.size());
      const double difference = largestDifference(mesh, back.mesh);
      if (single)
        QVERIFY(difference < 3e-5);
      else
        QVERIFY(difference <= (metre ? 1e-12 : 0.0));
      const double volume = enclosedVolumeMm3(mesh);
      QVERIFY(std::fabs(enclosedVolumeMm3(back.mesh) / volume - 1.0) < (single ? 1e-4 : 1e-9));
      QCOMPARE(back.hasNormals, options.normals);
      QCOMPARE(back.hasQuality, options.quality);

      const MeshFileFacts facts = checkMeshFile(mesh, path, options);
      QCOMPARE(facts.triangles, mesh.triangles.size());
      QCOMPARE(facts.closed, isClosed(mesh));
      Eigen::AlignedBox3d box;
      for (const auto& p : mesh.points) box.extend(p);
      const Eigen::Vector3d size = facts.size * (metre ? 1e3 : 1.0);
      QVERIFY((size - box.sizes()).cwiseAbs().maxCoeff() < 1e-4);
      QCOMPARE(entriesOf(folder.path()), 1);
    }
  }

  void normalsAreUnitAndOutward_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("ascii");
    QTest::newRow("ply") << "m.ply" << false;
    QTest::newRow("ply ascii") << "m.ply" << true;
    QTest::newRow("vtp") << "m.vtp" << false;
  }
  void normalsAreUnitAndOutward() {
    QFETCH(QString, name);
    QFETCH(bool, ascii);
    const Folder folder;
    const std::string path = (folder / name.toStdString()).string();
    const Eigen::Vector3d centre(12.0, -34.0, 56.0);
    TriMesh mesh = shapes::icosphere(3);
    for (auto& p : mesh.points) p = centre + 7.0 * p;
    // Inside out: the file has it turned, and the normals with it.
    QCOMPARE(writeMesh(insideOut(mesh), path,
                       withExtras(ascii ? MeshEncoding::Ascii : MeshEncoding::Binary,
                                  LengthUnit::Metre, Frame::Ras))
                 .size(),
             std::size_t{1});
    vtkNew<vtkPLYReader> ply;
    vtkNew<vtkXMLPolyDataReader> xml;
    ply->SetFileName(path.c_str());
    xml->SetFileName(path.c_str());
    vtkPolyData* data = nullptr;
    if (name == "m.vtp") {
      xml->Update();
      data = xml->GetOutput();
    } else {
      ply->Update();
      data = ply->GetOutput();
    }
    vtkDataArray* normals = data->GetPointData()->GetNormals();
    QVERIFY(normals != nullptr);
    QCOMPARE(normals->GetNumberOfTuples(), static_cast<vtkIdType>(mesh.points.size()));
    for (vtkIdType v = 0; v < normals->GetNumberOfTuples(); ++v) {
      Eigen::Vector3d normal, p;
      normals->GetTuple(v, normal.data());
      data->GetPoint(v, p.data());
      QVERIFY(std::fabs(normal.norm() - 1.0) < 1e-6);
      QVERIFY(normal.dot((p - inRasMetres(centre)).normalized()) > 0.999);
    }
  }

  void openMeshReadsTheQualityOfAPly() {
    using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
    const Folder folder;
    const TriMesh mesh = randomMesh(2);
    for (const MeshEncoding encoding : {MeshEncoding::Binary, MeshEncoding::Ascii}) {
      const fs::path path = folder / "m.ply";
      writeMesh(mesh, path, withExtras(encoding, LengthUnit::Millimetre, Frame::Lps));
      Mesh read;
      read.request_vertex_normals();
      OpenMesh::IO::Options options = OpenMesh::IO::Options::Custom;
      options += OpenMesh::IO::Options::VertexNormal;
      QVERIFY(OpenMesh::IO::read_mesh(read, path.string(), options));
      QCOMPARE(read.n_faces(), mesh.triangles.size());
      QVERIFY(options.check(OpenMesh::IO::Options::VertexNormal));
      OpenMesh::FPropHandleT<float> quality;
      QVERIFY(read.get_property_handle(quality, "quality"));
      for (const auto face : read.faces()) {
        const auto& t = mesh.triangles[static_cast<std::size_t>(face.idx())];
        const double wanted =
            triangleShape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]).radiusRatio;
        QVERIFY(wanted > 0.0 && wanted <= 1.0 + 1e-9);
        QVERIFY(std::fabs(read.property(quality, face) - wanted) < 1e-6);
      }
    }
  }

  void vtkReadsTheQualityOfAVtp() {
    const Folder folder;
    const std::string path = (folder / "m.vtp").string();
    const TriMesh mesh = randomMesh(2);
    writeMesh(mesh, path, withExtras(MeshEncoding::Binary, LengthUnit::Metre, Frame::Ras));
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkDataArray* quality = reader->GetOutput()->GetCellData()->GetArray("quality");
    QVERIFY(quality != nullptr);
    QCOMPARE(quality->GetNumberOfTuples(), static_cast<vtkIdType>(mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      const double wanted =
          triangleShape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]).radiusRatio;
      QVERIFY(std::fabs(quality->GetTuple1(static_cast<vtkIdType>(i)) - wanted) < 1e-6);
    }
  }

  /// 3D Slicer looks for "SPACE=LPS" in what these readers of VTK call the header or the comments.
  void valuesOfTheVerticesGoIntoAVtp() {
    const Folder folder;
    const TriMesh mesh = octahedron();
    MeshWriteOptions options;
    std::vector<float> heights;
    for (const Eigen::Vector3d& p : mesh.points) heights.push_back(static_cast<float>(p[2]));
    options.pointValues = {{"height", heights}, {"nothing", std::vector<float>(heights.size())}};
    const fs::path path = folder / "m.vtp";
    writeMesh(mesh, path, options);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData* back = reader->GetOutput();
    vtkDataArray* read = back->GetPointData()->GetArray("height");
    QVERIFY(read && back->GetPointData()->GetArray("nothing"));
    QCOMPARE(read->GetNumberOfTuples(), static_cast<vtkIdType>(heights.size()));
    for (vtkIdType v = 0; v < read->GetNumberOfTuples(); ++v)
      QVERIFY(std::fabs(read->GetTuple1(v) - back->GetPoint(v)[2]) < 1e-5);
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / "m.ply", options));
    options.pointValues[1].second.pop_back();
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / "n.vtp", options));
    QVERIFY(!fs::exists(folder / "n.vtp"));
  }

  void theFrameStandsWhereSlicerLooks() {
    const Folder folder;
    const TriMesh mesh = octahedron();
    MeshWriteOptions options;
    for (const Frame frame : {Frame::Lps, Frame::Ras}) {
      options.frame = frame;
      const std::string wanted = "SPACE=" + frameWord(frame);
      const auto found = [&](const char* header) {
        return header != nullptr && std::string(header).find(wanted) != std::string::npos;
      };
      for (const MeshEncoding encoding : {MeshEncoding::Binary, MeshEncoding::Ascii}) {
        options.encoding = encoding;
        vtkNew<vtkSTLReader> stl;
        writeMesh(mesh, folder / "m.stl", options);
        stl->SetFileName((folder / "m.stl").c_str());
        stl->Update();
        QCOMPARE(stl->GetOutput()->GetNumberOfPolys(), vtkIdType{8});
        QCOMPARE(stl->GetOutput()->GetNumberOfPoints(), vtkIdType{6});
        QVERIFY2(found(stl->GetHeader()), stl->GetHeader());
        vtkNew<vtkPLYReader> ply;
        writeMesh(mesh, folder / "m.ply", options);
        ply->SetFileName((folder / "m.ply").c_str());
        ply->Update();
        QCOMPARE(ply->GetOutput()->GetNumberOfPolys(), vtkIdType{8});
        bool stated = false;
        for (vtkIdType i = 0; i < ply->GetComments()->GetNumberOfValues(); ++i)
          stated = stated || found(ply->GetComments()->GetValue(i).c_str());
        QVERIFY(stated);
      }
      options.encoding = MeshEncoding::Binary;
      vtkNew<vtkOBJReader> obj;
      writeMesh(mesh, folder / "m.obj", options);
      obj->SetFileName((folder / "m.obj").c_str());
      obj->Update();
      QVERIFY2(found(obj->GetComment()), obj->GetComment());
      vtkNew<vtkXMLPolyDataReader> vtp;
      writeMesh(mesh, folder / "m.vtp", options);
      vtp->SetFileName((folder / "m.vtp").c_str());
      vtp->Update();
      auto* space =
          vtkStringArray::SafeDownCast(vtp->GetOutput()->GetFieldData()->GetAbstractArray("SPACE"));
      QVERIFY(space != nullptr && space->GetValue(0) == frameWord(frame));
    }
  }

  void asciiStlHasNineDigitsAndMore() {
    const Folder folder;
    MeshWriteOptions options;
    options.encoding = MeshEncoding::Ascii;
    writeMesh(shapes::cube(), folder / "m.stl", options);
    const QString text = QString::fromStdString(bytesOf(folder / "m.stl"));
    static const QRegularExpression vertex("vertex (\\S+) (\\S+) (\\S+)\n");
    int numbers = 0;
    for (auto match = vertex.globalMatch(text); match.hasNext();) {
      const QRegularExpressionMatch found = match.next();
      for (int i = 1; i <= 3; ++i, ++numbers) {
        const QString mantissa = found.captured(i).section('e', 0, 0);
        QVERIFY2(mantissa.count(QRegularExpression("\\d")) >= 9, qPrintable(mantissa));
      }
    }
    QCOMPARE(numbers, 12 * 9);
    QVERIFY(text.startsWith("solid surface SPACE=LPS UNIT=mm\n"));
    QVERIFY(text.endsWith("endsolid surface\n"));
  }

  void pointsThatDifferInTheLastBitStayApart() {
    const Folder folder;
    TriMesh mesh = octahedron();
    mesh.points[1].x() = std::nextafter(mesh.points[1].x(), 1e9);
    TriMesh two = mesh;
    shapes::append(two, mesh);
    two.points[6].y() = std::nextafter(two.points[6].y(), 1e9);
    MeshWriteOptions options;
    options.encoding = MeshEncoding::Ascii;
    QVERIFY(writeMesh(two, folder / "m.stl", options).empty());
    // All points but the moved one are there twice.
    QCOMPARE(readMesh(folder / "m.stl").points.size(), std::size_t{7});
    checkMeshFile(two, folder / "m.stl", options);
  }

  void singlePrecisionIsSpokenOf() {
    const Folder folder;
    TriMesh mesh = shapes::icosphere(2);
    // Edges of a tenth of a micrometre, 300 mm from the origin.
    for (auto& p : mesh.points) p = Eigen::Vector3d(300, 0, 0) + 1e-5 * p;
    const std::vector<std::string> warnings = writeMesh(mesh, folder / "m.stl");
    QCOMPARE(warnings.size(), std::size_t{1});
    const QString warning = QString::fromStdString(warnings[0]);
    QVERIFY2(warning.contains("lose their area"), qPrintable(warning));
    checkMeshFile(mesh, folder / "m.stl");
    MeshWriteOptions ascii;
    ascii.encoding = MeshEncoding::Ascii;
    QVERIFY(writeMesh(mesh, folder / "a.stl", ascii).empty());
    QCOMPARE(checkMeshFile(mesh, folder / "a.stl", ascii).vertices, mesh.points.size());
    // Metres are no harder than millimetres: the numbers' steps shrink with them.
    MeshWriteOptions metres;
    metres.unit = LengthUnit::Metre;
    QVERIFY(writeMesh(randomMesh(4), folder / "m.stl", metres).empty());
    for (auto& p : mesh.points) p *= 1e38;
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / "big.stl"));
    QVERIFY(!fs::exists(folder / "big.stl"));
  }

  void unusableMeshesAndOptionsAreRefused() {
    const Folder folder;
    const TriMesh mesh = shapes::cube();
    MeshWriteOptions ascii;
    ascii.encoding = MeshEncoding::Ascii;
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / "m.vtp", ascii));
    MeshWriteOptions normals, quality;
    normals.normals = quality.quality = true;
    for (const char* name : {"m.stl", "m.obj"}) {
      QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / name, normals));
      QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(mesh, folder / name, quality));
    }
    TriMesh broken = mesh;
    broken.points[3].y() = std::nan("");
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(broken, folder / "m.ply"));
    broken = mesh;
    broken.triangles[0][0] = 8;
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(broken, folder / "m.ply"));
    broken = mesh;
    broken.patch = {0, 1};
    QVERIFY_THROWS_EXCEPTION(InputError, writeMesh(broken, folder / "m.ply"));
    QCOMPARE(entriesOf(folder.path()), 0);
  }

  void insideOutIsTurnedAtBothEnds() {
    const Folder folder;
    const TriMesh mesh = octahedron();
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.vtp"}) {
      const fs::path path = folder / name;
      const std::vector<std::string> warnings = writeMesh(insideOut(mesh), path);
      QCOMPARE(warnings.size(), std::size_t{1});
      QVERIFY(QString::fromStdString(warnings[0]).contains("inside out"));
      QVERIFY(loadMesh(path).warnings.empty());
      QVERIFY(enclosedVolumeMm3(readMesh(path)) > 10.0);
      checkMeshFile(insideOut(mesh), path);
    }
    std::string obj;
    for (const auto& p : mesh.points)
      obj += QString("v %1 %2 %3\n").arg(p.x()).arg(p.y()).arg(p.z()).toStdString();
    for (const auto& t : mesh.triangles)
      obj += QString("f %1 %3 %2\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toStdString();
    save(folder / "in.obj", obj);
    const LoadedMesh turned = loadMesh(folder / "in.obj");
    QCOMPARE(turned.warnings.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(turned.warnings[0]).contains("inside out"));
    QVERIFY(enclosedVolumeMm3(turned.mesh) > 10.0);
  }

  void aHeapOfTrianglesClosesInAnStlFile() {
    const Folder folder;
    TriMesh heap;
    const TriMesh mesh = insideOut(octahedron());
    for (const auto& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(heap.points.size());
      for (const auto corner : t) heap.points.push_back(mesh.points[corner]);
      heap.triangles.push_back({first, first + 1, first + 2});
    }
    QVERIFY(writeMesh(heap, folder / "m.stl").empty());
    QVERIFY(checkMeshFile(heap, folder / "m.stl").closed);
    writeMesh(heap, folder / "m.ply");
    QVERIFY(!checkMeshFile(heap, folder / "m.ply").closed);
  }

  void theCheckFindsWhatDiffers() {
    const Folder folder;
    const fs::path path = folder / "m.ply";
    const TriMesh mesh = randomMesh(2);
    const auto complaint = [&](const TriMesh& written, const MeshWriteOptions& as,
                               const MeshWriteOptions& wanted) {
      writeMesh(written, path, as);
      return messageOf([&] { checkMeshFile(mesh, path, wanted); });
    };
    MeshWriteOptions metre, ras, quality;
    metre.unit = LengthUnit::Metre;
    ras.frame = Frame::Ras;
    quality.quality = true;
    QCOMPARE(complaint(mesh, {}, {}), QString());
    QVERIFY(complaint(mesh, metre, {}).contains("unit: m instead of mm"));
    QVERIFY(complaint(mesh, ras, {}).contains("frame: RAS instead of LPS"));
    QVERIFY(complaint(mesh, {}, quality).contains("quality: no instead of yes"));
    TriMesh other = mesh;
    other.points[0].x() += 50.0;
    QVERIFY(complaint(other, {}, {}).contains("box: "));
    other = mesh;
    other.triangles.pop_back();
    const QString message = complaint(other, {}, {});
    QVERIFY2(message.contains(QString("triangles: %1 instead of %2")
                                  .arg(other.triangles.size())
                                  .arg(mesh.triangles.size())) &&
                 message.contains("m.ply"),
             qPrintable(message));
    other = mesh;
    other.triangles.back() = other.triangles.front();
    QVERIFY(complaint(other, {}, {}).contains("closed: no instead of yes"));
  }
};

QTEST_APPLESS_MAIN(TestMeshWrite)
#include "tst_mesh_write.moc"
