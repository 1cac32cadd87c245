// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters/presets.h"
#include "gui/model/case_document.h"

namespace angiomesh {

/// The presets that can be chosen: those that come with the program, then the user's own by name,
/// which the settings keep. It knows which of them the document's parameters come from.
class PresetShelf : public QObject {
  Q_OBJECT

 public:
  /// Longest name and sentence, letters.
  static constexpr int kLongestName = 40, kLongestAbout = 200;

  explicit PresetShelf(CaseDocument& document, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<Preset>& all() const { return all_; }
  /// Null: there is none of that name.
  [[nodiscard]] const Preset* find(const QString& name) const;
  [[nodiscard]] bool isOwn(const QString& name) const;
  /// Of a shipped one in the window's language.
  [[nodiscard]] QString about(const Preset& preset) const;

  /// The one that the parameters, places aside, are equal to; empty: none.
  [[nodiscard]] QString current() const;
  /// The one that they were equal to last; of a case that began with others, the nearest.
  [[nodiscard]] const Preset& base() const { return all_[base_]; }

  /// Puts a preset into the document, places aside: one edit. @pre there is one of that name
  void apply(const QString& name);
  /// Keeps an own preset, in place of one of its name. @returns why not, in a line; empty: done
  QString keep(Preset preset);
  /// @pre isOwn()
  void forget(const QString& name);

  /// The one that was chosen last for a modality, else the one made for it.
  [[nodiscard]] const Preset& beginningFor(const std::string& modality) const;

 Q_SIGNALS:
  void changed();  ///< all()
  void chosen(const QString& name);

 private:
  void follow();
  void setBase(const std::string& name);
  void readOwn();
  void writeOwn() const;

  CaseDocument& document_;
  std::vector<Preset> all_;
  QStringList unread_;  ///< own ones, of another version of the program: kept as they are
  std::size_t base_ = 0;
  std::weak_ptr<const Pipeline> seen_;  ///< of the case that base_ is for
};

}  // namespace angiomesh
