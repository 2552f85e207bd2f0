// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/laser_landmarks/scan_segments.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// How bright things are in a scan.
class Brightness {
 public:
  /// The median over the beams of intensity times range to the power of `range_exponent` stands for
  /// what is not bright, so that far things are compared with what they would send back from here.
  Brightness(const std::vector<LaserBeam>& beams, double range_exponent, double contrast);

  /// Whether any beam has an intensity.
  bool isKnown() const { return is_known_; }
  /// Whether a beam is brighter than the median by the contrast. A median of 0 is that of lasers
  /// that tell the intensity of reflectors only.
  bool isBright(const LaserBeam& beam) const;

  /// The bright parts of a segment; beside such a part the segment goes on, dark, or ends.
  std::vector<ScanSegment> brightPartsOf(const ScanSegment& segment) const;

 private:
  double scaled(const LaserBeam& beam) const;

  double range_exponent_, contrast_;
  double median_ = 0.0;
  bool is_known_ = false;
};

}  // namespace slam::laser_landmarks
