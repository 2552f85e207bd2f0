// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/association/sightings.hpp"
#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/contract/session_merger.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/graph_slam/delayed_decisions.hpp"
#include "slam_core/graph_slam/graph_config.hpp"
#include "slam_core/graph_slam/names.hpp"
#include "slam_core/graph_slam/path_record.hpp"
#include "slam_core/graph_slam/path_reduction.hpp"
#include "slam_core/graph_slam/scan_graph.hpp"
#include "slam_core/graph_slam/session.hpp"
#include "slam_core/graph_slam/waiting_session.hpp"

namespace slam::graph_slam {

/// Graph-SLAM (thesis chapter 3; Grisetti, Kuemmerle, Stachniss, Burgard 2010): the whole path and
/// the map are optimised with each observation, of which only what has changed is computed (Kaess
/// et al. 2012). So the past is corrected when a loop closes.
///
/// With a grid the path is told by a laser's scans as well (ScanGraph), and the grid is drawn of
/// them.
class GraphSlam final : public Backend,
                        CorrectionReporter,
                        LandmarkMapper,
                        LandmarkRemover,
                        GridMapper,
                        LostReporter,
                        EventReporter,
                        GraphReporter,
                        MapChooser,
                        MapKeeper,
                        SessionKeeper,
                        SessionMerger,
                        PathReviser,
                        AssociationChooser,
                        Calibrator {
 public:
  /// @throw ConfigError
  void configure(const GraphConfig& config, const grid_map::GridMapConfig& grid = {},
                 const scan_matching::MatcherConfig& matcher = {});
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const Motion& motion);
  void set(const LandmarkObservationArray& observations) { observations_ = observations; }
  void set(const LaserScan& scan) { scan_ = scan; }
  void set(const PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  Status execute() override;

  PoseEstimate pose() const override { return graph_->path.robot(); }
  Counters counters() const override { return counters_; }
  Figures figures() const override;

  void reset() override;
  /// A session that was loaded has to be in force first.
  bool canResume() const override { return !resumed_; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (Archive::kReads) graph_ = emptyGraph({});
    archive(*graph_, associator_, revision_, sightings_, statistics_, events_, counters_,
            is_corrected_, fixed_map_, last_motion_, has_moved_, map_, initial_pose_, motion_,
            J_wheels_, observations_, scan_);
    auto sessions = waitingSessions();
    archive(sessions, refused_);
    if constexpr (Archive::kReads) waitFor(sessions);
    for (auto& session : waiting_) archive(*session);
  }

 private:
  // what it offers as capabilities
  std::optional<Stamp> correctedBy() const override;
  LandmarkMap landmarks() const override;
  UpdateStatistics statistics() const override { return statistics_; }
  Status remove(LandmarkId id) override;
  MapState state() const override;
  void set(const MapState& map) override { map_ = map; }
  SavedSession session() const override;
  void set(const SavedSession& session) override;
  void merge(const SavedSession& session) override;
  std::vector<SavedSession> unmerged() const override;
  std::unique_ptr<Backend> makeAlike() const override;
  std::vector<StampedPose> path() const override {
    return graph_->record.poses(graph_->path.graph());
  }

  std::optional<OccupancyGrid> grid() const override;
  std::uint64_t gridRevision() const override;
  std::optional<Stamp> lostSince() const override;
  std::vector<Event> events() const override { return events_; }
  GraphView graph() const override;
  std::vector<MapKind> maps() const override { return {MapKind::kLandmarks, MapKind::kGrid}; }
  void useMap(MapKind map) override { uses_grid_ = map == MapKind::kGrid; }
  void useAssociation(const std::string& policy) override { association_ = policy; }
  std::optional<CalibrationEstimate> calibration() const override;
  const CalibrationConfig& calibrationConfig() const override { return config_.calibration; }
  LandmarkObservationArray corrected(const LandmarkObservationArray& array) const override;

  static std::size_t nodesPerPlace(const GraphConfig& config);
  /// Parameters that are calibrated are points in the graph.
  static graph::OptimizerLimits optimizerLimits(const GraphConfig& config);
  /// The path and what hangs on it.
  struct Graph {
    Graph(const GraphConfig& config, const PoseEstimate& start)
        : path({config.node_distance, config.node_angle}, start, optimizerLimits(config)),
          delayed(config),
          reduction({nodesPerPlace(config), config.mapIsFixed()}, path, landmarks, record) {}
    PathGraph path;
    LandmarkGraph landmarks{path};
    DelayedDecisions delayed;
    std::optional<ScanGraph> scans;  ///< where there is a grid
    PathRecord record;
    PathReduction reduction;

    template <class Archive>
    void persist(Archive& archive) {
      archive(path, landmarks, delayed, record, reduction);
      if (scans) archive(*scans);
    }
  };
  /// A session to go on with.
  struct Resumed {
    std::unique_ptr<Graph> graph;
    association::Sightings sightings;
    LandmarkMap known;  ///< its landmarks with their descriptors, without covariances
    std::optional<Motion> last_motion;
  };
  /// @param known of the parameters, where they are calibrated; else what the robot file says
  std::unique_ptr<Graph> emptyGraph(const PoseEstimate& start,
                                    const std::optional<CalibrationEstimate>& known = {}) const;
  /// @throw ConfigError where something cannot be calibrated
  void checkCalibration(const GraphConfig& config) const;
  void add(const Motion& motion);
  Session snapshot() const;
  Resumed resumed(const Session& session) const;
  void resume();
  Status replaceMap();
  void relocate();
  void predict();
  Status takeObservations();
  Status takeScan();
  void requireMergeable(const Session& session) const;
  std::vector<SharedScan> scansToLookFor() const;
  std::vector<SavedSession> waitingSessions() const;
  void waitFor(const std::vector<SavedSession>& sessions);
  Status mergeWaiting();
  Status mergeBy(std::unique_ptr<WaitingSession>& waiting);
  Status reconsider(const Association& association, const Pose2& sensor);
  Status reinitialize(const association::Sightings::Verdict& verdict, const Pose2& sensor);
  Status augment(Association& association, const Pose2& sensor);
  void removeGhosts(const Association& association, const Pose2& sensor);
  Status summary(const Association& association, const std::vector<Status>& of_steps) const;

  bool uses_grid_ = false;
  std::string association_ = "known_ids";
  GraphConfig config_;
  grid_map::GridMapConfig grid_config_;
  scan_matching::MatcherConfig matcher_config_;
  Associator associator_;
  std::unique_ptr<Graph> graph_;
  std::uint64_t revision_ = 0;  ///< of the grids of the graphs before this one
  association::Sightings sightings_;
  UpdateStatistics statistics_;
  std::vector<Event> events_;  ///< of the last step
  bool is_corrected_ = false;  ///< by the scan of the last step
  Counters counters_;
  LandmarkMap fixed_map_;  ///< as it was loaded, to localise in

  std::vector<std::unique_ptr<WaitingSession>> waiting_;  ///< to be merged
  std::vector<SavedSession> refused_;                     ///< the last that could not be merged
  std::optional<Resumed> resumed_;
  std::optional<Motion> last_motion_;  ///< for a session that goes on; not of this run at first
  bool has_moved_ = false;             ///< since a session was taken up
  std::optional<MapState> map_;
  std::optional<PoseEstimate> initial_pose_;
  std::optional<Motion> motion_;  ///< all motions since the last step as one, calibrated
  /// Its Jacobian by the wheels' parameters.
  Eigen::Matrix3d J_wheels_ = Eigen::Matrix3d::Zero();
  std::optional<LandmarkObservationArray> observations_;
  std::optional<LaserScan> scan_;
};

}  // namespace slam::graph_slam
