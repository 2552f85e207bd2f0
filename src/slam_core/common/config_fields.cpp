// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/config_fields.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <type_traits>

#include "slam_core/common/config_error.hpp"

namespace slam {
namespace {

std::string scalarText(double value) {
  std::ostringstream text;
  text.precision(15);
  text << value;
  return text.str();
}
std::string scalarText(bool value) { return value ? "true" : "false"; }
std::string scalarText(int value) { return std::to_string(value); }
std::string scalarText(std::int64_t value) { return std::to_string(value); }
std::string scalarText(std::uint64_t value) { return std::to_string(value); }
std::string scalarText(const std::string& value) { return value; }
std::string scalarText(const Choice& value) { return value.text(); }

/// One value of a field, which may be one of many, against the field's range or choices.
std::string faultOfValue(const Field& field, double value, const std::string& text) {
  if (std::isfinite(value) && field.range.contains(value)) return "";
  const auto unit = field.unit_text.substr(0, field.unit_text.find(';'));  // a remark may follow
  const bool has_unit = !unit.empty() && unit != "1";
  return text + " is not allowed; the range is " + field.range.text() +
         (has_unit ? ", in " + unit : "");
}
std::string faultOfValue(const Field& field, const std::string& value, const std::string&) {
  if (field.fault_of_text) return field.fault_of_text(value);
  const auto& choices = field.choices;
  if (choices.empty() || std::count(choices.begin(), choices.end(), value) > 0) return "";
  return "'" + value + "' is not one of: " + join(choices) + didYouMean(value, choices);
}

std::string faultOfValue(const Field& field, const Choice& value, const std::string&) {
  return faultOfValue(field, value.text(), "");
}

template <class T>
std::string faultOfScalar(const Field& field, const T& value) {
  if constexpr (std::is_same_v<T, bool>) return "";
  if constexpr (std::is_arithmetic_v<T>)
    return faultOfValue(field, static_cast<double>(value), scalarText(value));
  else
    return faultOfValue(field, value, "");
}

/// What to do with each kind of target: a scalar, a list, a map.
struct TextOfTarget {
  template <class T>
  std::string operator()(const T* value) const {
    return scalarText(*value);
  }
  template <class T>
  std::string operator()(const std::vector<T>* list) const {
    std::vector<std::string> texts;
    for (const auto& value : *list) texts.push_back(scalarText(value));
    return "[" + join(texts) + "]";
  }
  template <class K, class V>
  std::string operator()(const std::map<K, V>* map) const {
    std::vector<std::string> texts;
    for (const auto& [key, value] : *map)
      texts.push_back(scalarText(key) + ": " + scalarText(value));
    return "{" + join(texts) + "}";
  }
};

struct FaultOfTarget {
  const Field& field;

  template <class T>
  std::string operator()(const T* value) const {
    return faultOfScalar(field, *value);
  }
  template <class T>
  std::string operator()(const std::vector<T>* list) const {
    for (const auto& value : *list)
      if (auto fault = faultOfScalar(field, value); !fault.empty()) return fault;
    return "";
  }
  template <class K, class V>
  std::string operator()(const std::map<K, V>* map) const {
    for (const auto& [key, value] : *map)
      if (const auto fault = faultOfScalar(field, value); !fault.empty())
        return scalarText(key) + ": " + fault;
    return "";
  }
};

}  // namespace

bool Range::contains(double value) const {
  return (min_open ? value > min : value >= min) && (max_open ? value < max : value <= max);
}

bool Range::isEverything() const { return std::isinf(min) && std::isinf(max); }

std::string Range::text() const {
  if (isEverything()) return "any number";
  if (std::isinf(max)) return (min_open ? "> " : ">= ") + scalarText(min);
  if (std::isinf(min)) return (max_open ? "< " : "<= ") + scalarText(max);
  return (min_open ? "(" : "[") + scalarText(min) + ", " + scalarText(max) + (max_open ? ")" : "]");
}

std::string Field::typeName() const {
  static const char* const kNames[] = {"bool",
                                       "integer",
                                       "non-negative integer",
                                       "number",
                                       "text",
                                       "list of texts",
                                       "list of integers",
                                       "list of numbers",
                                       "map of integers to numbers",
                                       "map of texts to integers",
                                       "text"};
  static_assert(std::size(kNames) == std::variant_size_v<Target>);
  return kNames[target.index()];
}

bool Field::isText() const {
  return std::holds_alternative<std::string*>(target) || std::holds_alternative<Choice*>(target);
}

bool Field::isListOrMap() const {
  return !isText() &&
         !std::visit(
             [](const auto* value) { return std::is_arithmetic_v<std::decay_t<decltype(*value)>>; },
             target);
}

std::string Field::valueText() const { return std::visit(TextOfTarget{}, target); }

std::string Field::fault() const { return std::visit(FaultOfTarget{*this}, target); }

const Field* Fields::find(const std::string& name) const {
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const Field& field) { return field.name == name; });
  return found == fields_.end() ? nullptr : &*found;
}

std::vector<std::string> Fields::names() const {
  std::vector<std::string> names;
  for (const auto& field : fields_) names.push_back(field.name);
  return names;
}

void validateFields(const std::string& section, const Fields& fields) {
  FaultCollector faults;
  for (const auto& field : fields.all()) {
    const auto fault = field.fault();
    const auto path = section.empty() ? field.name : section + "." + field.name;
    if (!fault.empty()) faults.add(path + ": " + fault);
  }
  faults.raise();
}

}  // namespace slam
