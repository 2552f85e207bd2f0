// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/gyro/odometry_beside_gyro.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"

namespace slam::visual_odometry {

/// Visual odometry to which a gyro says how far the robot has turned: where to look, and the turn
/// where the images tell nothing.
///
/// Counted: as VisualOdometry and as the gyro (GyroBeside).
class VisualImuOdometry final : public gyro::OdometryBesideGyro<VisualOdometry, CameraView>,
                                public ViewDrawer {
 public:
  VisualImuOdometry() : OdometryBesideGyro("the camera") {}
  void describe(Ports& ports) override;
  cv::Mat drawing() const override { return source().drawing(); }

 private:
  bool isMeasured() const override { return source().isMeasured(); }
};

}  // namespace slam::visual_odometry
