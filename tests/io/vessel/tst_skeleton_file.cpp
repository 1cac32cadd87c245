// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <QTest>

#include "core/base/error.h"
#include "io/vessel/skeleton_file.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;
using Eigen::Vector3d;

namespace {

/// A tip, a junction and the volume's border, with numbers that no short decimal holds.
Skeleton twoBranches() {
  Skeleton skeleton;
  skeleton.nodes = {{NodeKind::Tip, {0.1, -2.0, 1.0 / 3.0}, 1, 1.5},
                    {NodeKind::Junction, {4.0, -2.0, 7e-20}, 1, 1.5},
                    {NodeKind::Border, {1e6, 3.0, -8.25}, 1, 0.7}};
  SkeletonBranch first;
  first.from = 0;
  first.to = 1;
  first.component = 1;
  first.points = {{{0.1, -2.0, 1.0 / 3.0}, 1.5, 1.25},
                  {{2.0, -2.0, 0.1}, 1.4, 1.3},
                  {{4.0, -2.0, 7e-20}, 1.45, 1.2}};
  first.lengthMm = 2.0 / 3.0;
  first.meanRadiusMm = 1.45;
  first.minRadiusMm = 1.4;
  first.maxRadiusMm = 1.5;
  SkeletonBranch second = first;
  second.from = 1;
  second.to = 2;
  second.points = {{{4.0, -2.0, 7e-20}, 0.8, 0.7}, {{1e6, 3.0, -8.25}, 0.7, 0.6}};
  skeleton.branches = {first, second};
  return skeleton;
}

QList<QStringList> tableOf(const fs::path& path) {
  QList<QStringList> rows;
  for (const QString& line : QString::fromStdString(bytesOf(path)).split('\n', Qt::SkipEmptyParts))
    rows.append(line.split(','));
  return rows;
}

}  // namespace

class TestSkeletonFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tableHasARowForEachBranch() {
    const Folder folder;
    writeSkeleton(twoBranches(), folder / "lines.csv");
    QCOMPARE(entriesOf(folder.path()), 1);
    const QList<QStringList> rows = tableOf(folder / "lines.csv");
    QCOMPARE(rows.size(), 3);
    for (const QStringList& row : rows) QCOMPARE(row.size(), rows.front().size());
    const auto cell = [&](int row, const char* name) {
      return rows[row][rows.front().indexOf(QString::fromLatin1(name))];
    };
    QCOMPARE(cell(1, "branch"), "0");
    QCOMPARE(cell(1, "from_kind"), "tip");
    QCOMPARE(cell(1, "to_kind"), "junction");
    QCOMPARE(cell(2, "to_kind"), "border");
    QCOMPARE(cell(2, "from_node"), "1");
    QCOMPARE(cell(1, "length_mm").toDouble(), 2.0 / 3.0);
    QCOMPARE(cell(1, "from_z_lps_mm").toDouble(), 1.0 / 3.0);
    QVERIFY(cell(1, "to_z_lps_mm").toDouble() == 7e-20);
    QCOMPARE(cell(2, "to_x_lps_mm").toDouble(), 1e6);
    QCOMPARE(cell(1, "max_radius_mm").toDouble(), 1.5);
  }

  void linesAreReadByVtk() {
    const Folder folder;
    const fs::path path = folder / "lines.vtp";
    const Skeleton skeleton = twoBranches();
    writeSkeleton(skeleton, path);
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    QCOMPARE(data->GetNumberOfPoints(), 5);
    QCOMPARE(data->GetNumberOfLines(), 2);
    QCOMPARE(data->GetNumberOfCells(), 2);
    QCOMPARE(data->GetCell(0)->GetNumberOfPoints(), 3);
    QCOMPARE(data->GetCell(1)->GetPointId(0), 3);
    const SkeletonPoint& point = skeleton.branches[0].points[1];
    for (int a = 0; a < 3; ++a) QCOMPARE(data->GetPoint(1)[a], point.pointLps[a]);
    vtkPointData* ofPoints = data->GetPointData();
    QCOMPARE(ofPoints->GetArray("Radius")->GetTuple1(1), point.radiusMm);
    QCOMPARE(ofPoints->GetArray("MaximumInscribedSphereRadius")->GetTuple1(1), point.inscribedMm);
    vtkCellData* ofLines = data->GetCellData();
    for (const char* name : {"BranchId", "GroupIds"})
      QCOMPARE(ofLines->GetArray(name)->GetTuple1(1), 1.0);
    QCOMPARE(ofLines->GetArray("ComponentId")->GetTuple1(0), 1.0);
    QCOMPARE(ofLines->GetArray("ToNode")->GetTuple1(1), 2.0);
    QCOMPARE(ofLines->GetArray("Length")->GetTuple1(0), 2.0 / 3.0);
    for (const auto& [name, value] : {std::pair{"SPACE", "LPS"}, std::pair{"UNIT", "mm"}}) {
      auto* words = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
      QVERIFY(words != nullptr);
      QCOMPARE(QString::fromStdString(words->GetValue(0)), QString::fromLatin1(value));
    }
  }

  void nothingIsLeftOfAFailure() {
    const Folder folder;
    QVERIFY_THROWS_EXCEPTION(InputError, writeSkeleton(twoBranches(), folder / "lines.txt"));
    QVERIFY_THROWS_EXCEPTION(InputError, checkSkeletonFile(folder / "lines"));
    QVERIFY_THROWS_EXCEPTION(IoError, writeSkeleton(twoBranches(), folder / "no" / "lines.csv"));
    QCOMPARE(entriesOf(folder.path()), 0);
    writeSkeleton({}, folder / "none.csv");
    writeSkeleton({}, folder / "none.vtp");
    QCOMPARE(tableOf(folder / "none.csv").size(), 1);
  }
};

QTEST_GUILESS_MAIN(TestSkeletonFile)
#include "tst_skeleton_file.moc"
