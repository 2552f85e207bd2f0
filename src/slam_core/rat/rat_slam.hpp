// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/contract/place_reporter.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/contract/without_covariance.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/rat/experience_map.hpp"

namespace slam::rat {

/// The back-end of RatSLAM (Milford and Wyeth 2008; Ball et al. 2013): what the pose cells and the
/// local view cells say becomes an experience map, the pose is that of the experience where the
/// robot is, and odometry since then.
///
/// It estimates no covariance (WithoutCovariance): what pose() holds is that of the odometry since
/// the start, or since an initial pose. Counted: "loops" (places recognised along a new link),
/// "experiences_full" (places beyond the memory), "steps_forgotten" (of the way).
class RatSlam final : public Backend,
                      EventReporter,
                      GraphReporter,
                      PathReviser,
                      PlaceReporter,
                      WithoutCovariance {
 public:
  /// @throw ConfigError
  void configure(const ExperienceConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  Status execute() override;
  PoseEstimate pose() const override;
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(map_, covariance_, way_, events_, inputs_, counters_);
  }

 private:
  /// These inputs were set since the last step.
  struct Inputs {
    std::optional<PoseEstimate> initial_pose;
    std::vector<Motion> motions;
    std::optional<PoseCellState> cells;

    void set(const Motion& motion) { motions.push_back(motion); }
    void set(const PoseCellState& state) { cells = state; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(initial_pose, motions, cells);
    }
  };
  /// A step of the way, relative to the experience where it was taken.
  struct WayPoint {
    Stamp stamp;
    std::optional<std::size_t> experience;
    Pose2 pose;                        ///< in the experience; in the map where there is none
    std::optional<Stamp> first_visit;  ///< of the place, where there is one

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, experience, pose, first_visit);
    }
  };

  // what it offers as capabilities
  std::vector<Event> events() const override { return events_; }
  GraphView graph() const override;
  std::vector<StampedPose> path() const override;
  std::vector<PlaceVisit> visits() const override;

  void relocate();
  void move(const Motion& motion);
  ExperienceMap::Arrival arrive(const PoseCellState& state);
  Status statusOf(const PoseCellState& state, ExperienceMap::Arrival arrival);
  void noteLoop(const Pose2& before);
  void noteStep(Stamp stamp, bool is_at_place);
  Status forgetSteps();

  ExperienceConfig config_;
  ExperienceMap map_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< of odometry since the start
  std::deque<WayPoint> way_;                              ///< the last most_steps of them
  std::vector<Event> events_;                             ///< of the last step
  Inputs inputs_;
  Counters counters_;
};

}  // namespace slam::rat
