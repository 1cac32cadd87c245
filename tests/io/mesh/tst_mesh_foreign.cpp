// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/outward.h"
#include "core/openings/port.h"
#include "core/quality/mesh_quality.h"
#include "io/mesh/cut_polygon.h"
#include "io/mesh/mesh_io.h"
#include "io/mesh/mesh_merge.h"
#include "io/vessel/openfoam_case.h"
#include "io/vessel/patch_files.h"
#include "tests/io/io_test.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

using Names = std::vector<std::string>;
using Corners = std::vector<Eigen::Vector3d>;

QString joined(const std::vector<std::string>& texts) {
  QString all;
  for (const std::string& text : texts) all += QString::fromStdString(text) + "\n";
  return all;
}

std::string shortest(double value) { return QString::number(value, 'g', 17).toStdString(); }

std::string objPoints(const Corners& points) {
  std::string text;
  for (const Eigen::Vector3d& p : points)
    text += "v " + shortest(p.x()) + " " + shortest(p.y()) + " " + shortest(p.z()) + "\n";
  return text;
}

std::string objFaces(const TriMesh& mesh, std::uint16_t patch) {
  std::string text;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch[t] != patch) continue;
    text += "f";
    for (const std::uint32_t c : mesh.triangles[t]) text += " " + std::to_string(c + 1);
    text += "\n";
  }
  return text;
}

std::string stlOf(const TriMesh& mesh, std::uint16_t patch, const std::string& name) {
  std::string text = "solid " + name + "\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch[t] != patch) continue;
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t c : mesh.triangles[t]) {
      text += "vertex";
      for (int a = 0; a < 3; ++a) text += " " + shortest(mesh.points[c][a]);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

TriMesh tube() { return cappedTube(16, 7, 2.0); }

/// Each triangle with corners of its own, each off its place by up to `gap`.
TriMesh apart(const TriMesh& mesh, double gap = 0.0) {
  TriMesh soup;
  soup.patch = mesh.patch;
  std::uint64_t next = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : triangle) {
      Eigen::Vector3d p = mesh.points[corner];
      for (int a = 0; a < 3; ++a) p[a] += gap * std::tanh(randomNormal(7, next++));
      soup.points.push_back(p);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

vtkSmartPointer<vtkPolyData> withEntities(const TriMesh& mesh, const std::array<int, 3>& ids) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> entities;
  entities->SetName("CellEntityIds");
  for (const Eigen::Vector3d& p : mesh.points) points->InsertNextPoint(p.data());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    cells->InsertNextCell(3);
    for (const std::uint32_t corner : mesh.triangles[t]) cells->InsertCellPoint(corner);
    entities->InsertNextValue(ids[mesh.patch[t]]);
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->AddArray(entities);
  return data;
}

/// A circle's corners about the z axis.
Corners circle(int corners, double radius) {
  Corners points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1.0);
  }
  return points;
}

double areaOfCircle(int corners, double radius) {
  return 0.5 * corners * radius * radius * std::sin(2.0 * M_PI / corners);
}

double areaOf(const Corners& points, const CornerTriangles& triangles) {
  TriMesh mesh;
  mesh.points = points;
  mesh.triangles = triangles;
  return surfaceAreaMm2(mesh);
}

}  // namespace

