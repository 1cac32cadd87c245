// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "core/image/projection.h"
#include "fresh_window.h"
#include "gui/recent_cases.h"
#include "io/volume/image_write.h"

using namespace angiomesh;
using angiomesh::test::FreshWindow;
using angiomesh::test::kPatienceMs;
using angiomesh::test::twoTubes;
using angiomesh::test::WindowCase;

class TestWelcome : public QObject {
  Q_OBJECT

 private:
  static QString saveTubes(const QTemporaryDir& folder) {
    const QString path = folder.filePath("tubes.mha");
    writeVolume(*twoTubes().image, path.toStdString());
    return path;
  }
  static QString breakFile(const QTemporaryDir& folder) {
    const QString path = folder.filePath("broken.nrrd");
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write("NRRD0004\n");
    return path;
  }

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void aPageStandsInForEmptyPanes() {
    WindowCase c;
    auto* page = c.find<QWidget>("welcome");
    QVERIFY(page->isVisible() && !c.window->views().isVisible());
    QVERIFY(!c.find<QListWidget>("recentList")->isVisible());
    c.openPath = saveTubes(c.folder);
    c.click(c.find<QPushButton>("openButton"));
    QTRY_VERIFY(c.window->views().isVisible());
    QVERIFY(!page->isVisible());
    QCOMPARE(c.models().document.caseName(), QString("tubes"));
    QVERIFY(c.window->views().slice(2)->isVisible());
  }

  void itsButtonsOpenFoldersAndTheSample() {
    {
      WindowCase c;
      c.click(c.find<QPushButton>("openSampleButton"));
      QCOMPARE(c.models().document.caseName(), QString("sample"));
    }
    WindowCase c;
    c.openPath = saveTubes(c.folder);
    c.click(c.find<QPushButton>("openFolderButton"));
    QCOMPARE(c.models().document.caseName(), QString("tubes"));
  }

  void whatWasOpenedIsListedForTheNextTime() {
    const QTemporaryDir folder;
    const QString path = saveTubes(folder);
    {
      WindowCase c;
      c.window->open(path);
      QVERIFY(c.models().document.hasCase());
    }
    WindowCase c;
    auto* list = c.find<QListWidget>("recentList");
    QVERIFY(list->isVisible());
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->text(), QString("tubes.mha"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier,
                      list->visualItemRect(list->item(0)).center());
    QTRY_COMPARE(c.models().document.caseName(), QString("tubes"));
    QVERIFY(c.window->views().isVisible());
  }

  void whatWasOpenedHasAPicture() {
    const QTemporaryDir folder;
    const QString path = saveTubes(folder);
    {
      WindowCase c;
      c.window->open(path);
    }
    const QFile picture(RecentCases::pictureOf(path));
    QVERIFY(picture.exists());
    QCOMPARE(picture.permissions() & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteOther),
             QFile::Permissions());
    const QImage mip(picture.fileName());
    const Picture same = mipFromTheFront(*twoTubes().image, 96);
    QCOMPARE(mip.size(), QSize(same.width, same.height));
    QVERIFY(mip.convertToFormat(QImage::Format_RGB888) == QImage(same.rgb.data(), same.width,
                                                                 same.height, 3 * same.width,
                                                                 QImage::Format_RGB888));
    WindowCase c;
    auto* list = c.find<QListWidget>("recentList");
    const QImage icon = list->item(0)->icon().pixmap(list->iconSize()).toImage();
    QVERIFY(qAlpha(icon.pixel(icon.rect().center())) == 255);
    // No list, no pictures.
    c.window->findChild<QAction*>("forgetRecent")->trigger();
    QVERIFY(!list->isVisible());
    QVERIFY(!picture.exists());
  }

  void theTitleTellsFilesOfOneNameApart() {
    const QTemporaryDir folder;
    WindowCase c;
    for (const char* patient : {"one", "two"}) {
      QVERIFY(QDir(folder.path()).mkpath(patient));
      const QString path = folder.filePath(QString(patient) + "/mra.mha");
      writeVolume(*twoTubes().image, path.toStdString());
      c.window->open(path);
      QVERIFY2(c.window->windowTitle().startsWith(QString("mra (%1)").arg(patient)),
               qPrintable(c.window->windowTitle()));
    }
    c.window->openSample();
    QVERIFY(c.window->windowTitle().startsWith("sample"));
  }

  void aFileThatCannotBeOpenedIsSaidInTheMiddle() {
    WindowCase c;
    auto* banner = c.find<QWidget>("banner");
    QVERIFY(!banner->isVisible());
    c.openPath = breakFile(c.folder);
    c.click(c.find<QPushButton>("openButton"));
    QTRY_VERIFY(banner->isVisible());
    const QString text = c.find<QLabel>("bannerText")->text();
    QVERIFY2(text.contains("Cannot open") && text.contains("broken"), qPrintable(text));
    const QPoint centre = banner->mapTo(banner->parentWidget()->window(), banner->rect().center());
    const QWidget* middle = c.window->centralWidget();
    QVERIFY(std::abs(centre.x() - middle->mapTo(c.window.get(), middle->rect().center()).x()) < 3);
    c.openPath = saveTubes(c.folder);
    c.click(c.find<QPushButton>("openNext"));
    QTRY_COMPARE(c.models().document.caseName(), QString("tubes"));
    QVERIFY(!banner->isVisible());
  }

  void theBannerIsSeenOverThePanesToo() {
    FreshWindow w;
    w.window->models().files.take(twoTubes());
    auto* banner = w.window->findChild<QWidget*>("banner");
    auto* next = w.window->findChild<QPushButton*>("openNext");
    w.window->models().document.setField("seeds.automatic", false);
    w.clickTool("runAll");
    QTRY_VERIFY(banner->isVisible());
    QVERIFY(!next->isVisible());
    const auto* text = w.window->findChild<QLabel*>("bannerText");
    QVERIFY2(text->text().contains("Seeds failed"), qPrintable(text->text()));
    auto* log = w.window->findChild<QDockWidget*>("logDock");
    QVERIFY(!log->isVisible());
    QTest::mouseClick(w.window->findChild<QPushButton*>("showLogNext"), Qt::LeftButton);
    QTRY_VERIFY(log->isVisible());
    QVERIFY(!banner->isVisible());
    w.clickTool("runAll");
    QTRY_VERIFY(banner->isVisible());
    QTest::mouseClick(w.window->findChild<QPushButton*>("closeBanner"), Qt::LeftButton);
    QVERIFY(!banner->isVisible());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestWelcome>(argc, argv); }
#include "tst_welcome.moc"
