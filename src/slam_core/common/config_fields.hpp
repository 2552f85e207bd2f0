// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "slam_core/common/choice.hpp"

namespace slam {

/// The allowed numbers of a field.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_open = false;
  bool max_open = false;

  static Range above(double min) { return {min, Range().max, true, false}; }
  static Range atLeast(double min) { return {min, Range().max, false, false}; }
  static Range closed(double min, double max) { return {min, max, false, false}; }
  static Range open(double min, double max) { return {min, max, true, true}; }

  bool contains(double value) const;
  bool isEverything() const;
  std::string text() const;  ///< "[0, 1)", "> 0", "any number"
};

/// A field belongs to one of the two kinds of configuration file.
enum class Scope { kProduct, kRobot };

/// One field of a configuration struct, described once: the description feeds the YAML reader, the
/// ROS reader, the validator and the parameter tables of the documentation. Range and choices of a
/// list or map hold for each of its values.
struct Field {
  using Target =
      std::variant<bool*, int*, std::uint64_t*, double*, std::string*, std::vector<std::string>*,
                   std::vector<std::int64_t>*, std::vector<double>*,
                   std::map<std::int64_t, double>*, std::map<std::string, std::int64_t>*, Choice*>;
  /// Empty, or what is wrong with a text: one clause.
  using FaultOfText = std::string (*)(const std::string& value);

  std::string name;
  Target target;
  std::string sentence;
  std::string unit_text;
  Range range;
  std::vector<std::string> choices;
  Scope scope = Scope::kProduct;
  bool is_live = false;  ///< may change while a nodelet runs; only nodelets set it
  FaultOfText fault_of_text = nullptr;

  Field& unit(const std::string& text) { return unit_text = text, *this; }
  Field& in(const Range& allowed) { return range = allowed, *this; }
  Field& oneOf(std::vector<std::string> names) { return choices = std::move(names), *this; }
  Field& checkedBy(FaultOfText faultOf) { return fault_of_text = faultOf, *this; }
  Field& ofRobot() { return scope = Scope::kRobot, *this; }

  std::string typeName() const;
  bool isText() const;
  bool isListOrMap() const;
  std::string valueText() const;  ///< as YAML would have it, texts unquoted
  /// Empty when the value in force is allowed, else what is wrong with it.
  std::string fault() const;
};

/// Filled by a configuration struct's describe().
class Fields {
 public:
  Field& add(const std::string& name, Field::Target target, const std::string& sentence) {
    return fields_.emplace_back(Field{name, target, sentence, "", {}, {}, Scope::kProduct});
  }
  /// One of an enumeration's values, by these names.
  template <class Enum>
  Field& add(const std::string& name, Enum* value, const Names<Enum>& names,
             const std::string& sentence) {
    choices_.push_back(std::make_shared<Choice>(value, names));
    return add(name, choices_.back().get(), sentence).oneOf(choices_.back()->names());
  }
  const std::deque<Field>& all() const { return fields_; }
  const Field* find(const std::string& name) const;
  std::vector<std::string> names() const;

 private:
  std::deque<Field> fields_;  // a deque: add() hands out references that must stay valid
  std::vector<std::shared_ptr<Choice>> choices_;
};

/// @throw ConfigError listing every field of `config` outside its range
template <class Config>
void validate(Config config);

/// The implementation of validate(), for any struct with describe().
void validateFields(const std::string& section, const Fields& fields);

template <class Config>
void validate(Config config) {
  Fields fields;
  config.describe(fields);
  validateFields(Config::kSection, fields);
}

}  // namespace slam
