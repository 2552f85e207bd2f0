// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/contract/landmark_detector.hpp"

namespace slam::test {

/// A detector that finds the brightest spot of an image which is 32 pixels wide.
class SpotDetector : public LandmarkDetector {
 public:
  void configure(Settings& /*settings*/) override { sequence_ = 0; }
  void describe(Ports& ports) override {
    ports.takes<CameraView>("camera", "images", this);
    ports.makes<LandmarkObservationArray>("observations", array_);
  }
  void set(const CameraView& view) { view_ = view; }

  Status execute() override {
    array_.reset();
    const auto view = std::exchange(view_, std::nullopt);
    if (!view) return Status::ok();
    array_ = LandmarkObservationArray();
    array_->sequence = sequence_++;
    array_->stamp = view->stamp;
    array_->sensor_frame = view->image.frame;
    if (view->isUsable()) look(*view);
    return Status::ok();
  }
  const std::optional<LandmarkObservationArray>& observations() const override { return array_; }
  Counters counters() const override { return {}; }
  void reset() override { view_.reset(); }

 protected:
  /// @param brightness of the spot, 0 to 255
  virtual LandmarkId idOf(double brightness) const = 0;
  virtual double distance() const { return 2.0; }  ///< of the spot [m]
  virtual Pose2 sensorPose(const CameraView& /*view*/) const { return {}; }

 private:
  void look(const CameraView& view) {
    double brightness = 0.0;
    cv::Point spot;
    cv::minMaxLoc(view.image.gray, nullptr, &brightness, nullptr, &spot);
    array_->sensor_pose = sensorPose(view);
    array_->observations = {{idOf(brightness), distance(), std::atan2(16 - spot.x, 16),
                             Eigen::Matrix2d::Identity() * 1e-4}};
  }

  std::optional<CameraView> view_;
  std::optional<LandmarkObservationArray> array_;
  std::uint64_t sequence_ = 0;
};

}  // namespace slam::test
