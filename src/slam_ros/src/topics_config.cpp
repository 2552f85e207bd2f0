// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/topics_config.hpp"

#include "slam_core/camera/image.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam_ros {

std::vector<std::pair<std::string, slam::Kind>> TopicsConfig::inputs() {
  return {{"motion", slam::kindOf<slam::Motion>()},
          {"odom", slam::kindOf<slam::OdometrySample>()},
          {"observations", slam::kindOf<slam::LandmarkObservationArray>()},
          {"camera", slam::kindOf<slam::Image>()},
          {"ceiling_camera", slam::kindOf<slam::Image>()},
          {"scan", slam::kindOf<slam::LaserSweep>()}};
}

}  // namespace slam_ros
