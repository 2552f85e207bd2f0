// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/collator.hpp"

namespace slam::test {

/// A motion along a line, the simplest that a Collator can split.
struct LineMotion {
  std::uint64_t sequence = 0;
  Stamp start, end;
  double way = 0.0;
};

inline std::pair<LineMotion, LineMotion> split(const LineMotion& motion, Stamp at) {
  const double share = seconds(at - motion.start) / seconds(motion.end - motion.start);
  auto before = motion, after = motion;
  before.end = after.start = at;
  before.way = share * motion.way;
  after.way = motion.way - before.way;
  return {before, after};
}

using LineCollator = Collator<LineMotion, std::string>;

inline Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

/// Collates by hand: every push is followed by all steps that are due.
class LineRun {
 public:
  explicit LineRun(std::size_t sources = 1, LineCollator::Limits limits = {})
      : collator(sources, limits) {}

  void move(double start, double end, std::uint64_t sequence) {
    collator.push({sequence, at(start), at(end), end - start});
    drain();
  }
  void see(const std::string& what, double stamp, std::uint64_t sequence, std::size_t source = 0) {
    collator.push(source, at(stamp), sequence, what);
    drain();
  }
  void drain() {
    while (auto step = collator.next()) steps.push_back(*step);
  }
  double wayOf(std::size_t step) const {
    double way = 0.0;
    for (const auto& motion : steps.at(step).motions) way += motion.way;
    return way;
  }
  std::string seen() const {
    std::string all;
    for (const auto& step : steps) all += step.trigger.value_or("-");
    return all;
  }
  /// Every bit of every step.
  std::string transcript() const {
    std::ostringstream text;
    text << std::hexfloat;
    for (const auto& step : steps) {
      text << nanoseconds(step.stamp) << (step.restart ? " restart " : " ")
           << step.trigger.value_or("carry") << ":";
      for (const auto& motion : step.motions)
        text << " " << nanoseconds(motion.start) << ".." << nanoseconds(motion.end) << "="
             << motion.way;
      text << "\n";
    }
    return text.str();
  }

  LineCollator collator;
  std::vector<LineCollator::Step> steps;
};

}  // namespace slam::test
