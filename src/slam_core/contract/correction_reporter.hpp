// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/common/time.hpp"

namespace slam {

/// The capability of a back-end that knows whether what it was given corrected its pose: an image
/// of a dark room and a scan that fits nothing do not. Of a back-end without it each image and each
/// scan counts as a correction; of landmarks their statistics tell (LandmarkMapper).
class CorrectionReporter {
 public:
  virtual ~CorrectionReporter() = default;
  /// When that was first seen by which the last step corrected the pose: nothing that is newer
  /// corrects errors from before. The zero stamp where that is as right as the map. Nothing where
  /// the last step corrected nothing.
  virtual std::optional<Stamp> correctedBy() const = 0;
};

}  // namespace slam
