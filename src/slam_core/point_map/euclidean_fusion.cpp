// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/fusion_policy.hpp"

namespace slam::point_map {
namespace {

class EuclideanFusion final : public FusionPolicy {
 public:
  explicit EuclideanFusion(double distance) : distance_(distance) {}

  Pose2 place(const LaserScan&, const Pose2& T_map_base, const PointSet&) override {
    return T_map_base;
  }
  std::optional<std::uint32_t> match(const Eigen::Vector2d& end, PointSet& map) override {
    return map.nearest(end, distance_);
  }

 private:
  double distance_;
};

}  // namespace

std::unique_ptr<FusionPolicy> makeEuclideanFusion(const PointMapConfig& config) {
  return std::make_unique<EuclideanFusion>(config.fusion_distance);
}

}  // namespace slam::point_map
