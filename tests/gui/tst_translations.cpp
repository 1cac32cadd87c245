// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

#include "core/parameters/field.h"
#include "gui/language.h"
#include "gui/model/step_text.h"
#include "gui/view/slice_text.h"

using namespace angiomesh;

namespace {

struct Message {
  QString context, source, translation;
  bool finished = true;
};

std::vector<Message> messagesOf(const QString& path) {
  std::vector<Message> messages;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return messages;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (!xml.readNextStartElement()) continue;
    if (xml.name() == QStringLiteral("name")) context = xml.readElementText();
    if (xml.name() == QStringLiteral("source"))
      messages.push_back({context, xml.readElementText(), {}, true});
    if (xml.name() == QStringLiteral("translation")) {
      Message& last = messages.back();
      last.finished = !xml.attributes().hasAttribute("type");
      last.translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    }
  }
  return messages;
}

QStringList found(const QString& text, const char* pattern) {
  QStringList all;
  for (auto at = QRegularExpression(pattern).globalMatch(text); at.hasNext();)
    all << at.next().captured();
  all.sort();
  return all;
}

QString sheetOf(const QString& code) {
  return QStringLiteral(ANGIOMESH_SOURCE_DIR "/resources/translations/angiomesh_%1.ts").arg(code);
}

}  // namespace

class TestTranslations : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyTextIsInEachSheet_data() { translated_data(); }
  void everyTextIsInEachSheet() {
    QFETCH(QString, code);
    QTemporaryDir folder;
    const QString copy = folder.filePath("sheet_" + code + ".ts");
    QVERIFY(QFile::copy(sheetOf(code), copy));
    QProcess lupdate;
    QStringList arguments = QStringLiteral(ANGIOMESH_TEXT_SEARCH).split('|');
    lupdate.start(QStringLiteral(ANGIOMESH_LUPDATE), arguments << "-ts" << copy);
    QVERIFY(lupdate.waitForFinished(60000));
    QCOMPARE(lupdate.exitCode(), 0);
    const auto keys = [](const QString& path) {
      QStringList all;
      for (const Message& message : messagesOf(path))
        all << message.context + ": " + message.source;
      return all;
    };
    const QStringList now = keys(copy), kept = keys(sheetOf(code));
    QVERIFY(now.size() > 800);
    // The context that the running program asks with: its class, or one that a call names.
    static const QRegularExpression asked(
        "^(angiomesh::|QObject|Parameter|Quality(Gate|Measure)?|TriangleMeasure|MeshFormat|"
        "Preset|WindowPreset|Shortcut|CasePorts|Report)");
    for (const QString& key : now) QVERIFY2(asked.match(key).hasMatch(), qPrintable(key));
    for (const QString& key : now)
      QVERIFY2(kept.contains(key),
               qPrintable("build the target translations, and fill in: " + key));
    for (const QString& key : kept)
      QVERIFY2(now.contains(key), qPrintable("build the target translations; no longer: " + key));
  }

  void translationsAreWhole_data() { translated_data(); }
  void translationsAreWhole() {
    QFETCH(QString, code);
    for (const Message& m : messagesOf(sheetOf(code))) {
      const QByteArray where = (m.context + ": " + m.source).toUtf8();
      QVERIFY2(m.finished && !m.translation.trimmed().isEmpty(), where.constData());
      // Places for values, mark-up and the lines of a text are the same.
      for (const char* pattern : {"%[0-9L]+|%n", "</?[a-z][^>]*>", "\n"})
        QVERIFY2(found(m.source, pattern) == found(m.translation, pattern), where.constData());
      const bool opens = m.source.endsWith("...");
      QVERIFY2(opens == m.translation.endsWith("..."), where.constData());
      // A shortcut is not a word: Qt reads it in English.
      static const QRegularExpression keys("^((Ctrl|Shift|Alt|Meta)\\+)+[A-Za-z0-9]+$");
      if (m.context != "Shortcut" && keys.match(m.source).hasMatch())
        QCOMPARE(m.translation, m.source);
    }
  }

  void theWindowSpeaksIt_data() { translated_data(); }
  void theWindowSpeaksIt() {
    QFETCH(QString, code);
    QTranslator texts;
    QVERIFY(texts.load(":/translations/angiomesh_" + code + ".qm"));
    QCoreApplication::installTranslator(&texts);
    const Field& field = findField("levelset.xi");
    QVERIFY(labelOf(field) != QString::fromStdString(field.label));
    QVERIFY(labelOf(field).contains(QStringLiteral("ξ")));
    QVERIFY(stepTitle(Step::Evolve) != factsOf(Step::Evolve).title);
    QVERIFY(sliceWords().planes[1] != SliceWords().planes[1]);
    QVERIFY(sliceWords().slabs[3] != SliceWords().slabs[3]);
    QCoreApplication::removeTranslator(&texts);
    QCOMPARE(labelOf(field), QString::fromStdString(field.label));
  }

 private:
  static void translated_data() {
    QTest::addColumn<QString>("code");
    for (const Language& language : languages())
      if (language.code != "en") QTest::newRow(qPrintable(language.code)) << language.code;
  }
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
