// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "io/image_io.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

namespace {

/// The panel of a figure in figures.json.
QJsonObject panel(const QJsonObject& json, const QString& figure, qsizetype number) {
  for (const QJsonValue& value : json["figures"].toArray())
    if (value["figure"].toString() == figure) return value["panels"].toArray()[number].toObject();
  return {};
}

double triangles(const QJsonObject& panel) { return panel["triangles"].toDouble(); }

}  // namespace

/// A branching vessel that leaves the volume, with a rough wall.
Volume<float> roughBranch() {
  PhantomParams params;
  params.kind = PhantomKind::Bifurcation;
  params.size = {32, 32, 32};
  params.radius = 5.0;
  Volume<float> phi = phantomField(params);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    phi.voxels[i] += static_cast<float>(0.05 * randomNormal(1, i));
  return phi;
}

// `study figures` on a small vessel: the pictures are there and the numbers go the way that the
// thesis says.
class TestStudy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void figuresOfALevelSetFunction() {
    const QTemporaryDir dir;
    writeVolume(roughBranch(), dir.filePath("phi.nrrd").toStdString());
    const QStringList command{"study", "figures", "phi.nrrd", "-o", "figures"};
    const CliResult result = runCli(dir.path(), command);
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(result.output.contains("| 5.6 | marching cubes |"));

    QFile file(dir.filePath("figures/figures.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(json["figures"].toArray().size(), 6);
    for (const QJsonValue& figure : json["figures"].toArray()) {
      QFile picture(dir.filePath("figures/" + figure["file"].toString()));
      QVERIFY(picture.open(QIODevice::ReadOnly));
      QVERIFY(picture.size() > 10000);
      QCOMPARE(picture.read(4), QByteArray("\x89PNG"));
      for (const QJsonValue& one : figure["panels"].toArray())
        QVERIFY(triangles(one.toObject()) > 100);
    }
    QVERIFY(triangles(panel(json, "B.1", 0)) < triangles(panel(json, "B.1", 1)));
    QVERIFY(triangles(panel(json, "B.1", 1)) < triangles(panel(json, "B.1", 2)));
    QVERIFY(triangles(panel(json, "5.4", 0)) > triangles(panel(json, "5.4", 1)));
    QVERIFY(panel(json, "5.6", 0)["radius_ratio_mean"].toDouble() <
            panel(json, "5.6", 1)["radius_ratio_mean"].toDouble());
    QVERIFY(panel(json, "5.5", 1)["triangles"] == panel(json, "B.2", 0)["triangles"]);

    QCOMPARE(runCli(dir.path(), command).code, 2);
  }
};

QTEST_GUILESS_MAIN(TestStudy)
#include "tst_study.moc"
