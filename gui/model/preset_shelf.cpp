// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/preset_shelf.h"

#include <QCoreApplication>
#include <QSettings>
#include <algorithm>

#include "core/base/error.h"
#include "core/parameters/field.h"
#include "gui/model/modality_habits.h"
#include "io/recipe/command_line.h"
#include "io/recipe/recipe_file.h"

namespace angiomesh {

namespace {

const QString kArray = QStringLiteral("presets");
const QString kRecipe = QStringLiteral("recipe");

/// A preset says nothing of places: these stay the document's.
bool equalBeside(const Parameters& params, const Parameters& preset) {
  Parameters candidate = preset;
  copyPlaces(params, candidate);
  return candidate == params;
}

std::size_t shippedCount() { return shippedPresets().size(); }

}  // namespace

PresetShelf::PresetShelf(CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  readOwn();
  connect(&document_, &CaseDocument::parametersChanged, this, &PresetShelf::follow);
}

const Preset* PresetShelf::find(const QString& name) const {
  const auto found = std::find_if(all_.begin(), all_.end(), [&](const Preset& preset) {
    return preset.name == name.toStdString();
  });
  return found == all_.end() ? nullptr : &*found;
}

bool PresetShelf::isOwn(const QString& name) const {
  const Preset* preset = find(name);
  return preset && preset - all_.data() >= static_cast<std::ptrdiff_t>(shippedCount());
}

QString PresetShelf::about(const Preset& preset) const {
  const QString own = QString::fromStdString(preset.about);
  return isOwn(QString::fromStdString(preset.name))
             ? own
             : QCoreApplication::translate("Preset", preset.about.c_str());
}

QString PresetShelf::current() const {
  for (const Preset& preset : all_)
    if (equalBeside(document_.parameters(), preset.params))
      return QString::fromStdString(preset.name);
  return {};
}

void PresetShelf::follow() {
  const Parameters& params = document_.parameters();
  const bool another = seen_.lock() != document_.pipeline();
  seen_ = document_.pipeline();
  // Two presets may be equal: the one that was chosen stays.
  if (!another && equalBeside(params, base().params)) return;
  for (std::size_t n = 0; n < all_.size(); ++n) {
    if (!equalBeside(params, all_[n].params)) continue;
    base_ = n;
    return;
  }
  if (another) setBase(nearestPreset(params).name);
}

void PresetShelf::apply(const QString& name) {
  const Preset* preset = find(name);
  Parameters after = preset->params;
  copyPlaces(document_.parameters(), after);
  setBase(preset->name);
  document_.change(after, tr("preset %1").arg(name));
  Q_EMIT chosen(name);
}

QString PresetShelf::keep(Preset preset) {
  QString name = QString::fromStdString(preset.name).simplified();
  if (name.isEmpty()) return tr("A preset needs a name.");
  if (name.size() > kLongestName)
    return tr("The name is too long: at most %1 letters.").arg(kLongestName);
  if (find(name) && !isOwn(name))
    return tr("%1 comes with the program: choose another name.").arg(name);
  preset.name = name.toStdString();
  preset.about =
      QString::fromStdString(preset.about).simplified().left(kLongestAbout).toStdString();
  copyPlaces(Parameters(), preset.params);
  const std::string baseName = base().name;
  readOwn();
  std::erase_if(all_, [&](const Preset& one) { return one.name == preset.name; });
  const auto own = all_.begin() + static_cast<std::ptrdiff_t>(shippedCount());
  all_.insert(std::upper_bound(own, all_.end(), preset,
                               [](const Preset& a, const Preset& b) { return a.name < b.name; }),
              preset);
  setBase(baseName);
  writeOwn();
  follow();
  Q_EMIT changed();
  return {};
}

void PresetShelf::forget(const QString& name) {
  const std::string baseName = base().name;
  readOwn();
  std::erase_if(all_, [&](const Preset& one) { return one.name == name.toStdString(); });
  setBase(baseName);
  writeOwn();
  follow();
  Q_EMIT changed();
}

void PresetShelf::setBase(const std::string& name) {
  const Preset* preset = find(QString::fromStdString(name));
  base_ = preset ? static_cast<std::size_t>(preset - all_.data()) : 0;
}

const Preset& PresetShelf::beginningFor(const std::string& modality) const {
  if (const Preset* known = find(rememberedPreset(modality))) return *known;
  return *find(modality == "CT" ? QStringLiteral("ct") : QStringLiteral("angiomesh"));
}

// Another window may have kept some since they were read.
void PresetShelf::readOwn() {
  all_ = shippedPresets();
  unread_.clear();
  QSettings settings;
  const int count = settings.beginReadArray(kArray);
  for (int n = 0; n < count; ++n) {
    settings.setArrayIndex(n);
    const QString text = settings.value(kRecipe).toString();
    try {
      all_.push_back(presetOf(recipeFromText(text.toStdString(), Parameters(), "preset"), {}));
    } catch (const Error&) {
      unread_ << text;
    }
  }
}

void PresetShelf::writeOwn() const {
  QStringList texts = unread_;
  for (std::size_t n = shippedCount(); n < all_.size(); ++n)
    texts << QString::fromStdString(recipeText(recipeOf(all_[n])));
  QSettings settings;
  settings.remove(kArray);
  settings.beginWriteArray(kArray, static_cast<int>(texts.size()));
  for (int n = 0; n < texts.size(); ++n) {
    settings.setArrayIndex(n);
    settings.setValue(kRecipe, texts[n]);
  }
  settings.endArray();
}

}  // namespace angiomesh
