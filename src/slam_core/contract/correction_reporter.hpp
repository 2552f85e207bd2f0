// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// The capability of a back-end that knows whether its input corrected its pose: an image of a dark
/// room and a scan that fits nothing do not. For a back-end without it each image and each scan
/// counts as a correction; for landmarks the statistics decide (LandmarkMapper).
class CorrectionReporter {
 public:
  virtual ~CorrectionReporter() = default;
  /// The stamp at which the things that corrected the pose in the last step were first seen: they
  /// cannot correct errors from before that stamp. The zero stamp if they are as accurate as the
  /// map. Nothing if the last step did not correct the pose.
  virtual std::optional<Stamp> correctedBy() const = 0;
};

}  // namespace slam
