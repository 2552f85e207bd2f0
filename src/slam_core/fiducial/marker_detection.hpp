// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "slam_core/fiducial/marker_pose.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::fiducial {

/// One marker found in an image, and what became of it.
struct MarkerDetection {
  LandmarkId id = kUnknownId;  ///< offset of its family included
  /// [px], the centre of the upper left pixel is (0, 0). Clockwise as one looks at the marker, from
  /// its upper left corner.
  Corners corners;
  int hamming = 0;      ///< bits of its code that were corrected, where the detector tells
  double margin = 0.0;  ///< contrast of its bits to their threshold [gray levels], likewise
  MarkerPose pose;      ///< valid where the corners were good enough to compute it
  LandmarkObservation observation;
  std::string rejection;  ///< the reason, empty: accepted

  bool isAccepted() const { return rejection.empty(); }
};

}  // namespace slam::fiducial
