// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "slam_core/graph_slam/submap.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::graph_slam {

/// All that the graph's back-end needs to go on from where it stopped: plain values, to be saved,
/// merged and optimised by whoever likes. Poses are in the map frame where nothing else is said.
///
/// Nodes, landmarks, factors and scans are named by their places in the lists here. A weight W is a
/// square root of an information matrix, W^T W = R^-1, as in graph/factors.hpp; of poses by twists
/// in their own frames, of points in the map frame, which a rigid motion of the map turns.
struct Session {
  using Index = std::uint32_t;

  /// A product can use a session of the same kind only.
  struct Kind {
    bool has_grid = false;
    double resolution = 0.0;  ///< of the grid [m]
    /// The landmarks' ids are of the session's own making, as observations are associated by place:
    /// they mean nothing in another session.
    bool has_own_ids = false;
  };
  struct Landmark {
    LandmarkId id = kUnknownId;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
    int fits = 0, misses = 0;                            ///< see association::Sightings
    bool is_retired = false;  ///< it was removed: its factors count, it is in no map
    Descriptor descriptor = {};
  };

  struct PosePrior {
    Index node = 0;
    Pose2 pose;
    Eigen::Matrix3d weight;
  };
  struct PointPrior {
    Index landmark = 0;
    Eigen::Vector2d point;  ///< [m]
    Eigen::Matrix2d weight;
  };
  struct JointPrior {
    Index node = 0;
    std::vector<Index> landmarks;
    Pose2 pose;
    std::vector<Eigen::Vector2d> points;  ///< by landmark [m]
    Eigen::MatrixXd weight;               ///< of the pose, then the points
  };
  struct Between {
    Index from = 0, to = 0;
    Pose2 motion;  ///< T_from_to
    Eigen::Matrix3d weight;
  };
  struct RangeBearing {
    Index node = 0, landmark = 0;
    Pose2 sensor;       ///< T_node_sensor
    Eigen::Vector2d z;  ///< range [m], bearing [rad]
    Eigen::Matrix2d weight;
  };
  using Factor = std::variant<PosePrior, PointPrior, JointPrior, Between, RangeBearing>;

  /// A place that was recognised. Only where it is believed it is a factor of the graph.
  struct Loop {
    Between between;
    bool is_believed = false;
    double share = 1.0;     ///< of its chi2 that counts, where it is believed
    bool is_alone = false;  ///< it waits for another one that says the same
  };

  /// Observations that a later one from the same node will be fused with.
  struct Sighting {
    Index factor = 0;  ///< a RangeBearing
    LandmarkObservation z;
    Pose2 sensor;  ///< T_node_sensor
  };

  /// A pose of the path relative to a node, or in the map where there is none.
  struct Mark {
    Stamp stamp;
    std::optional<Index> node;
    Pose2 pose;
  };

  /// The robot is at the last node and the motion since then, or where it was put.
  struct Robot {
    std::optional<Index> node;
    std::optional<Motion> motion;
    PoseEstimate start;       ///< where there is no node
    std::uint64_t nodes = 0;  ///< of the whole path
  };

  struct Scan {
    Index node = 0;
    Pose2 drawn;  ///< where the grid has it
    SharedScan scan;
  };
  struct PlacedScan {
    Index scan = 0;
    Pose2 pose;  ///< T_odom_base
  };
  struct Submap {
    Index origin = 0;      ///< a node
    Pose2 odom_origin;     ///< T_odom_origin, where that was drawn
    bool is_base = false;  ///< it begins with the grid that was loaded
    std::vector<PlacedScan> scans;
    double ended = 0.0;  ///< the way that had been gone with its last scan; where finished [m]
  };
  /// A node that scans go by.
  struct Place {
    Index node = 0;
    PoseEstimate in_odom;        ///< T_odom_base
    std::optional<Motion> told;  ///< since then, by odometry
  };
  /// The submaps, and the robot in their odometry frame. Only submaps with scans or a loaded grid
  /// are among them.
  struct Submaps {
    std::vector<Submap> finished;
    std::optional<Submap> older, younger;
    double gone = 0.0, renewed = 0.0;  ///< [m]
    Pose2 drawn;                       ///< the last scan in them, T_odom_base
    PoseEstimate robot;                ///< at the last scan, T_odom_base
    std::optional<Motion> carried;     ///< since the last scan
    std::optional<Place> last;         ///< the last node that had a scan
    std::optional<Place> reference;    ///< the last one that is drawn in the submap
  };

  Kind kind;
  Stamp stamp;  ///< of the last step
  std::vector<Pose2> nodes;
  std::vector<Landmark> landmarks;
  std::vector<Factor> factors;
  std::vector<Index> chords;  ///< factors that are a second motion to a node, in order
  std::vector<Loop> loops;    ///< in the order in which they were found
  std::optional<Index> sightings_node;
  std::vector<Sighting> sightings;
  std::vector<Mark> path;
  Robot robot;
  std::optional<Motion> last_motion;  ///< as the odometry reported it
  std::vector<Scan> scans;
  Submaps submaps;
  std::optional<OccupancyGrid> base;  ///< a grid that was loaded, below all scans
};

}  // namespace slam::graph_slam
