// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slam {

/// What configuration files call the values of an enumeration.
template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

/// Empty where the value has no name.
template <class Enum>
std::string nameOf(Enum value, const Names<Enum>& names) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const auto& entry) { return entry.second == value; });
  return found == names.end() ? "" : found->first;
}

/// A value of an enumeration that is read and written by its name.
class Choice {
 public:
  template <class Enum>
  Choice(Enum* value, const Names<Enum>& names)
      : text_([value, names] { return nameOf(*value, names); }),
        assign_([value, names](const std::string& text) {
          for (const auto& [name, named] : names)
            if (name == text) *value = named;
        }) {
    for (const auto& entry : names) names_.push_back(entry.first);
  }

  const std::vector<std::string>& names() const { return names_; }
  /// The name of the value in force, or the last text that was no name.
  std::string text() const { return wrong_.value_or(text_()); }
  /// What is no name leaves the value as it is.
  void assign(const std::string& text) {
    assign_(text);
    wrong_ = text_() == text ? std::nullopt : std::make_optional(text);
  }

 private:
  std::vector<std::string> names_;
  std::function<std::string()> text_;
  std::function<void(const std::string&)> assign_;
  std::optional<std::string> wrong_;
};

}  // namespace slam
