// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/fiducial_detector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/fiducial/drawing.hpp"
#include "slam_core/fiducial/range_bearing.hpp"
#include "slam_core/fiducial/rejection.hpp"
#include "slam_core/fiducial/small_markers.hpp"

namespace slam::fiducial {
namespace {

const SectionRegistrar<FiducialConfig> kFiducialSection;

}  // namespace

FiducialDetector::FiducialDetector(std::unique_ptr<CornerDetector> corner_detector)
    : corner_detector_(std::move(corner_detector)) {}

void FiducialDetector::describe(Ports& ports) {
  ports.takes<CameraView>(CameraConfig::kSection, "images", this);
  ports.makes<LandmarkObservationArray>("observations", observations_);
}

void FiducialDetector::configure(Settings& settings) {
  FaultCollector faults;
  faults.attempt([&] { config_ = settings.read<FiducialConfig>(); });
  faults.attempt([&] { corner_detector_->configure(settings); });
  faults.raise();
  reset();
}

void FiducialDetector::reset() {
  next_view_.reset();
  view_.reset();
  detections_.clear();
  observations_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status FiducialDetector::execute() {
  observations_.reset();
  view_ = std::exchange(next_view_, std::nullopt);
  if (!view_) return Status::ok();
  detections_.clear();
  observations_ = emptyArray();
  if (view_->camera == nullptr) return Status::ok();  // its gate has said why

  const auto& gray = view_->image.gray;
  corner_detector_->detect(gray, detections_);
  sortById(detections_);
  rejectByImage(config_, gray.size(), detections_);
  estimatePoses();
  rejectByPose(config_, detections_);
  if (view_->is_repeated) return Status::ok();  // it is drawn, but tells nothing new
  observe();
  count();
  return warningOf(detections_);
}

LandmarkObservationArray FiducialDetector::emptyArray() {
  LandmarkObservationArray array;
  array.sequence = next_sequence_++;
  array.stamp = view_->stamp;
  array.sensor_frame = view_->image.frame;
  if (view_->isUsable()) {
    const auto& position = view_->mount.T_base_camera.translation();
    array.sensor_pose = Pose2(position.x(), position.y(), 0.0);
  }
  return array;
}

void FiducialDetector::estimatePoses() {
  for (auto& marker : detections_) {
    if (!marker.isAccepted()) continue;
    const auto pose = estimatePose(*view_->camera, marker.corners, config_.sizeOf(marker.id),
                                   config_.corner_sigma);
    if (!pose) {
      marker.rejection = "no_pose";
      continue;
    }
    marker.pose = *pose;
    // whatever makes a marker look too large puts it too near
    const double share = std::hypot(sizeSigma(marker.corners), config_.sigma_range_relative);
    const Eigen::Vector3d one_sigma = share * pose->position;
    marker.pose.covariance += one_sigma * one_sigma.transpose();
  }
}

void FiducialDetector::observe() {
  for (auto& marker : detections_) {
    if (!marker.isAccepted()) continue;
    auto z = rangeAndBearing(marker.pose.position, marker.pose.covariance,
                             view_->mount.T_base_camera.linear(), config_.max_relative_sigma);
    if (!z || !faultOf(*z).empty()) {
      marker.rejection = "ill_conditioned";
      continue;
    }
    z->id = marker.id;
    marker.observation = *z;
    observations_->observations.push_back(*z);
  }
}

void FiducialDetector::count() {
  for (const auto& marker : detections_)
    if (!marker.isAccepted()) counters_.add(marker.rejection);
}

cv::Mat FiducialDetector::drawing() const {
  return view_ ? draw(view_->image.gray, detections_) : cv::Mat();
}

void FiducialDetector::saveState(ArchiveWriter& archive) const { archive(*this); }

void FiducialDetector::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::fiducial
