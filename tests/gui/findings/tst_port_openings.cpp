// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "tests/gui/port_case.h"

using namespace angiomesh;
using angiomesh::test::kPatienceMs;
using angiomesh::test::PortCase;

/// Openings at the volume's border: their names, cuts across them, and ports from a file.
class TestPortOpenings : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anOpeningKeepsTheNameItIsGiven() {
    PortCase c;
    const QString first = c.table()->item(0, 0)->text();
    const Eigen::Vector3d place = c.ports().find(first)->plane.pointLps;
    c.table()->item(0, 0)->setText("supra");
    QCoreApplication::processEvents();
    QVERIFY(c.ports().find("supra") && !c.ports().find(first));
    // No step is to be made anew, and everything that is written has the name.
    QVERIFY(c.models().results.meshFresh());
    const auto named = [&] { return c.models().results.ports(MeshKind::Exported)[0].name; };
    QCOMPARE(named(), std::string("supra"));
    QCOMPARE(c.models().document.undoStack()->undoText(),
             QString("name the opening %1 supra").arg(first));
    // With a cut it is another number of the list.
    c.cutAt(0.5);
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFresh());
    const PortRow* row = c.ports().find("supra");
    if (row) {
      QVERIFY((row->plane.pointLps - place).norm() < 0.1);
    } else {
      QVERIFY(!c.ports().find(first));  // it went with what was cut away
    }
    c.undo();
    c.undo();
    QVERIFY(c.models().document.parameters().ports.names.empty());
    c.redo();
    QVERIFY(!c.ports().rename("supra", "border_9").isEmpty());
    QVERIFY(c.ports().rename("supra", "").isEmpty());
    QVERIFY(c.models().document.parameters().ports.names.empty());
  }

  void whatTheBorderSlicesIsCutAcross() {
    PhantomParams params;
    params.kind = PhantomKind::Tube;
    params.size = {44, 44, 44};
    params.radius = 4.0;
    params.axis = {0.64, 0.0, 0.77};
    PortCase c({}, makeSource(makePhantom(params).image, "leaning"));
    const auto sliced = [&] {
      const auto& rows = c.ports().rows();
      return std::count_if(rows.begin(), rows.end(),
                           [](const PortRow& row) { return row.across.has_value(); });
    };
    QVERIFY(sliced() >= 2);  // an end through an edge of the volume has two openings
    QVERIFY(c.table()->item(0, 3)->text().contains("slices its vessel"));
    const QString first = c.ports().rows()[0].name;
    const double area = c.ports().rows()[0].areaMm2;
    c.ports().rename(first, "feed");
    auto* button = c.find<QToolButton>("cutAcrossButton");
    c.ports().select({});
    QVERIFY(!button->isEnabled());
    c.ports().select("feed");
    QVERIFY(button->isEnabled());
    c.click(button);
    // The cut has taken the name over.
    QCOMPARE(c.cuts(), std::size_t(1));
    QCOMPARE(c.cut(0).name, std::string("feed"));
    QVERIFY(c.models().document.parameters().ports.names.empty());
    c.trigger("cutAllAcross");
    QCOMPARE(c.cuts(), std::size_t(2));
    // Until the next run the list shows the openings of the last surface: none is cut twice.
    QString other;
    for (const PortRow& row : c.ports().rows()) {
      other = row.across ? row.name : other;
    }
    QVERIFY(!other.isEmpty());
    c.ports().cutAcross(other);
    QCOMPARE(c.cuts(), std::size_t(2));
    QVERIFY(c.find<QLabel>("portNotice")->text().contains("cut there already"));
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.models().results.meshFresh());
    QCOMPARE(sliced(), 0);
    const PortRow* row = c.ports().find("feed");
    QVERIFY(row && row->cut && row->areaMm2 < 0.85 * area);
    c.trigger("cutAllAcross");
    QVERIFY(c.find<QLabel>("portNotice")->text().contains("Nothing was cut"));
  }

  void portsAreImported() {
    PortCase c;
    c.cutAt(0.5);
    c.ports().rename("inlet", "supra");
    const auto cuts = c.models().document.parameters().ports.cuts;
    c.click(c.find<QPushButton>("run"));
    QTemporaryDir folder;
    c.savePath = folder.filePath("p.json");
    c.trigger("exportPorts");
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder.filePath("p.json")), kPatienceMs);
    c.ports().remove("supra");
    c.openPath = folder.filePath("p.json");
    c.trigger("importPorts");
    QCOMPARE(c.cuts(), std::size_t(1));
    QCOMPARE(c.cut(0).name, std::string("supra"));
    QVERIFY((c.cut(0).pointLps - parseCut(cuts[0]).pointLps).norm() < 0.2);
    c.trigger("importPorts");  // in place of those of the same name
    QCOMPARE(c.cuts(), std::size_t(1));
    c.openPath = folder.filePath("none.json");
    c.trigger("importPorts");
    QCOMPARE(c.cuts(), std::size_t(1));
    QVERIFY(c.find<QLabel>("portNotice")->text().contains("none.json"));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPortOpenings>(argc, argv); }
#include "tst_port_openings.moc"
