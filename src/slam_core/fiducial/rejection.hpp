// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

#include "slam_core/common/status.hpp"
#include "slam_core/fiducial/fiducial_config.hpp"
#include "slam_core/fiducial/marker_detection.hpp"

namespace slam::fiducial {

/// Sorts by id, and equal ids by the place of their first corner.
void sortById(std::vector<MarkerDetection>& detections);

/// Rejects by what stands in the image: "unlisted_id", "duplicate_id" (all of the same id, since
/// nobody can tell which is the right one), "image_border", "too_small". @pre sorted by id
void rejectByImage(const FiducialConfig& config, const cv::Size& image,
                   std::vector<MarkerDetection>& detections);

/// Rejects by the pose of those accepted so far: "reprojection_error", "too_oblique".
void rejectByPose(const FiducialConfig& config, std::vector<MarkerDetection>& detections);

/// A warning of markers that no one should have put up: ids that are not listed or there twice.
Status warningOf(const std::vector<MarkerDetection>& detections);

}  // namespace slam::fiducial
