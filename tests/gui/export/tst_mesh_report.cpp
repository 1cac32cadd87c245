// SPDX-License-Identifier: BSD-3-Clause
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QXmlStreamReader>
#include <set>

#include "core/parameters/field.h"
#include "core/pipeline/report.h"
#include "gui/findings/case_review.h"
#include "gui/inspector/quality_text.h"
#include "gui/model/case_recipe.h"
#include "gui/model/step_text.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

const QString kRemark = QStringLiteral("Narrow <here> & \"there\"");

/// What a report holds, as a browser would read it.
struct Page {
  explicit Page(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return;
    bytes = file.readAll();
    QXmlStreamReader reader(bytes);
    while (!reader.atEnd()) {
      reader.readNext();
      if (reader.isCharacters()) text += reader.text().toString() + '\n';
      if (!reader.isStartElement()) continue;
      tags.insert(reader.name().toString());
      for (const QXmlStreamAttribute& attribute : reader.attributes())
        if (attribute.name() == u"src" || attribute.name() == u"href")
          sources << attribute.value().toString();
    }
    error = reader.hasError() ? reader.errorString() : QString();
  }
  [[nodiscard]] QImage picture(qsizetype index) const {
    return QImage::fromData(QByteArray::fromBase64(sources[index].section(',', 1).toLatin1()),
                            "PNG");
  }

  QByteArray bytes;
  QString text, error = QStringLiteral("no file");
  QStringList sources;
  std::set<QString> tags;
};

/// Colours of a picture: one that shows nothing has one.
std::size_t coloursOf(const QImage& picture) {
  std::set<QRgb> colours;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) colours.insert(picture.pixel(x, y));
  return colours.size();
}

/// The share of pixels in which two pictures differ.
double apart(const QImage& a, const QImage& b) {
  int others = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) others += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return a.size() == b.size() ? static_cast<double>(others) / (a.width() * a.height()) : 1.0;
}

/// A window after a run of two tubes.
struct Reported : WindowCase {
  Reported() {
    models().files.take(twoTubes());
    click(find<QPushButton>("run"));
  }
  Page report() {
    savePath = folder.filePath("patient 4711/vessels.html");
    QDir(folder.path()).mkpath("patient 4711");
    trigger(*this, "exportReport");
    return Page(savePath);
  }
  QString log() { return find<QPlainTextEdit>("log")->toPlainText(); }
};

}  // namespace

class TestMeshReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itIsOnePageThatStandsAlone() {
    Reported c;
    const Page page = c.report();
    QVERIFY2(page.error.isEmpty(), qPrintable(page.error));
    QVERIFY2(c.log().contains("Wrote the report vessels.html"), qPrintable(c.log()));
    QVERIFY(!page.tags.contains("script") && !page.tags.contains("link"));
    // Three slices, a projection, two views of the surface, and two histograms.
    QCOMPARE(page.sources.size(), qsizetype(8));
    for (qsizetype i = 0; i < page.sources.size(); ++i) {
      QVERIFY(page.sources[i].startsWith("data:image/png;base64,"));
      const std::size_t colours = coloursOf(page.picture(i));
      QVERIFY2(colours > 10, qPrintable(QString::number(i)));
    }
    for (const qsizetype i : {3, 4}) QVERIFY(page.picture(i) != page.picture(i + 1));
  }

  void itHasEveryRow() {
    Reported c;
    const Page page = c.report();
    const auto has = [&page](const QString& text) { return page.text.contains(text); };
    for (const QualityMeasure* measure : qualityRows())
      QVERIFY2(has('\n' + qualityTitle(measure) + '\n'), qPrintable(qualityTitle(measure)));
    for (int kind = 0; kind < kMeshKindCount; ++kind)
      if (c.models().results.quality(static_cast<MeshKind>(kind)))
        QVERIFY(has('\n' + meshTitle(static_cast<MeshKind>(kind)) + '\n'));
    QVERIFY(has(QStringLiteral("★ ")));
    const MeshQuality& quality = *c.models().results.quality(MeshKind::Exported);
    QVERIFY(has(QLocale().toString(static_cast<qlonglong>(quality.triangles))));
    // The tubes are two parts, which no printer takes.
    QVERIFY(has("Parts that do not hang together fall apart."));
    QVERIFY(has(QStringLiteral("at\u00a0most\u00a01")));
    for (const Field& field : parameterFields())
      QVERIFY2(has('\n' + QString::fromStdString(field.key) + '\n'), field.key.c_str());
    QVERIFY(has(QLatin1String(versionText())));
    const QString methods = QString::fromStdString(caseMethods(c.models()));
    QVERIFY(!methods.isEmpty() && has('\n' + methods.section('\n', 0, 0) + '\n'));
    QVERIFY(has("40 × 40 × 40 voxels of 0.5 × 0.5 × 0.5 mm"));
    QVERIFY(!has("Review") && !has("Measurements"));
  }

  void itHasWhatWasNoted() {
    Reported c;
    CaseNotes notes = c.models().document.notes();
    Measurement distance;
    distance.name = "my distance";
    distance.places = {{0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}};
    notes.measurements.push_back(distance);
    notes.review.remarks.push_back({{1.0, 2.0, 3.0}, 2, kRemark.toStdString()});
    c.models().document.changeNotes(notes, "noted");
    c.window->review().setVerdict(Verdict::Accepted);
    c.window->review().setScore(4);
    const Page page = c.report();
    QVERIFY2(page.error.isEmpty(), qPrintable(page.error));
    for (const QString& text :
         {QStringLiteral("my distance"), QStringLiteral("5.0"), kRemark,
          QStringLiteral("L 1.0 P 2.0 S 3.0"), QStringLiteral("accepted, score 4 of 5")})
      QVERIFY2(page.text.contains(text), qPrintable(text + " in " + page.text.left(6000)));
  }

  void itSaysWhatIsOutOfDate() {
    Reported c;
    QVERIFY(!c.report().text.contains("out of date"));
    c.models().document.setField("levelset.xi", 31.0);
    const Page page = c.report();
    QVERIFY(page.text.contains("out of date"));
    // The parameters are those that made it.
    QVERIFY(!page.text.contains("\n31\n"));
  }

  void itNamesNoPlace() {
    Reported c;
    const Page page = c.report();
    QVERIFY(!page.bytes.contains(c.folder.path().toUtf8()) && !page.bytes.contains("4711"));
    QVERIFY(!page.bytes.contains("two-tubes"));
    QCOMPARE(QDir(c.folder.filePath("patient 4711")).entryList(QDir::Files | QDir::Hidden),
             QStringList{"vessels.html"});
  }

  void thePanesLookAsBefore() {
    Reported c;
    c.state().setContours(false);
    c.state().setSurface(false);
    QTest::qWait(500);  // for the layout and the full picture
    const QImage before = c.window->views().surface()->grabFramebuffer();
    QVERIFY(c.report().error.isEmpty());
    QVERIFY(!c.state().contours() && c.state().volumeView() == VolumeView::Mip &&
            !c.state().surface());
    // Once it is drawn in full again; the camera has been turned and turned back.
    QTRY_VERIFY(apart(c.window->views().surface()->grabFramebuffer(), before) < 0.001);
  }

  void whatCannotBeWrittenIsSaid() {
    Reported c;
    c.savePath = c.folder.filePath("none/vessels.html");
    trigger(c, "exportReport");
    QVERIFY2(c.log().contains("Cannot write the report"), qPrintable(c.log()));
    QVERIFY(!c.log().contains(c.folder.path()) && !QFile::exists(c.savePath));
    // Without a mesh there is none.
    c.models().files.take(slowTree());
    QVERIFY(!c.window->findChild<QAction*>("exportReport")->isEnabled());
  }
};

int main(int argc, char** argv) { return runWindowTests<TestMeshReport>(argc, argv); }
#include "tst_mesh_report.moc"
