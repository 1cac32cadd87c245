// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include "tests/gui/window_case.h"

using namespace angiomesh;
using test::WindowCase;

class TestGuide : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void f1OpensThePageOfTheWindow() {
    WindowCase c;
    QTest::keyClick(c.window.get(), Qt::Key_F1);
    QTRY_VERIFY(c.find<QTextBrowser>("guideText"));
    auto* text = c.find<QTextBrowser>("guideText");
    QVERIFY(text->isVisible());
    QVERIFY(text->toPlainText().startsWith("Desktop program"));
    QVERIFY(!c.find<QTableWidget>("shortcutsTable")->isVisible());
    // The shortcuts are beside it, and Shift+F1 opens them in the same dialog.
    QTest::keyClick(c.window.get(), Qt::Key_F1, Qt::ShiftModifier);
    QTRY_VERIFY(c.find<QTableWidget>("shortcutsTable")->isVisible());
    QVERIFY(c.find<QTableWidget>("shortcutsTable")->rowCount() > 20);
    QCOMPARE(c.window->findChildren<QTextBrowser*>("guideText").size(), 1);
  }

  void everyPageOpensWithItsPictures() {
    WindowCase c;
    c.window->findChild<QAction*>("guide")->trigger();
    auto* list = c.find<QListWidget>("guidePages");
    auto* text = c.find<QTextBrowser>("guideText");
    QCOMPARE(list->count(), 1 + QDir(":/guide").entryList({"*.md"}).size());
    for (int row = 1; row < list->count(); ++row) {
      list->setCurrentRow(row);
      QVERIFY2(text->toPlainText().startsWith(list->item(row)->text()),
               qPrintable(list->item(row)->text()));
      for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
        for (auto at = block.begin(); !at.atEnd(); ++at)
          if (const QTextImageFormat format = at.fragment().charFormat().toImageFormat();
              format.isValid()) {
            const auto image =
                text->loadResource(QTextDocument::ImageResource, format.name()).value<QImage>();
            QVERIFY2(!image.isNull(), qPrintable(format.name()));
            QVERIFY(image.width() <= text->viewport()->width());
          }
    }
  }

  void everyLinkLeadsToAHeading() {
    WindowCase c;
    c.window->findChild<QAction*>("guide")->trigger();
    auto* text = c.find<QTextBrowser>("guideText");
    auto* list = c.find<QListWidget>("guidePages");
    static const QRegularExpression link("\\]\\(([^)]*\\.md)?(#[^)]*)?\\)");
    int followed = 0;
    for (const QString& name : QDir(":/guide").entryList({"*.md"})) {
      QFile file(":/guide/" + name);
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QString source = QString::fromUtf8(file.readAll());
      for (auto at = link.globalMatch(source); at.hasNext();) {
        const auto match = at.next();
        const QString page = match.captured(1).isEmpty() ? name : match.captured(1);
        QVERIFY2(QFile::exists(":/guide/" + page), qPrintable(name + ": " + page));
        list->setCurrentRow(0);
        Q_EMIT text->anchorClicked(QUrl(page + match.captured(2)));
        QVERIFY2(text->isVisible(), qPrintable(page));
        ++followed;
        if (match.captured(2).isEmpty()) continue;
        QVERIFY2(text->verticalScrollBar()->value() > 0, qPrintable(page + match.captured(2)));
      }
    }
    QVERIFY(followed > 20);
  }

  void wordsAreFoundInOtherPages() {
    WindowCase c;
    c.window->findChild<QAction*>("guide")->trigger();
    auto* text = c.find<QTextBrowser>("guideText");
    auto* wanted = c.find<QLineEdit>("guideFind");
    wanted->setText("blockMesh is no such word");
    QTest::keyClick(wanted, Qt::Key_Return);
    QVERIFY(text->toPlainText().startsWith("Desktop program"));
    wanted->setText("osculating");
    QTest::keyClick(wanted, Qt::Key_Return);
    QCOMPARE(text->textCursor().selectedText().toLower(), QString("osculating"));
    QVERIFY(!text->toPlainText().startsWith("Desktop program"));
    QVERIFY(c.find<QListWidget>("guidePages")->isVisible());
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestGuide>(argc, argv); }
#include "tst_guide.moc"
