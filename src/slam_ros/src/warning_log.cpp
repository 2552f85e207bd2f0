// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/warning_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <utility>

namespace slam_ros {
namespace {

/// Bad data may bring names of its own into sentences: memory is bounded.
constexpr std::size_t kMostKinds = 200, kLongestKind = 500;

}  // namespace

std::string WarningLog::kindOf(const std::string& sentence) {
  // a digit within a word belongs to a name, such as fastslam2
  static const std::regex kNumber(R"((^|[^A-Za-z0-9_/])[-+]?\d+(\.\d+)?([eE][-+]?\d+)?\b)");
  static const std::regex kList(R"(#(,? (and )?#)+)");
  const auto start = sentence.substr(0, kLongestKind);
  return std::regex_replace(std::regex_replace(start, kNumber, "$1#"), kList, "#");
}

std::string WarningLog::add(const std::string& sentence, bool is_urgent) {
  const auto name = kindOf(sentence);
  const auto known = kinds_.find(name);
  if (known == kinds_.end() && kinds_.size() >= kMostKinds && !is_urgent) {
    ++beyond_;
    return "";
  }
  const std::size_t order = kinds_.size();
  auto& kind = known == kinds_.end() ? kinds_[name] : known->second;
  if (kind.count++ == 0) {
    kind.first = sentence;
    kind.order = order;
  }
  kind.is_urgent |= is_urgent;
  if (kind.is_said) return "";
  if (kind.is_urgent || said_ < kMostSaid) {
    said_ += kind.is_urgent ? 0 : 1;
    kind.is_said = true;
    return sentence;
  }
  return std::exchange(has_told_of_more_, true) ? "" : "further ones are counted at the end";
}

std::vector<std::string> WarningLog::summary() const {
  std::vector<const Kind*> kinds;
  for (const auto& [name, kind] : kinds_)
    if (kind.count > 1 || !kind.is_said) kinds.push_back(&kind);
  std::sort(kinds.begin(), kinds.end(), [](const Kind* a, const Kind* b) {
    return a->is_urgent != b->is_urgent ? a->is_urgent : a->order < b->order;
  });
  std::vector<std::string> lines;
  for (const auto* kind : kinds)
    lines.push_back(fmt::format("warned {} {}: {}", kind->count,
                                kind->count == 1 ? "time" : "times", kind->first));
  if (beyond_ > 0) lines.push_back(fmt::format("{} warnings of further kinds", beyond_));
  return lines;
}

}  // namespace slam_ros
