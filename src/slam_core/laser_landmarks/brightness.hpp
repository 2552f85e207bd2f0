// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/laser_landmarks/scan_segments.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// Judges which beams of a scan are bright, that is, reflected by more than ordinary surfaces.
class Brightness {
 public:
  /// The reference is the median over the beams of intensity times range^range_exponent: the
  /// product does not depend on the range of a surface, so that near and far ones can be compared.
  /// @param contrast ratio to the median above which a beam is bright [1]
  Brightness(const std::vector<LaserBeam>& beams, double range_exponent, double contrast);

  /// Whether any beam has an intensity.
  bool isKnown() const { return is_known_; }
  /// Whether a beam exceeds the median by the contrast. The median is 0 for lasers that report the
  /// intensity of reflectors only; any intensity above 0 is bright then.
  bool isBright(const LaserBeam& beam) const;

  /// The bright parts of a segment. Beside such a part the segment either continues with dark
  /// beams, which hide nothing, or ends.
  std::vector<ScanSegment> brightPartsOf(const ScanSegment& segment) const;

 private:
  double scaled(const LaserBeam& beam) const;

  double range_exponent_, contrast_;
  double median_ = 0.0;
  bool is_known_ = false;
};

}  // namespace slam::laser_landmarks
