// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace slam {

/// How often something worth a diagnostic has happened, by reason ("late", "gated", ...).
class Counters {
 public:
  void add(const std::string& reason, std::uint64_t times = 1) {
    if (times > 0) counts_[reason] += times;
  }
  /// All of another's, by reasons that begin with `prefix`.
  void add(const Counters& other, const std::string& prefix = "") {
    for (const auto& [reason, count] : other.all()) add(prefix + reason, count);
  }
  std::uint64_t operator[](const std::string& reason) const {
    const auto found = counts_.find(reason);
    return found == counts_.end() ? 0 : found->second;
  }
  const std::map<std::string, std::uint64_t>& all() const& { return counts_; }
  /// Of a temporary a copy: `for (... : component.counters().all())` holds on to what it goes over.
  std::map<std::string, std::uint64_t> all() && { return std::move(counts_); }
  void clear() { counts_.clear(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(counts_);
  }

 private:
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace slam
