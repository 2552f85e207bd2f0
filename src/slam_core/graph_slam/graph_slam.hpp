// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/association/sightings.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/graph_slam/associator.hpp"
#include "slam_core/graph_slam/graph_config.hpp"
#include "slam_core/graph_slam/landmark_graph.hpp"

namespace slam::graph_slam {

/// Graph-SLAM (thesis chapter 3; Grisetti, Kuemmerle, Stachniss, Burgard 2010): the whole path and
/// the map are optimised with each observation, of which only what has changed is computed (Kaess
/// et al. 2012). So the past is corrected when a loop closes.
class GraphSlam final : public Backend, LandmarkMapper, MapKeeper, PathReviser {
 public:
  /// @throw ConfigError
  void configure(const GraphConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const Motion& motion);
  void set(const LandmarkObservationArray& observations) { observations_ = observations; }
  void set(const PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  Status execute() override;

  PoseEstimate pose() const override { return graph_.robot(); }
  Counters counters() const override { return counters_; }
  Figures figures() const override;

  void reset() override;

 private:
  // what it offers as capabilities
  LandmarkMap landmarks() const override;
  UpdateStatistics statistics() const override { return statistics_; }
  MapState state() const override;
  void set(const MapState& map) override { map_ = map; }
  std::vector<StampedPose> path() const override { return graph_.path(); }

  NodeLimits nodeLimits() const { return {config_.node_distance, config_.node_angle}; }
  void replaceMap();
  void relocate();
  void predict();
  Status reconsider(const Association& association, const Pose2& sensor);
  Status augment(const std::vector<LandmarkObservation>& unseen, const Pose2& sensor);
  Status summary(const Association& association, const std::vector<Status>& of_steps) const;

  GraphConfig config_;
  Associator associator_;
  LandmarkGraph graph_;
  association::Sightings sightings_;
  UpdateStatistics statistics_;
  Counters counters_;
  LandmarkMap fixed_map_;  ///< as it was loaded, to localise in

  std::optional<MapState> map_;
  std::optional<PoseEstimate> initial_pose_;
  std::optional<Motion> motion_;  ///< all motions since the last step as one
  std::optional<LandmarkObservationArray> observations_;
};

}  // namespace slam::graph_slam
