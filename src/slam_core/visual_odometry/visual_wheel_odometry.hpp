// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/wheels_beside.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"

namespace slam::visual_odometry {

/// Visual odometry that takes the wheels' motion for intervals in which the images tell nothing.
///
/// Counted: as VisualOdometry and as the wheels (WheelsBeside).
class VisualWheelOdometry final : public OdometrySource, public ViewDrawer {
 public:
  VisualWheelOdometry();

  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { visual_.seed(seed); }

  void describe(Ports& ports) override;
  Status execute() override;
  bool isBusy() const override { return is_handing_over_; }

  const std::optional<Motion>& motion() const override { return visual_.motion(); }
  std::string name() const override { return "visual"; }
  Counters counters() const override;
  std::uint64_t dropped() const override { return wheels_.dropped(); }
  cv::Mat drawing() const override { return visual_.drawing(); }
  Figures figures() const override { return visual_.figures(); }
  void reset() override;
  void goOnLive() override { reset(); }
  bool canResume() const override { return wheels_.canResume(); }
  void saveState(ArchiveWriter& archive) const override {
    archive(wheels_, visual_, is_handing_over_);
  }
  void restoreState(ArchiveReader& archive) override {
    archive(wheels_, visual_, is_handing_over_);
  }

  const VisualOdometry& visual() const { return visual_; }

 private:
  WheelsBeside<CameraView> wheels_;
  VisualOdometry visual_;
  bool is_handing_over_ = false;
};

}  // namespace slam::visual_odometry
