// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>
#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/backend_mode.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam_toy {

struct ToyConfig {
  static constexpr const char* kSection = "toy";

  slam::BackendMode mode = slam::BackendMode::kSlam;
  double gate = 13.8;
  double initial_sigma = 0.001;

  void describe(slam::Fields& fields);
};

/// EKF-SLAM with known ids (Thrun, Burgard, Fox 2005, table 10.1), one observation after the other,
/// with dense matrices: nothing but the algorithm.
class ToyBackend final : public slam::Backend, public slam::LandmarkMapper, public slam::MapKeeper {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;
  void describe(slam::Capabilities& capabilities) override;

  void set(const slam::Motion& motion) { motions_.push_back(motion); }
  void set(const slam::LandmarkObservationArray& seen) { observations_ = seen; }
  void set(const slam::PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }
  void set(const slam::MapState& map) override { map_ = map; }

  slam::Status execute() override;

  slam::PoseEstimate pose() const override;
  slam::LandmarkMap landmarks() const override;
  slam::MapState state() const override { return {pose(), landmarks(), {}}; }
  slam::UpdateStatistics statistics() const override { return statistics_; }
  slam::Counters counters() const override { return counters_; }

  void reset() override;

 private:
  void replaceMap(const slam::MapState& map);
  void relocate(const slam::PoseEstimate& estimate);
  void predict(const slam::Motion& motion);
  void take(const slam::LandmarkObservation& z, const slam::Pose2& sensor);
  void correct(const slam::LandmarkObservation& z, const slam::Pose2& sensor, Eigen::Index at);
  void augment(const slam::LandmarkObservation& z, const slam::Pose2& sensor);
  void append(slam::LandmarkId id, const Eigen::Vector2d& m_map);
  slam::Pose2 robot() const { return slam::Pose2::fromVector(x_.head<3>()); }

  ToyConfig config_;
  slam::RangeBearingModel model_;
  Eigen::VectorXd x_;                            ///< robot, then landmarks in order of sight
  Eigen::MatrixXd P_;                            ///< its covariance
  std::map<slam::LandmarkId, Eigen::Index> at_;  ///< where a landmark stands in x
  slam::UpdateStatistics statistics_;
  slam::Counters counters_;

  std::optional<slam::MapState> map_;
  std::optional<slam::PoseEstimate> initial_pose_;
  std::vector<slam::Motion> motions_;
  std::optional<slam::LandmarkObservationArray> observations_;
};

}  // namespace slam_toy
