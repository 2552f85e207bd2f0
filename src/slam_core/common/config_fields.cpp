// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/config_fields.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "slam_core/common/config_error.hpp"

namespace slam {
namespace {

std::string numberText(double value) {
  std::ostringstream text;
  text.precision(15);
  text << value;
  return text.str();
}

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

}  // namespace

bool Range::contains(double value) const {
  return (min_open ? value > min : value >= min) && (max_open ? value < max : value <= max);
}

bool Range::isEverything() const { return std::isinf(min) && std::isinf(max); }

std::string Range::text() const {
  if (isEverything()) return "any number";
  if (std::isinf(max)) return (min_open ? "> " : ">= ") + numberText(min);
  if (std::isinf(min)) return (max_open ? "< " : "<= ") + numberText(max);
  return (min_open ? "(" : "[") + numberText(min) + ", " + numberText(max) + (max_open ? ")" : "]");
}

std::string Field::typeName() const {
  static const char* const kNames[] = {"bool",   "integer", "non-negative integer",
                                       "number", "text",    "list of texts"};
  return kNames[target.index()];
}

std::string Field::valueText() const {
  return std::visit(
      Overloaded{[](const bool* v) { return std::string(*v ? "true" : "false"); },
                 [](const int* v) { return std::to_string(*v); },
                 [](const std::uint64_t* v) { return std::to_string(*v); },
                 [](const double* v) { return numberText(*v); },
                 [](const std::string* v) { return *v; },
                 [](const std::vector<std::string>* v) { return "[" + join(*v) + "]"; }},
      target);
}

std::string Field::fault() const {
  const auto outside = [this](double value) {
    return std::isfinite(value) && range.contains(value)
               ? std::string()
               : valueText() + " is not allowed; the range is " + range.text();
  };
  return std::visit(
      Overloaded{[](const bool*) { return std::string(); },
                 [&](const int* v) { return outside(*v); },
                 [&](const std::uint64_t* v) { return outside(static_cast<double>(*v)); },
                 [&](const double* v) { return outside(*v); },
                 [this](const std::string* v) {
                   if (choices.empty() || std::count(choices.begin(), choices.end(), *v) > 0)
                     return std::string();
                   return "'" + *v + "' is not one of: " + join(choices) + didYouMean(*v, choices);
                 },
                 [](const std::vector<std::string>*) { return std::string(); }},
      target);
}

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
