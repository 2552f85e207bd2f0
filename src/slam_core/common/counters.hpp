// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace slam {

/// How often something worth a diagnostic has happened, by reason ("late", "gated", ...).
class Counters {
 public:
  void add(const std::string& reason, std::uint64_t times = 1) {
    if (times > 0) counts_[reason] += times;
  }
  std::uint64_t operator[](const std::string& reason) const {
    const auto found = counts_.find(reason);
    return found == counts_.end() ? 0 : found->second;
  }
  const std::map<std::string, std::uint64_t>& all() const { return counts_; }
  void clear() { counts_.clear(); }

 private:
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace slam
