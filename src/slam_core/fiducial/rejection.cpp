// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/rejection.hpp"

#include <algorithm>
#include <tuple>

namespace slam::fiducial {
namespace {

/// Detectors read a marker of which the image shows all but half of its black border, and put its
/// corners up to a twentieth of a side inside of the image.
constexpr double kCutShare = 0.05;

bool isNearBorder(const Corners& corners, const cv::Size& image, double border) {
  return std::any_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& corner) {
    return corner.x() < border || corner.x() > image.width - 1 - border ||  //
           corner.y() < border || corner.y() > image.height - 1 - border;
  });
}

void rejectDuplicates(std::vector<MarkerDetection>& detections) {
  std::vector<MarkerDetection*> readable;
  for (auto& marker : detections)
    if (marker.isAccepted()) readable.push_back(&marker);
  for (std::size_t i = 1; i < readable.size(); ++i)
    if (readable[i]->id == readable[i - 1]->id)
      readable[i]->rejection = readable[i - 1]->rejection = "duplicate_id";
}

}  // namespace

void sortById(std::vector<MarkerDetection>& detections) {
  const auto key = [](const MarkerDetection& marker) {
    return std::make_tuple(marker.id, marker.corners[0].x(), marker.corners[0].y());
  };
  std::sort(detections.begin(), detections.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

void rejectByImage(const FiducialConfig& config, const cv::Size& image,
                   std::vector<MarkerDetection>& detections) {
  for (auto& marker : detections)
    if (marker.isAccepted() && !config.isListed(marker.id)) marker.rejection = "unlisted_id";
  rejectDuplicates(detections);
  for (auto& marker : detections) {
    if (!marker.isAccepted()) continue;
    const double side = meanSide(marker.corners);
    if (isNearBorder(marker.corners, image, config.border + kCutShare * side))
      marker.rejection = "image_border";
    else if (side < config.min_side)
      marker.rejection = "too_small";
  }
}

void rejectByPose(const FiducialConfig& config, std::vector<MarkerDetection>& detections) {
  for (auto& marker : detections) {
    if (!marker.isAccepted()) continue;
    if (marker.pose.reprojectionError() > config.max_reprojection_error)
      marker.rejection = "reprojection_error";
    else if (marker.pose.obliqueness() > config.max_obliqueness)
      marker.rejection = "too_oblique";
  }
}

Status warningOf(const std::vector<MarkerDetection>& detections) {
  for (const auto& marker : detections) {
    const auto name = "marker " + std::to_string(marker.id);
    if (marker.rejection == "duplicate_id")
      return Status::warning(name +
                             " is in one image more than once; none of them is used, take "
                             "the other ones down");
    if (marker.rejection == "unlisted_id")
      return Status::warning(name + " is not listed in fiducial.ids; it is left out");
  }
  return Status::ok();
}

}  // namespace slam::fiducial
