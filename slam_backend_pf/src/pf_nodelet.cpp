// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <pluginlib/class_list_macros.hpp>
#include <slam_ros/backend_nodelet.hpp>

#include "slam_core/particle_filter/fast_slam.hpp"

namespace slam_backend_pf {

class PfNodelet final : public slam_ros::BackendNodelet {
 private:
  std::unique_ptr<slam::Backend> makeBackend() const override {
    return std::make_unique<slam::particle_filter::FastSlam>();
  }
};

}  // namespace slam_backend_pf

PLUGINLIB_EXPORT_CLASS(slam_backend_pf::PfNodelet, nodelet::Nodelet)
