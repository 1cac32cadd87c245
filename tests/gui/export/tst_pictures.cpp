// SPDX-License-Identifier: BSD-3-Clause
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QPlainTextEdit>

#include "tests/gui/port_case.h"

using namespace angiomesh;
using angiomesh::test::kPatienceMs;
using angiomesh::test::PortCase;
using angiomesh::test::trigger;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

namespace {

/// Grey levels by which a picture twice as large, made smaller, may differ: its lines are finer.
constexpr double kSharper = 10.0;

QString logOf(WindowCase& c) { return c.find<QPlainTextEdit>("log")->toPlainText(); }

/// The entry of a list with this text.
int entry(const QComboBox* combo, const QString& text) { return combo->findText(text); }

/// The dialog with a pane chosen; null when it does not open.
QDialog* pictureOf(WindowCase& c, const QString& pane) {
  trigger(c, "savePicture");
  auto* dialog = c.find<QDialog>("pictureDialog");
  if (!dialog || !QTest::qWaitFor([&] { return dialog->isVisible(); })) return nullptr;
  auto* list = dialog->findChild<QComboBox*>("picturePane");
  c.choose(list, entry(list, pane));
  return list->currentText() == pane ? dialog : nullptr;
}

void press(WindowCase& c, QDialog* dialog, const char* button) {
  c.click(dialog->findChild<QPushButton*>(button));
  QTRY_VERIFY(!c.find<QDialog>("pictureDialog"));
}

/// Waits until the layout has made room for what the panels say.
void settled(WindowCase& c) {
  QSize size;
  do {
    size = c.window->views().surface()->size();
    QTest::qWait(200);
  } while (size != c.window->views().surface()->size());
}

/// Pixels that are as yellow as the crosshair.
int yellow(const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      count += c.red() > c.blue() + 60 && c.green() > c.blue() + 50 ? 1 : 0;
    }
  return count;
}

double difference(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
  return sum / (a.width() * a.height());
}

}  // namespace

