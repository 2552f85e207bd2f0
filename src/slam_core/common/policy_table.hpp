// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slam {

/// The policies of one kind that there are, by the names that configuration files call them.
template <class Policy, class... Arguments>
class PolicyTable {
 public:
  using Make = std::unique_ptr<Policy> (*)(const Arguments&...);

  explicit PolicyTable(const std::vector<std::pair<std::string, Make>>& policies)
      : makers_(policies.begin(), policies.end()) {
    for (const auto& entry : policies) names_.push_back(entry.first);
  }

  /// In the order given.
  const std::vector<std::string>& names() const { return names_; }
  /// @throw std::out_of_range where `name` is none of names()
  std::unique_ptr<Policy> make(const std::string& name, const Arguments&... arguments) const {
    return makers_.at(name)(arguments...);
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, Make> makers_;
};

/// Makes one derived from a Policy, for a table.
template <class Policy, class Derived, class... Arguments>
std::unique_ptr<Policy> makePolicyOf(const Arguments&... arguments) {
  return std::make_unique<Derived>(arguments...);
}

}  // namespace slam
