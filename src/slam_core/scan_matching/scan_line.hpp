// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace slam::scan_matching {

/// The line along which a scan's ends lie around one of them.
struct ScanLine {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of unit length, in the scan's frame
  double tilt = 0.0;                                     ///< variance of its direction [rad^2]
};

/// Whether a scan shows that a surface goes on beside one of its ends, where a map of few beams
/// shows a dot: the neighbouring ends in the sweep that are not close to it lie on a line
/// with it, on either side or, at the edge of what is seen, on one (the point-to-line metric of
/// Censi 2008).
/// @param ends in the order of the sweep, lengths in cells like `reach`
/// @param index of the end
/// @param reach neighbours lie at least so far apart, and beyond the noise
/// @param variance of an end across the line [cells^2]
/// @return the line that is known best; nothing where the ends lie on none
std::optional<ScanLine> scanLineAt(const std::vector<Eigen::Vector2d>& ends, std::size_t index,
                                   double reach, double variance);

/// The lines at the ends of one scan, each found when it is asked for the first time.
class ScanLines {
 public:
  /// @param ends outlive this @param reach as that of scanLineAt()
  ScanLines(const std::vector<Eigen::Vector2d>& ends, double reach)
      : ends_(ends), reach_(reach), slots_(ends.size()) {}

  /// @param variance of the end across the line [cells^2], always the same for an end
  /// @return null where the ends lie on no line
  const ScanLine* at(std::size_t index, double variance) {
    auto& [is_known, line] = slots_[index];
    if (!is_known) line = scanLineAt(ends_, index, reach_, variance);
    is_known = true;
    return line ? &*line : nullptr;
  }

 private:
  struct Slot {
    bool is_known = false;
    std::optional<ScanLine> line;
  };

  const std::vector<Eigen::Vector2d>& ends_;
  double reach_;
  std::vector<Slot> slots_;  ///< by end
};

}  // namespace slam::scan_matching
