// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "core/parameters/parameters.h"

// What the one description of the parameters is written with.
namespace angiomesh {

/// Collects the fields; each add...() names a member by a function Parameters& -> member&.
class FieldTable {
 public:
  template <class M>
  Field& real(const char* key, M member, double minimum, double maximum, const char* unit,
              const char* help) {
    Field& field = add(key, FieldKind::Real, minimum, maximum, unit, help);
    bind<double>(field, member);
    return field;
  }

  template <class M>
  Field& integer(const char* key, M member, double minimum, double maximum, const char* help) {
    Field& field = add(key, FieldKind::Integer, minimum, maximum, "", help);
    bind<std::int64_t>(field, member);
    return field;
  }

  /// A whole number of which 0 stands for "none".
  template <class M>
  Field& countOrNone(const char* key, M member, double minimum, double maximum, const char* help) {
    Field& field = add(key, FieldKind::Integer, minimum, maximum, "", help);
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
    return field;
  }

  template <class M>
  Field& boolean(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Boolean, 0.0, 1.0, "", help);
    bind<bool>(field, member);
    return field;
  }

  /// The enumerators of the member's type in order, by name.
  template <class M>
  Field& choice(const char* key, M member, std::vector<std::string> names, const char* help) {
    Field& field = add(key, FieldKind::Choice, 0.0, 0.0, "", help);
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
    return field;
  }

  /// x,y,z,... in mm LPS
  template <class M>
  Field& points(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Numbers, -1e5, 1e5, "mm", help);
    field.groupOf = 3;
    bindList<double>(field, member);
    return field;
  }

  /// Each of the form that `check` takes; none is the empty list.
  template <class M>
  Field& texts(const char* key, M member, const char* form, const char* help,
               std::function<void(const std::string&)> check) {
    Field& field = add(key, FieldKind::Texts, 0.0, 0.0, "", help);
    field.form = form;
    field.check = std::move(check);
    bindList<std::string>(field, member);
    return field;
  }

  template <class M>
  Field& box(const char* key, M member, const char* help) {
    Field& field = add(key, FieldKind::Numbers, -1e5, 1e5, "mm", help);
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
    return field;
  }

  std::vector<Field> take() { return std::move(fields_); }

 private:
  Field& add(const char* key, FieldKind kind, double minimum, double maximum, const char* unit,
             const char* help) {
    Field field;
    field.key = key;
    field.kind = kind;
    field.minimum = minimum;
    field.maximum = maximum;
    field.unit = unit;
    field.help = help;
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

  std::vector<Field> fields_;
};

/// The member of the parameters that a field stores, for FieldTable.
#define ANGIOMESH_MEMBER(path) \
  [](Parameters & p) -> auto& { return p.path; }

/// The fields of the ports, the surface and smoothing.
void addSurfaceFields(FieldTable& table);

}  // namespace angiomesh
