// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/parameters/field.h"

// What the one description of the parameters is written with.
namespace angiomesh {

/// What a slider's ends are given in.
/// Level: windows above the level.
enum class SliderUnit { Value, Voxel, Window, Level };

/// A field while it is described; each call returns the row.
class Row {
 public:
  explicit Row(Field& field) : field_(field) {}

  Row& main() { return set(field_.main, true); }
  Row& logarithmic() { return set(field_.logarithmic, true); }
  Row& emptyWord(const char* word) { return set(field_.emptyWord, word); }
  Row& rises(const char* what) { return set(field_.rise, what); }
  Row& place() { return set(field_.place, true); }
  Row& ofSpeed() { return set(field_.ofSpeed, true); }
  /// A form shows the value times this.
  Row& shownTimes(double factor) { return set(field_.shownTimes, factor); }
  /// It is in no key: what it changes is given at once.
  Row& remakesNothing() { return set(field_.remakes, false); }
  Row& ofMask(Step step) { return set(field_.ofMask, step); }
  Row& onlyOfMask(Step step) {
    field_.ofScan.reset();
    return ofMask(step);
  }
  Row& notBelow(const char* key) { return set(field_.notBelow, key); }
  Row& above(const char* key) {
    field_.strictlyAbove = true;
    return notBelow(key);
  }
  /// Besides what makes its section idle.
  Row& idle(const IdleReason& why) {
    return set(field_.idle, [section = field_.idle, why](const Parameters& p) {
      const std::string of = section ? section(p) : "";
      return of.empty() ? why(p) : of;
    });
  }
  Row& suggest(std::function<double(const Parameters&, const FieldContext&)> value) {
    return set(field_.suggestion, std::move(value));
  }
  Row& slider(double low, double high, SliderUnit unit = SliderUnit::Value) {
    return set(field_.slider, [low, high, unit](const FieldContext& c) {
      const double one = unit == SliderUnit::Voxel   ? c.voxelMm
                         : unit == SliderUnit::Value ? 1.0
                                                     : c.window;
      const double zero = unit == SliderUnit::Level ? c.level : 0.0;
      return std::array<double, 2>{zero + low * one, zero + high * one};
    });
  }
  Row& slider(std::function<std::array<double, 2>(const FieldContext&)> ends) {
    return set(field_.slider, std::move(ends));
  }

 private:
  template <class T, class V>
  Row& set(T& member, V&& value) {
    member = std::forward<V>(value);
    return *this;
  }

  Field& field_;
};

/// Which images the fields of a section are read of.
enum class ReadOf { Scans, All };

/// Collects the fields; each add...() names a member by a function Parameters& -> member&.
class FieldTable {
 public:
  /// The rows that follow belong to this step, and have no effect where `idle` gives a reason.
  void begin(Step step, ReadOf images, IdleReason idle = {}) {
    step_ = step;
    images_ = images;
    idle_ = std::move(idle);
  }

  template <class M>
  Row real(const char* key, const char* label, M member, double minimum, double maximum,
           const char* unit, const char* help) {
    Field& field = add(key, label, FieldKind::Real, minimum, maximum, unit, help);
    bind<double>(field, member);
    return Row(field);
  }

  template <class M>
  Row integer(const char* key, const char* label, M member, double minimum, double maximum,
              const char* help) {
    Field& field = add(key, label, FieldKind::Integer, minimum, maximum, "", help);
    bind<std::int64_t>(field, member);
    return Row(field);
  }

  /// A whole number of which 0 stands for "none".
  template <class M>
  Row countOrNone(const char* key, const char* label, M member, double minimum, double maximum,
                  const char* help) {
    Field& field = add(key, label, FieldKind::Integer, minimum, maximum, "", help);
    field.emptyWord = "none";
    field.zeroIsEmpty = true;
    field.get = [member](const Parameters& p) -> FieldValue {
      const int count = member(const_cast<Parameters&>(p));
      if (count == 0) return std::monostate{};
      return static_cast<std::int64_t>(count);
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* count = std::get_if<std::int64_t>(&value);
      member(p) = count != nullptr ? static_cast<int>(*count) : 0;
    };
    return Row(field);
  }

  template <class M>
  Row boolean(const char* key, const char* label, M member, const char* help) {
    Field& field = add(key, label, FieldKind::Boolean, 0.0, 1.0, "", help);
    bind<bool>(field, member);
    return Row(field);
  }

