// SPDX-License-Identifier: BSD-3-Clause
#include <QJsonArray>
#include <QTest>
#include <cmath>

#include "core/distance/redistance.h"
#include "core/phantom/phantom.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

// angiomesh-cli skeleton: of a level set function and of a mask, into files and as JSON.
class TestSkeletonCommand : public QObject, CliFolder {
  Q_OBJECT

 private:
  void verifyRefused(const QStringList& arguments, const char* what) {
    const QStringList before = filesIn(dir.path());
    const CliResult result = cli(arguments);
    QCOMPARE(result.code, 2);
    QVERIFY2(result.errorLines().size() == 1, result.errors.constData());
    QVERIFY2(result.errors.contains(what), result.errors.constData());
    QCOMPARE(filesIn(dir.path()), before);
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(dir.isValid());
    PhantomParams params;
    params.kind = PhantomKind::Bifurcation;
    params.size = {48, 48, 48};
    params.radius = 3.0;
    writeVolume(redistance(phantomField(params)), at("phi.nrrd").toStdString());
    writeVolume(makePhantom(params).truth, at("mask.mha").toStdString());
    Geometry g;
    g.size = {9, 9, 9};
    Volume<std::uint8_t> speck(g);
    speck.at(4, 4, 4) = 1;
    writeVolume(speck, at("speck.mha").toStdString());
  }

  void branchesOfAPhiAndOfAMask() {
    for (const char* input : {"phi.nrrd", "mask.mha"}) {
      const CliResult result = cli({"skeleton", input, "--json"});
      QVERIFY2(result.code == 0, result.errors.constData());
      const QJsonObject skeleton = result.json().value("skeleton").toObject();
      QCOMPARE(skeleton.value("nodes").toArray().size(), 4);
      QCOMPARE(skeleton.value("branches").toArray().size(), 3);
      double length = 0.0;
      for (const QJsonValue& branch : skeleton.value("branches").toArray())
        length += branch.toObject().value("length_mm").toDouble();
      QVERIFY2(std::fabs(length - 23.5 - 2.0 * 23.5 / std::cos(35.0 / 180.0 * M_PI)) < 2.0,
               qPrintable(QString::number(length)));
    }
  }

  void bothFilesAtOnce() {
    const CliResult result = cli({"skeleton", "phi.nrrd", "-o", "lines.csv", "-o", "lines.vtp"});
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(result.output.contains("3 branches in 1 part"));
    QVERIFY(result.output.contains("1 junction, 3 ends where the volume ends"));
    QFile table(at("lines.csv"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QCOMPARE(table.readAll().count('\n'), 4);
    QFile lines(at("lines.vtp"));
    QVERIFY(lines.open(QIODevice::ReadOnly));
    QVERIFY(lines.readAll().contains("NumberOfLines=\"3\""));
  }

  void whatCannotBeDoneIsSaid() {
    verifyRefused({"skeleton", "phi.nrrd"}, "no file to write is named");
    verifyRefused({"skeleton", "phi.nrrd", "-o", "lines.txt"}, "give .csv or .vtp");
    verifyRefused({"skeleton", "phi.nrrd", "-o", "no/lines.csv"}, "no");
    verifyRefused({"skeleton", "missing.nrrd", "-o", "other.csv"}, "missing.nrrd");
    verifyRefused({"skeleton", "speck.mha", "-o", "other.csv"}, "there is no vessel in it");
  }
};

QTEST_GUILESS_MAIN(TestSkeletonCommand)
#include "tst_skeleton_command.moc"
