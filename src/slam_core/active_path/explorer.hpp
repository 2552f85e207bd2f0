// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/active_path/active_path_config.hpp"
#include "slam_core/active_path/frontiers.hpp"
#include "slam_core/active_path/left_out_goals.hpp"
#include "slam_core/active_path/view_gain.hpp"
#include "slam_core/active_path/visited_places.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::active_path {

/// Where to go next.
struct Goal {
  Pose2 pose;         ///< T_map_base there
  double gain = 0.0;  ///< [bit m^2]; 0 of a place that closes a loop
  double cost = 0.0;  ///< of the way to it [m], see Ways
  bool closes_loop = false;
};

/// What the explorer makes of a map and a pose.
struct Decision {
  enum class State { kWaiting, kExploring, kClosingLoop, kExplored };

  State state = State::kWaiting;
  Status status;  ///< what is wrong with map or pose, or with a goal
  std::optional<Goal> goal;
  bool is_new = false;                     ///< the goal is another than in the last decision
  std::vector<Eigen::Vector2d> way;        ///< to the goal, from the robot [m]
  std::vector<Eigen::Vector2d> frontiers;  ///< cells that are on one [m]
  std::vector<Goal> candidates;
};

/// Decides where the robot drives next (active SLAM): to the viewpoint that is expected to lower
/// the entropy of the map most per metre of way (Burgard et al. 2000; Stachniss, Grisetti, Burgard
/// 2005), or, where its position is not known well enough, back to a place that it knows. A goal is
/// kept until it is reached or unreachable, shows nothing new any more, or a clearly better one
/// appears. Deterministic; reads no clock.
class Explorer {
 public:
  /// @throw ConfigError
  explicit Explorer(const ActivePathConfig& config);

  /// To be called whenever map or pose have changed, and about once a second.
  /// @param now not before that of the last call, else everything starts over
  /// @param map may grow, and change its resolution and origin, between calls
  Decision decide(Stamp now, const OccupancyGrid& map, const PoseEstimate& pose);

  /// Looks again at all that was left out, also where everything had been explored.
  void resume();
  /// The same without what is known of visited places, as for another map.
  void reset();

  /// Reasons why goals were given up.
  const Counters& counters() const { return counters_; }

 private:
  struct Kept {
    Goal goal;
    double least_cost;  ///< how near the robot came [m]
    Stamp since;        ///< when it came so near
  };
  struct Scene;  ///< what one decision looks at

  void watchPosition(double sigma);
  void judgeKept(Scene& scene);
  void keepTime(Scene& scene);
  void close(Scene& scene);
  void explore(Scene& scene);
  std::optional<Goal> bestPlace(const Scene& scene) const;
  void addCandidates(Scene& scene) const;
  double rate(const Goal& goal) const;
  void take(Scene& scene, const Goal& goal);
  void finish(Scene& scene);

  ActivePathConfig config_;
  VisitedPlaces visited_;
  LeftOutGoals left_out_;
  Counters counters_;
  std::optional<Kept> kept_;
  std::optional<Stamp> last_;  ///< decision
  double max_sigma_;           ///< of the position, in force [m]
  bool is_closing_ = false, is_explored_ = false;
};

}  // namespace slam::active_path
