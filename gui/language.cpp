// SPDX-License-Identifier: BSD-3-Clause
#include "gui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <memory>

namespace angiomesh {

namespace {

const QString kLanguageKey = QStringLiteral("language");

void install(const QLocale& locale, const QString& file, const QString& folder) {
  auto texts = std::make_unique<QTranslator>(QCoreApplication::instance());
  if (texts->load(locale, file, QStringLiteral("_"), folder))
    QCoreApplication::installTranslator(texts.release());
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all{{QStringLiteral("en"), QStringLiteral("English")},
                                         {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                         {QStringLiteral("tr"), QStringLiteral("Türkçe")}};
  return all;
}

QString rememberedLanguage() { return QSettings().value(kLanguageKey).toString(); }

void rememberLanguage(const QString& code) { QSettings().setValue(kLanguageKey, code); }

void applyLanguage(const QString& code) {
  const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
  if (!code.isEmpty()) QLocale::setDefault(locale);
  // The sources are English.
  if (locale.language() == QLocale::English) return;
  install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(locale, QStringLiteral("angiomesh"), QStringLiteral(":/translations"));
}

}  // namespace angiomesh
