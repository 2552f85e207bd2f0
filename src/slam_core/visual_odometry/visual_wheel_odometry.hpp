// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <memory>

#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/visual_odometry/motion_track.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"

namespace slam::visual_odometry {

/// Visual odometry that takes the wheels' motion for intervals in which the images tell nothing.
/// The wheels are the registered odometry source "wheel". Images wait until the wheels have come as
/// far, so that the order of arrival does not matter; a second of images later they wait no longer.
///
/// Counted: as VisualOdometry and as the wheels; "wheels_missing" for images that waited in vain.
class VisualWheelOdometry final : public OdometrySource, public ViewDrawer {
 public:
  VisualWheelOdometry();

  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { visual_.seed(seed); }

  void describe(Ports& ports) override;
  void set(const OdometrySample& sample);
  void set(const CameraView& view) { waiting_.push_back(view); }
  Status execute() override;
  bool isBusy() const override { return is_handing_over_; }

  const std::optional<Motion>& motion() const override { return visual_.motion(); }
  Counters counters() const override;
  std::uint64_t dropped() const override;
  cv::Mat drawing() const override { return visual_.drawing(); }
  Figures figures() const override { return visual_.figures(); }
  void reset() override;

  const VisualOdometry& visual() const { return visual_; }

 private:
  bool handOverView();

  std::unique_ptr<OdometrySource> wheels_;
  Ports wheel_ports_;
  bool has_sample_ = false, is_handing_over_ = false;
  MotionTrack track_;
  std::deque<CameraView> waiting_;
  VisualOdometry visual_;
  Counters own_counters_;
};

}  // namespace slam::visual_odometry