class TestMeshForeign : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesAreWholeLines() {
    const Folder folder;
    const TriMesh mesh = tube();
    save(folder / "m.stl", stlOf(mesh, 0, "wall") + stlOf(mesh, 1, " outlet 1 ") +
                               stlOf(mesh, 2, "outlet 2 SPACE=LPS"));
    save(folder / "m.obj", objPoints(mesh.points) + "g wall\n" + objFaces(mesh, 0) +
                               "g outlet 1\r\n" + objFaces(mesh, 1) + "\tg\toutlet 2 \n" +
                               objFaces(mesh, 2));
    save(folder / "o.obj", objPoints(mesh.points) + "o wall\n" + objFaces(mesh, 0) +
                               "o outlet 1\n" + objFaces(mesh, 1) + "o outlet 2\n" +
                               objFaces(mesh, 2));
    writeMesh(mesh, folder / "m.ply",
              {.encoding = MeshEncoding::Ascii, .patchNames = {"wall", "outlet_1", "outlet_2"}});
    std::string ply = bytesOf(folder / "m.ply");
    for (const char* number : {"1", "2"})
      ply.replace(ply.find(std::string("outlet_") + number), 8, std::string("outlet ") + number);
    save(folder / "m.ply", ply);
    for (const char* name : {"m.stl", "m.obj", "o.obj", "m.ply"}) {
      const LoadedMesh back = loadMesh(folder / name);
      QCOMPARE(back.patchNames, (Names{"wall", "outlet_1", "outlet_2"}));
      for (const std::uint16_t patch : {0, 1, 2})
        QCOMPARE(std::count(back.mesh.patch.begin(), back.mesh.patch.end(), patch),
                 std::count(mesh.patch.begin(), mesh.patch.end(), patch));
      QVERIFY2(back.warnings.empty(), qPrintable(joined(back.warnings)));
    }
  }

  void namesThatBecomeOneAreSaid() {
    const Folder folder;
    const TriMesh mesh = tube();
    save(folder / "m.stl",
         stlOf(mesh, 0, "wall") + stlOf(mesh, 1, "out 1") + stlOf(mesh, 2, "out_1"));
    const LoadedMesh back = loadMesh(folder / "m.stl");
    QCOMPARE(back.patchNames, (Names{"wall", "out_1", "out_1-2"}));
    QVERIFY(joined(back.warnings).contains("1 patch has the name of another one"));
    save(folder / "m.stl", stlOf(mesh, 0, "wall") + stlOf(mesh, 1, "out") + stlOf(mesh, 2, "out"));
    const LoadedMesh same = loadMesh(folder / "m.stl");
    QCOMPARE(same.patchNames, (Names{"wall", "out"}));
    QVERIFY(joined(same.warnings).contains("has the name of an earlier one"));
  }

  void namesThatBecomeOneInFilesAreSaid() {
    const Names names{"wall", "In", "in", "a/b", "a_b"};
    const QString said = joined(renamedWords(names, fileWords(names), "among the files"));
    QVERIFY(said.contains("the patch 'in' is called in-2 among the files"));
    QVERIFY(said.contains("the patch 'a_b' is called a_b-2"));
    QCOMPARE(said.count('\n'), 2);
    const Folder folder;
    const TriMesh mesh = tube();
    std::vector<Port> ports = measurePatches(mesh, 2);
    ports[0].name = "out.1";
    ports[1].name = "out_1";
    const OpenFoamCase written = writeOpenFoamCase(mesh, ports, folder / "case");
    QCOMPARE(written.mesh.patches, (Names{"wall", "out_1", "out_1-2"}));
    QVERIFY(joined(written.warnings).contains("'out_1' is called out_1-2 in the case"));
  }

  void entitiesOfVmtkArePatches() {
    const Folder folder;
    const TriMesh mesh = tube();
    const auto check = [&](const char* name, const Names& names, const char* said) {
      const LoadedMesh back = loadMesh(folder / name);
      QCOMPARE(back.patchNames, names);
      QCOMPARE(joined(back.warnings).contains("taken for the wall"), said != nullptr);
      if (said != nullptr) QVERIFY(joined(back.warnings).contains(said));
      QVERIFY(names.size() != 3 || back.mesh.patch == mesh.patch);
    };
    const auto write = [&](const std::array<int, 3>& ids) {
      vtkNew<vtkXMLPolyDataWriter> xml;
      xml->SetInputData(withEntities(mesh, ids));
      xml->SetFileName((folder / "m.vtp").c_str());
      xml->Write();
      vtkNew<vtkPolyDataWriter> legacy;
      legacy->SetInputData(withEntities(mesh, ids));
      legacy->SetFileName((folder / "m.vtk").c_str());
      legacy->Write();
    };
    for (const char* name : {"m.vtp", "m.vtk"}) {
      write({1, 2, 3});
      check(name, {"wall", "face_2", "face_3"}, "CellEntityIds, the patches, 1 is taken");
      write({0, 2, 3});
      check(name, {"wall", "face_2", "face_3"}, "0 is taken");
      // The lowest number is a cap's, or no wall's number.
      write({3, 1, 2});
      check(name, {"wall", "face_1", "face_2", "face_3"}, nullptr);
      write({5, 6, 7});
      check(name, {"wall", "face_5", "face_6", "face_7"}, nullptr);
    }
  }

  void pointsAtOnePlaceBecomeOne_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"m.ply", "m.obj", "m.vtp"}) QTest::newRow(name) << name;
  }
  void pointsAtOnePlaceBecomeOne() {
    QFETCH(QString, name);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    const TriMesh mesh = tube(), soup = apart(mesh);
    writeMesh(soup, path);
    checkMeshFile(soup, path);
    const LoadedMesh back = loadMesh(path);
    QCOMPARE(back.mesh.points.size(), mesh.points.size());
    QVERIFY(isClosed(back.mesh));
    QVERIFY(joined(back.warnings)
                .contains(QString("%1 points that lie at the place")
                              .arg(soup.points.size() - mesh.points.size())));
    MeshReadOptions keep;
    keep.keepPoints = true;
    QCOMPARE(loadMesh(path, keep).mesh.points.size(), soup.points.size());
    QVERIFY(loadMesh(path, keep).warnings.empty());
    // Two tubes that touch are closed as they are.
    TriMesh two = mesh;
    TriMesh beside = mesh;
    for (auto& p : beside.points) p.x() += 4.0;
    shapes::append(two, beside);
    two.patch.assign(two.triangles.size(), 0);
    writeMesh(two, path);
    QCOMPARE(loadMesh(path).mesh.points.size(), two.points.size());
    QVERIFY(loadMesh(path).warnings.empty());
  }

  void cracksAreSaidAndClosed() {
    const Folder folder;
    const TriMesh mesh = tube();
    for (const char* name : {"m.stl", "m.ply", "m.obj"}) {
      MeshWriteOptions write;
      if (name[2] == 's') write.encoding = MeshEncoding::Ascii;
      writeMesh(apart(mesh, 1e-6), folder / name, write);
      const LoadedMesh open = loadMesh(folder / name);
      QVERIFY(!isClosed(open.mesh));
      QVERIFY(joined(open.warnings).contains("--merge-distance 1e-05"));
      MeshReadOptions merge;
      merge.mergeDistanceMm = 1e-5;
      const LoadedMesh closed = loadMesh(folder / name, merge);
      QVERIFY(isClosed(closed.mesh));
      QCOMPARE(closed.mesh.points.size(), mesh.points.size());
      QCOMPARE(closed.mesh.triangles.size(), mesh.triangles.size());
      QVERIFY(std::fabs(enclosedVolumeMm3(closed.mesh) - enclosedVolumeMm3(mesh)) < 1e-3);
      merge.mergeDistanceMm = 1e-8;
      QVERIFY(!isClosed(loadMesh(folder / name, merge).mesh));
    }
  }

  /// Only points at open edges go, so that fine triangles elsewhere stay.
  void mergingLeavesWhatIsNotOpen() {
    TriMesh mesh = tube();
    const OpenMerge none = mergeOpenPoints(mesh, 5.0);
    QCOMPARE(none.points, std::size_t{0});
    QCOMPARE(mesh.triangles.size(), tube().triangles.size());
    // A triangle whose side is shorter than the distance goes.
    TriMesh thin{{{0, 0, 0}, {1, 0, 0}, {1, 1e-3, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {4, 5}};
    const OpenMerge merge = mergeOpenPoints(thin, 0.01);
    QCOMPARE(merge.points, std::size_t{1});
    QCOMPARE(merge.triangles, std::size_t{1});
    QCOMPARE(thin.patch, std::vector<std::uint16_t>{5});
    QCOMPARE(thin.points.size(), std::size_t{3});
  }

  void aRingWithABridgeHasItsArea() {
    constexpr int kCorners = 16;
    const Corners outer = circle(kCorners, 2.0), inner = circle(kCorners, 1.0);
    Corners ring = outer;
    ring.push_back(outer[0]);
    ring.push_back(inner[0]);
    for (int i = kCorners; i-- > 0;) ring.push_back(inner[static_cast<std::size_t>(i)]);
    const double area = areaOfCircle(kCorners, 2.0) - areaOfCircle(kCorners, 1.0);
    const CornerTriangles cut = cutByEars(ring);
    QCOMPARE(cut.size(), ring.size() - 2);
    QVERIFY(std::fabs(areaOf(ring, cut) - area) < 1e-9);
    QVERIFY(!foldsOver(ring, cut));

    const Folder folder;
    Corners points = outer;
    points.insert(points.end(), inner.begin(), inner.end());
    std::string face = "f";
    for (int i = 1; i <= kCorners; ++i) face += " " + std::to_string(i);
    face += " 1 " + std::to_string(kCorners + 1);
    for (int i = 2 * kCorners; i > kCorners; --i) face += " " + std::to_string(i);
    save(folder / "m.obj", objPoints(points) + face + "\n");
    const LoadedMesh back = loadMesh(folder / "m.obj");
    QVERIFY(std::fabs(surfaceAreaMm2(back.mesh) - area) < 1e-9);
    QVERIFY2(back.warnings.empty(), qPrintable(joined(back.warnings)));
  }

  void concavePolygonsAreCutAlongTheirInside() {
    // A comb: every tooth is a corner that no fan passes.
    Corners comb;
    constexpr int kTeeth = 20;
    for (int i = 0; i < kTeeth; ++i) {
      comb.emplace_back(2.0 * i, 0.0, 0.3 * i);
      comb.emplace_back(2.0 * i + 1.0, 5.0, 0.3 * i + 0.15);
    }
    comb.emplace_back(2.0 * kTeeth, 0.0, 0.3 * kTeeth);
    comb.emplace_back(2.0 * kTeeth, 6.0, 0.3 * kTeeth);
    comb.emplace_back(0.0, 6.0, 0.0);
    const CornerTriangles cut = cutByEars(comb);
    QCOMPARE(cut.size(), comb.size() - 2);
    const double flat = 6.0 * 2.0 * kTeeth - 5.0 * kTeeth;
    QVERIFY(std::fabs(areaOf(comb, cut) / (flat * std::sqrt(1.0 + 0.15 * 0.15)) - 1.0) < 1e-9);
  }

  void aFaceThatCrossesItselfIsSaid() {
    const Folder folder;
    const Corners star = circle(5, 3.0);
    std::string face = "f";
    for (int i = 0; i < 5; ++i) face += " " + std::to_string(2 * i % 5 + 1);
    save(folder / "m.obj", objPoints(star) + face + "\n");
    const LoadedMesh back = loadMesh(folder / "m.obj");
    QCOMPARE(back.mesh.triangles.size(), std::size_t{3});
    QVERIFY(joined(back.warnings).contains("1 face crosses itself"));
    QVERIFY(cutByEars({star[0], star[2], star[4], star[1], star[3]}).empty());
    QVERIFY(cutByEars({star[0], star[1], star[0], star[1]}).empty());
  }

  void trianglesOfAPartAreTurnedToAgree() {
    const Folder folder;
    const TriMesh mesh = tube();
    TriMesh mixed = mesh;
    std::size_t turned = 0;
    for (std::size_t t = 0; t < mixed.triangles.size(); t += 3, ++turned)
      std::swap(mixed.triangles[t][1], mixed.triangles[t][2]);
    for (const char* name : {"m.stl", "m.ply", "m.obj", "m.vtp"}) {
      writeMesh(mixed, folder / name);
      checkMeshFile(mixed, folder / name);
      const LoadedMesh back = loadMesh(folder / name);
      QVERIFY(std::fabs(enclosedVolumeMm3(back.mesh) / enclosedVolumeMm3(mesh) - 1.0) < 1e-6);
      QVERIFY(measureQuality(back.mesh).oriented);
      QVERIFY(joined(back.warnings)
                  .contains(QString("%1 triangles were not oriented as the others").arg(turned)));
    }
    TriMesh inward = insideOut(mesh);
    std::swap(inward.triangles[5][0], inward.triangles[5][1]);
    writeMesh(inward, folder / "m.ply");
    QVERIFY(std::fabs(enclosedVolumeMm3(readMesh(folder / "m.ply")) - enclosedVolumeMm3(mesh)) <
            1e-9);
  }

  void whatCannotBeOrientedIsSaidAndHasNoVolume() {
    constexpr std::uint32_t kQuads = 12;
    TriMesh strip;
    for (std::uint32_t i = 0; i < kQuads; ++i) {
      const double around = 2.0 * M_PI * i / kQuads;
      for (const double side : {-1.0, 1.0}) {
        const double r = 5.0 + side * std::cos(around / 2.0);
        strip.points.emplace_back(r * std::cos(around), r * std::sin(around),
                                  side * std::sin(around / 2.0));
      }
      const std::uint32_t a = 2 * i, b = 2 * i + 1;
      const bool last = i + 1 == kQuads;
      const std::uint32_t c = last ? 1 : a + 2, d = last ? 0 : a + 3;
      strip.triangles.push_back({a, c, b});
      strip.triangles.push_back({b, c, d});
    }
    TriMesh same = strip;
    const AlikeTurn turn = turnAlike(same);
    QCOMPARE(turn.oneSided, std::size_t{1});
    QCOMPARE(turn.turned, std::size_t{0});
    QVERIFY(same.triangles == strip.triangles);
    const Folder folder;
    writeMesh(strip, folder / "m.ply");
    QVERIFY(joined(loadMesh(folder / "m.ply").warnings).contains("no inside and no outside"));
    TriMesh mixed = tube();
    std::swap(mixed.triangles[0][1], mixed.triangles[0][2]);
    const MeshQuality quality = measureQuality(mixed);
    QVERIFY(quality.closed && !quality.oriented && !quality.hasVolume());
    QVERIFY(measureQuality(tube()).hasVolume());
  }

  void stlTextMayHaveAMarkBlankLinesAndCapitals() {
    const Folder folder;
    const TriMesh mesh = tube();
    const std::string text = stlOf(mesh, 0, "wall") + stlOf(mesh, 1, "in") + stlOf(mesh, 2, "out");
    const std::string capitals = QString::fromStdString(text).toUpper().toStdString();
    for (const std::string& each :
         {"\xef\xbb\xbf" + text, "\n \r\n\t" + text, "\xef\xbb\xbf\r\n" + capitals, capitals}) {
      save(folder / "m.stl", each);
      const LoadedMesh back = loadMesh(folder / "m.stl");
      QVERIFY(isClosed(back.mesh));
      QCOMPARE(back.patchNames.size(), std::size_t{3});
    }
  }

  void otherTextMayHaveAMark() {
    const Folder folder;
    const TriMesh mesh = tube();
    for (const char* name : {"m.ply", "m.obj", "m.vtp"}) {
      writeMesh(mesh, folder / name);
      save(folder / name, "\xef\xbb\xbf" + bytesOf(folder / name));
      QVERIFY(isClosed(readMesh(folder / name)));
    }
  }

  void whatComesAfterAMeshIsSaid() {
    const Folder folder;
    TriMesh mesh = tube();
    mesh.patch.clear();
    for (const char* name : {"m.stl", "m.ply"})
      for (const MeshEncoding encoding : {MeshEncoding::Binary, MeshEncoding::Ascii}) {
        MeshWriteOptions options;
        options.encoding = encoding;
        writeMesh(mesh, folder / name, options);
        const std::string one = bytesOf(folder / name);
        QCOMPARE(joined(loadMesh(folder / name).warnings), QString());
        save(folder / name, one + one);
        const LoadedMesh back = loadMesh(folder / name);
        // Texts of several solids are one surface, of which all triangles are there twice then.
        const bool all = back.mesh.triangles.size() == 2 * mesh.triangles.size();
        const bool said = joined(back.warnings).contains("bytes after what its header tells of");
        QVERIFY2(all != said, name);
        save(folder / name, one + "\r\n \n");
        if (encoding == MeshEncoding::Ascii)
          QCOMPARE(joined(loadMesh(folder / name).warnings), QString());
      }
  }

  void aCornerOfAnObjIsAWholeNumber() {
    const Folder folder;
    const std::string points = "v 0 0 0\nv 5 0 0\nv 0 5 0\n";
    for (const char* face : {"f 1 2 3", "f 1/1 2/ 3/1/1", "f 1//1 -2//1 3//1"}) {
      save(folder / "m.obj", points + face);
      QCOMPARE(loadMesh(folder / "m.obj").mesh.triangles.size(), std::size_t{1});
    }
    for (const char* face : {"f 1.5 2 3", "f 1 2e0 3", "f 1 2 3x", "f 1,2,3"}) {
      save(folder / "m.obj", points + face);
      QVERIFY2(messageOf([&] { loadMesh(folder / "m.obj"); }).contains("line 4"), face);
    }
  }

  void offMayHaveColoursCommentsAndLoosePoints() {
    const Folder folder;
    const std::string points = "0 0 0 255 0 0\n1 0 0 255 0 0\n\n0 1 0 255 0 0\n0 0 1 255 0 0\n";
    save(folder / "m.off", "COFF # from elsewhere\n# SPACE=RAS\n4 5 0\n" + points +
                               "3 0 2 1 0.5 0.5 0.5\n3  0 1 3\n3 0 3 2\n3 1 2 3\n1 0\n");
    const LoadedMesh loaded = loadMesh(folder / "m.off");
    QCOMPARE(loaded.mesh.triangles.size(), std::size_t{4});
    QVERIFY(loaded.frameStated && loaded.frame == Frame::Ras);
    QVERIFY(std::fabs(enclosedVolumeMm3(loaded.mesh) - 1.0 / 6.0) < 1e-12);
    QVERIFY(!loaded.hasNormals);
    save(folder / "n.off",
         "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n3 0 2 1\n");
    const LoadedMesh more = loadMesh(folder / "n.off");
    QVERIFY(more.hasNormals);
    QVERIFY(more.mesh.points[1] == Eigen::Vector3d::UnitX());
    QVERIFY(more.mesh.points[2] == Eigen::Vector3d::UnitY());
    QCOMPARE(more.mesh.triangles.size(), std::size_t{1});
    QVERIFY(std::any_of(more.warnings.begin(), more.warnings.end(), [](const std::string& warning) {
      return warning.find("goes on after its last face") != std::string::npos;
    }));
    for (const char* text :
         {"OFF\n4 1 0\n0 0 0\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "OFF BINARY\n",
          "4OFF\n1 0 0\n0 0 0 0\n", "OFF\n-1 0 0\n", "OFF\n1e30 1 0\n", "OFF\n"}) {
      save(folder / "bad.off", text);
      QVERIFY_THROWS_EXCEPTION(Error, readMesh(folder / "bad.off"));
    }
  }

  void linesOfAnObjGoOn() {
    const Folder folder;
    save(folder / "m.obj",
         "# a comment is a line of its own \\\nv 0 0 \\\n0\nv 5 \\\r\n 0 0\nv 5 5 0\nv 0 5 0\n"
         "g \\\nin 1\nf 1 2\\\n\\\n 3 4\ng b\nf 1 2 3\nf x\n");
    QVERIFY(messageOf([&] { loadMesh(folder / "m.obj"); }).contains("line 15"));
    std::string text = bytesOf(folder / "m.obj");
    save(folder / "m.obj", text.substr(0, text.size() - 4));
    const LoadedMesh back = loadMesh(folder / "m.obj");
    QCOMPARE(back.mesh.triangles.size(), std::size_t{3});
    QCOMPARE(back.patchNames, (Names{"wall", "in_1", "b"}));
  }

  void stripsOfAPly() {
    const Folder folder;
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
        "end_header\n0 0 0\n0 3 0\n3 0 0\n3 3 0\n6 0 0\n6 3 0\n";
    // Two strips, the first with a corner named twice; all face alike.
    save(folder / "m.ply", head + "11 1 0 3 2 2 -1 3 2 5 4 -1\n");
    const LoadedMesh back = loadMesh(folder / "m.ply");
    QCOMPARE(back.mesh.triangles.size(), std::size_t{4});
    QVERIFY(std::fabs(surfaceAreaMm2(back.mesh) - 18.0) < 1e-12);
    QVERIFY(back.warnings.empty());
    save(folder / "m.ply", head + "11 1 0 3 2 2 -1 3 2\n");
    QVERIFY(messageOf([&] { loadMesh(folder / "m.ply"); }).contains("truncated"));
    save(folder / "m.ply", head + "3 1 0 9\n");
    QVERIFY(messageOf([&] { loadMesh(folder / "m.ply"); }).contains("does not exist"));
  }

  void aSizeThatNoVesselHasIsAskedAbout() {
    const Folder folder;
    MeshWriteOptions metres;
    metres.unit = LengthUnit::Metre;
    writeMesh(tube(), folder / "m.stl", metres);
    QVERIFY(loadMesh(folder / "m.stl").warnings.empty());
    std::string bytes = bytesOf(folder / "m.stl");
    bytes.replace(bytes.find("UNIT=m"), 6, "      ");
    save(folder / "m.stl", bytes);
    QVERIFY(joined(loadMesh(folder / "m.stl").warnings).contains("shorter than any vessel"));
    MeshReadOptions known;
    known.unit = LengthUnit::Millimetre;
    QVERIFY(loadMesh(folder / "m.stl", known).warnings.empty());
    TriMesh large = tube();
    for (auto& p : large.points) p *= 1e3;
    writeMesh(large, folder / "m.ply");
    QVERIFY(joined(loadMesh(folder / "m.ply").warnings).contains("longer than any vessel"));
  }

  /// Where the grid that finds near points has no cells of the size.
  void farPointsAreNotLookedFor() {
    for (const double size : {1e-30, 1e30, 1e300}) {
      TriMesh mesh;
      mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
      for (int n = 0; n < 6; ++n)
        mesh.points.emplace_back(size * (n % 3), size * (n / 3), -size * n);
      QCOMPARE(openPointsNear(mesh, 1e-6 * size), std::size_t{0});
      QCOMPARE(mergeOpenPoints(mesh, 2.0 * size).points, std::size_t{0});
    }
  }
};

QTEST_APPLESS_MAIN(TestMeshForeign)
#include "tst_mesh_foreign.moc"