/// Pictures of the panes on their way out.
class TestPictures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aPaneIsSavedAsItIsSeen_data() {
    QTest::addColumn<QString>("pane");
    QTest::addColumn<QString>("title");
    QTest::newRow("axial") << "axial"
                           << "axial";
    QTest::newRow("3D") << "surface3d"
                        << "3D";
  }
  void aPaneIsSavedAsItIsSeen() {
    QFETCH(QString, pane);
    QFETCH(QString, title);
    PortCase c;
    auto* view = c.find<VtkView>(pane);
    for (const int scale : {1, 2}) {
      c.savePath = c.folder.filePath(QString("p%1").arg(scale));
      settled(c);
      const QImage seen = view->grabFramebuffer();
      QCOMPARE(seen.size(), view->size() * view->devicePixelRatioF());
      QDialog* dialog = pictureOf(c, title);
      QVERIFY(dialog);
      auto* crosshair = dialog->findChild<QCheckBox*>("pictureCrosshair");
      QVERIFY(!crosshair->isChecked());
      if (crosshair->isVisible())
        QTest::mouseClick(crosshair, Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
      c.choose(dialog->findChild<QComboBox*>("pictureScale"), scale - 1);
      press(c, dialog, "pictureSave");
      QTRY_VERIFY(QFile::exists(c.savePath + ".png"));
      const QImage saved(c.savePath + ".png");
      QCOMPARE(saved.size(), seen.size() * scale);
      QVERIFY(saved.textKeys().isEmpty());
      const double off = difference(
          saved.scaled(seen.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation), seen);
      QVERIFY2(off < (scale == 1 ? 0.5 : kSharper), qPrintable(QString::number(off)));
    }
    QTRY_VERIFY(logOf(c).contains("Saved p2.png"));
  }

  void aZoomedPaneKeepsItsPart() {
    PortCase c;
    settled(c);
    SliceView* view = c.window->views().slice(2);
    for (int i = 0; i < 3; ++i)
      test::wheel(*view, view->rect().center(), QPoint(0, 120), Qt::ControlModifier);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(view, &leave);
    const QImage seen = view->grabFramebuffer();
    const QImage twice = c.window->views().picture(view, 2, true);
    const double off = difference(
        twice.scaled(seen.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation), seen);
    QVERIFY2(off < kSharper, qPrintable(QString::number(off)));
    QVERIFY(difference(view->grabFramebuffer(), seen) < 0.01);
  }

  void theCrosshairIsLeftOut() {
    PortCase c;
    SliceView* view = c.window->views().slice(2);
    const int with = yellow(c.window->views().picture(view, 1, true));
    const int without = yellow(c.window->views().picture(view, 1, false));
    QVERIFY2(with > without + 100, qPrintable(QString("%1 %2").arg(with).arg(without)));
    QVERIFY(yellow(view->grabFramebuffer()) > without + 100);
  }

  void allPanesLieAsInTheWindow() {
    PortCase c;
    c.savePath = c.folder.filePath("all");
    settled(c);
    const ViewGrid& views = c.window->views();
    const QSize size = views.size() * views.devicePixelRatioF();
    const QRect part(views.surface()->mapTo(&views, QPoint(0, 0)), views.surface()->size());
    const QImage seen = views.surface()->grabFramebuffer();
    QDialog* dialog = pictureOf(c, "all panes");
    QVERIFY(dialog);
    press(c, dialog, "pictureSave");
    QTRY_VERIFY(QFile::exists(c.savePath + ".png"));
    const QImage all(c.savePath + ".png");
    QCOMPARE(all.size(), size);
    QVERIFY(difference(all.copy(part), seen) < 0.5);
    // Alone, a pane is what there is.
    c.window->views().toggleMaximised(c.window->views().slice(1));
    trigger(c, "savePicture");
    auto* list = c.find<QDialog>("pictureDialog")->findChild<QComboBox*>("picturePane");
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->currentText(), QString("coronal"));
  }

  void aPictureIsCopied() {
    PortCase c;
    QGuiApplication::clipboard()->clear();
    settled(c);
    const QSize size = c.window->views().slice(0)->size();
    QDialog* dialog = pictureOf(c, "sagittal");
    QVERIFY(dialog);
    press(c, dialog, "pictureCopy");
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), size);
    trigger(c, "copyPicture");
    QVERIFY(!QGuiApplication::clipboard()->image().isNull());
  }

  void nothingIsLeftWhereItCannotBeWritten() {
    PortCase c;
    c.savePath = c.folder.filePath("none/p");
    QDialog* dialog = pictureOf(c, "axial");
    QVERIFY(dialog);
    press(c, dialog, "pictureSave");
    QTRY_VERIFY(logOf(c).contains("Cannot save the picture"));
    QVERIFY(!logOf(c).contains(c.folder.path()));
  }

  void aTurntableIsAFolderOfPictures() {
    PortCase c;
    settled(c);
    const QImage before = c.view()->grabFramebuffer();
    c.savePath = c.folder.filePath("v");
    const auto start = [&] {
      QDialog* dialog = pictureOf(c, "turntable of the 3D pane");
      if (!dialog || dialog->findChild<QPushButton*>("pictureCopy")->isEnabled()) return false;
      press(c, dialog, "pictureSave");
      return true;
    };
    QVERIFY(start());
    c.window->resize(c.window->size() - QSize(60, 40));  // they stay as large as the first one
    const QDir folder(c.savePath + "-turntable");
    QTRY_VERIFY_WITH_TIMEOUT(folder.exists(), kPatienceMs);
    QCOMPARE(folder.entryList({"*.png"}).size(), 36);
    QCOMPARE(folder.entryList(QDir::Files | QDir::Hidden).size(), 36);
    const auto picture = [&](int number) {
      return QImage(folder.filePath(QString("%1.png").arg(number, 3, 10, QChar('0'))));
    };
    const double first = difference(picture(1), before);
    QVERIFY2(first < 0.5, qPrintable(QString::number(first)));
    // A tenth of a turn is seen, and the last step closes the circle.
    QVERIFY(difference(picture(1), picture(10)) > 1.0);
    QVERIFY(difference(picture(1), picture(36)) < difference(picture(1), picture(10)));
    QTRY_VERIFY(c.view()->isEnabled());
    for (const int number : {2, 20, 36}) QCOMPARE(picture(number).size(), before.size());
    // Another one does not take its place.
    QVERIFY(start());
    QTRY_VERIFY(logOf(c).contains("there is such a folder already"));
    QVERIFY(c.view()->isEnabled());
    QCOMPARE(folder.entryList({"*.png"}).size(), 36);
  }

  void aTurntableIsGivenUpWithEscape() {
    PortCase c;
    c.savePath = c.folder.filePath("v");
    QDialog* dialog = pictureOf(c, "turntable of the 3D pane");
    QVERIFY(dialog);
    auto* cancel = c.window->findChild<QAction*>("cancelRun");
    QVERIFY(!cancel->isEnabled());
    press(c, dialog, "pictureSave");
    QTRY_VERIFY(c.find<QLabel>("work")->text().contains("picture 3 of 36"));
    QVERIFY(cancel->isEnabled());
    QTest::keyClick(c.window.get(), Qt::Key_Escape);
    QTRY_VERIFY(logOf(c).contains("Gave up the turntable"));
    QVERIFY(QDir(c.folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    QVERIFY(!cancel->isEnabled());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestPictures>(argc, argv); }
#include "tst_pictures.moc"
