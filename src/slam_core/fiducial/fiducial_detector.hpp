// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/fiducial/corner_detector.hpp"
#include "slam_core/fiducial/fiducial_config.hpp"

namespace slam::fiducial {

/// Finds square markers in images and tells where they stand in the robot's plane (thesis 5.2).
/// Only a marker's position is used: its orientation may flip (Collins and Bartoli 2014).
///
/// Counted: the reasons of rejections: "low_margin", "hamming", "unlisted_id",
/// "duplicate_id", "image_border", "too_small", "too_oblique", "reprojection_error", "no_pose",
/// "ill_conditioned".
class FiducialDetector : public LandmarkDetector, public ViewDrawer {
 public:
  explicit FiducialDetector(std::unique_ptr<CornerDetector> corner_detector);

  void describe(Ports& ports) override;
  void configure(Settings& settings) override;
  void set(const CameraView& view) { next_view_ = view; }
  Status execute() override;
  void startIdsAt(LandmarkId first) override { corner_detector_->startIdsAt(first); }
  std::vector<IdRange> ids() const override { return corner_detector_->ids(); }
  const std::optional<LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  cv::Mat drawing() const override;
  Counters counters() const override { return counters_; }
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  /// All that was found in the last image, accepted or not, sorted by id.
  const std::vector<MarkerDetection>& detections() const { return detections_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(next_sequence_, counters_);
  }

 private:
  LandmarkObservationArray emptyArray();
  void estimatePoses();
  void observe();
  void count();

  FiducialConfig config_;
  std::unique_ptr<CornerDetector> corner_detector_;
  std::optional<CameraView> next_view_, view_;  ///< of the next step and of the last one
  std::vector<MarkerDetection> detections_;
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

/// The coordinator with one kind of corner detector, for the registry.
template <class Corners>
class FiducialDetectorWith final : public FiducialDetector {
 public:
  FiducialDetectorWith() : FiducialDetector(std::make_unique<Corners>()) {}
};

}  // namespace slam::fiducial