  /// The enumerators of the member's type in order, by name.
  template <class M>
  Row choice(const char* key, const char* label, M member, std::vector<std::string> names,
             const char* help) {
    Field& field = add(key, label, FieldKind::Choice, 0.0, 0.0, "", help);
    field.choices = names;
    field.get = [member, names](const Parameters& p) -> FieldValue {
      return names[static_cast<std::size_t>(member(const_cast<Parameters&>(p)))];
    };
    field.put = [member, names](Parameters& p, const FieldValue& value) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == std::get<std::string>(value)) {
          auto& to = member(p);
          to = static_cast<std::remove_reference_t<decltype(to)>>(i);
        }
    };
    return Row(field);
  }

  /// x,y,z,... in mm LPS
  template <class M>
  Row points(const char* key, const char* label, M member, const char* help) {
    Field& field = add(key, label, FieldKind::Numbers, -1e5, 1e5, "mm", help);
    field.groupOf = 3;
    bindList<double>(field, member);
    return Row(field);
  }

  /// Each of the form that `check` takes; none is the empty list.
  template <class M>
  Row texts(const char* key, const char* label, M member, const char* form, const char* help,
            std::function<void(const std::string&)> check) {
    Field& field = add(key, label, FieldKind::Texts, 0.0, 0.0, "", help);
    field.form = form;
    field.check = std::move(check);
    bindList<std::string>(field, member);
    return Row(field);
  }

  template <class M>
  Row box(const char* key, const char* label, M member, const char* help) {
    Field& field = add(key, label, FieldKind::Numbers, -1e5, 1e5, "mm", help);
    field.groupOf = 6;
    field.emptyWord = "none";
    field.get = [member](const Parameters& p) -> FieldValue {
      const auto& corners = member(const_cast<Parameters&>(p));
      if (!corners) return std::monostate{};
      return std::vector<double>(corners->begin(), corners->end());
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* numbers = std::get_if<std::vector<double>>(&value);
      auto& corners = member(p);
      if (numbers == nullptr) {
        corners.reset();
        return;
      }
      corners.emplace();
      for (std::size_t i = 0; i < 6; ++i) (*corners)[i] = (*numbers)[i];
    };
    return Row(field);
  }

  std::vector<Field> take() { return {fields_.begin(), fields_.end()}; }

 private:
  Field& add(const char* key, const char* label, FieldKind kind, double minimum, double maximum,
             const char* unit, const char* help) {
    Field field;
    field.key = key;
    field.label = label;
    field.step = step_;
    field.ofScan = step_;
    if (images_ == ReadOf::All) field.ofMask = step_;
    field.kind = kind;
    field.minimum = minimum;
    field.maximum = maximum;
    field.unit = unit;
    field.help = help;
    field.idle = idle_;
    fields_.push_back(std::move(field));
    return fields_.back();
  }

  /// A member of type T, int or an optional of them. Stored is the variant's alternative V.
  template <class V, class M>
  void bind(Field& field, M member) {
    using T = std::remove_reference_t<decltype(member(std::declval<Parameters&>()))>;
    if constexpr (requires(T t) { t.has_value(); }) {
      field.emptyWord = "auto";
      field.get = [member](const Parameters& p) -> FieldValue {
        const auto& value = member(const_cast<Parameters&>(p));
        if (!value) return std::monostate{};
        return static_cast<V>(*value);
      };
      field.put = [member](Parameters& p, const FieldValue& value) {
        if (std::holds_alternative<std::monostate>(value))
          member(p).reset();
        else
          member(p) = static_cast<typename T::value_type>(std::get<V>(value));
      };
    } else {
      field.get = [member](const Parameters& p) -> FieldValue {
        return static_cast<V>(member(const_cast<Parameters&>(p)));
      };
      field.put = [member](Parameters& p, const FieldValue& value) {
        member(p) = static_cast<T>(std::get<V>(value));
      };
    }
  }

  /// A vector, of which the empty one is "none".
  template <class V, class M>
  void bindList(Field& field, M member) {
    field.emptyWord = "none";
    field.get = [member](const Parameters& p) -> FieldValue {
      const std::vector<V>& all = member(const_cast<Parameters&>(p));
      if (all.empty()) return std::monostate{};
      return all;
    };
    field.put = [member](Parameters& p, const FieldValue& value) {
      const auto* all = std::get_if<std::vector<V>>(&value);
      member(p) = all != nullptr ? *all : std::vector<V>{};
    };
  }

  std::deque<Field> fields_;
  Step step_ = Step::Preprocess;
  ReadOf images_ = ReadOf::All;
  IdleReason idle_;
};

/// The member of the parameters that a field stores, for FieldTable.
#define ANGIOMESH_MEMBER(path) \
  [](Parameters & p) -> auto& { return p.path; }

/// Of scans until there is a speed; of the segmentation; of the rest.
void addScanFields(FieldTable& table);
void addSegmentationFields(FieldTable& table);
void addSurfaceFields(FieldTable& table);

}  // namespace angiomesh
