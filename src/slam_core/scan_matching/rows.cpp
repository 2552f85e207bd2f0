// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/rows.hpp"

namespace slam::scan_matching {
namespace {

/// Finds the rows of one laser.
class RowFinder {
 public:
  RowFinder(grid_map::Span<Eigen::Vector2d> ends, double cells_per_metre)
      : ends_(ends), apart_(kApart * cells_per_metre), longest_(kLongestGap * cells_per_metre) {}

  Row rowOf(const Eigen::Vector2d* end) const {
    const auto *before = next(end, -1), *after = next(end, 1);
    if (before != nullptr && after != nullptr) return rowThrough(*before, *end, *after);
    const int step = before != nullptr ? -1 : 1;  // at the first and last ends, to one side
    const auto* const middle = before != nullptr ? before : after;
    const auto* const far = middle == nullptr ? nullptr : next(middle, step);
    return far == nullptr ? Row() : rowThrough(*end, *middle, *far);
  }

 private:
  static constexpr double kApart = 0.25, kLongestGap = 1.0;  // [m]

  /// The first end on one side that is so far away that noise does not turn the line through both;
  /// null if there is none before a gap.
  const Eigen::Vector2d* next(const Eigen::Vector2d* from, int step) const {
    for (const auto* end = from; end + step >= ends_.begin() && end + step < ends_.end();) {
      if ((end[step] - *end).norm() > longest_) return nullptr;
      end += step;
      if ((*end - *from).norm() >= apart_) return end;
    }
    return nullptr;
  }
  static Row rowThrough(const Eigen::Vector2d& first, const Eigen::Vector2d& middle,
                        const Eigen::Vector2d& last) {
    constexpr double kStraight = 0.96;  // cosine of the angle that it may have in the middle
    const Eigen::Vector2d a = middle - first, b = last - middle;
    if (a.dot(b) < kStraight * a.norm() * b.norm()) return {};
    return {(last - first).normalized(), (last - first).norm()};
  }

  grid_map::Span<Eigen::Vector2d> ends_;
  double apart_, longest_;  ///< [cells]
};

}  // namespace

std::vector<Row> rowsOf(const grid_map::ScanPoints& scan) {
  std::vector<Row> rows;
  rows.reserve(scan.ends.size());
  scan.forEachFan([&](const auto&, const auto&, const auto& ends) {
    const RowFinder finder(ends, scan.cells_per_metre);
    for (const auto& end : ends) rows.push_back(finder.rowOf(&end));
  });
  return rows;
}

}  // namespace slam::scan_matching
