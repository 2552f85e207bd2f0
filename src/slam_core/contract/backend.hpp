// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/contract/stamped_pose.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/occupancy_grid.hpp"

namespace slam {

/// How far an observation of a known landmark was from the prediction.
struct ObservationInnovation {
  LandmarkId id = kUnknownId;
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();  ///< in range [m] and bearing [rad]
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();   ///< its covariance, as the back-end believes
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();   ///< the observation's part of it
  bool used = false;                             ///< it passed the gate
};

/// The same of several observations of a stamp together, (range, bearing) one after the other.
struct JointInnovation {
  Eigen::VectorXd nu;
  Eigen::MatrixXd S, R;
  /// Jacobian of what is foretold by the pose (x, y, theta), map frame; empty where not told.
  Eigen::MatrixX3d H;
};

/// What the last execute() made of its observations.
struct UpdateStatistics {
  double nis = 0.0;   ///< normalised innovation squared of the used observations together
  int nis_dof = 0;    ///< its degrees of freedom
  int used = 0;       ///< observations of known landmarks that went into the update
  int gated = 0;      ///< outside the chi-square gate, left out
  int added = 0;      ///< landmarks seen for the first time
  int unknown = 0;    ///< without an id, or not in a fixed map; left out
  int landmarks = 0;  ///< in the map after the step
  /// Of the observations of known landmarks: log N(nu; 0, S). Outside the gate the density falls
  /// like a power of the distance instead, so that an outlier costs more the smaller S is.
  double log_likelihood = 0.0;
  /// One by one, those that were gated included; in the order of the observations.
  std::vector<ObservationInnovation> innovations;
  JointInnovation joint;      ///< of the first of those that were used, kJoint at most
  PosePrediction prediction;  ///< before the observations; counts only where joint.H is told

  static constexpr std::size_t kJoint = 8;
};

/// The role of a SLAM back-end: motion and observations in, pose and landmark map out
/// (thesis 3.4.2).
///
/// Who calls: the Estimator, from one thread, in the order configure, then for each step set(...)
/// of everything since the last one and execute(). It owns the back-end. Inputs come in the order
/// of stamps and are free of NaN; ids of an array are sorted and may repeat.
///
/// A new back-end derives from this, registers itself (contract/registry.hpp) and must pass the
/// back-end contract suite.
class Backend {
 public:
  static constexpr const char* kRole = "back-end";

  virtual ~Backend() = default;

  /// Names all its random streams from the next configure() or reset() on. Back-ends that draw
  /// nothing need it not.
  virtual void seed(std::uint64_t /*seed*/) {}
  /// The representations of a map that it can make.
  virtual std::vector<std::string> maps() const { return {"landmarks"}; }
  /// Makes this one of maps() from the next configure() on.
  virtual void useMap(const std::string& /*map*/) {}
  /// A fresh start. @throw ConfigError listing all faults of its section
  virtual void configure(Settings& settings) = 0;

  /// Inputs are stored until execute(). Motions add up.
  virtual void set(const Motion& motion) = 0;
  virtual void set(const LandmarkObservationArray& observations) = 0;
  /// Only where usesScans(). At most one of observations and scan comes before an execute().
  virtual void set(const LaserScan& /*scan*/) {}
  /// The robot is re-drawn there; the map is kept, correlations to it are removed.
  virtual void set(const PoseEstimate& initial_pose) = 0;
  /// The map and the pose are replaced. Without a joint covariance the marginals are inflated.
  virtual void set(const MapState& map) = 0;

  /// Whether it wants laser scans; after configure().
  virtual bool usesScans() const { return false; }

  /// One step: a map or pose that was set, then the motions, then the observations or the scan.
  /// A map that cannot be used is an error and leaves map and pose as they are.
  virtual Status execute() = 0;

  virtual PoseEstimate pose() const = 0;      ///< in the map frame
  virtual LandmarkMap landmarks() const = 0;  ///< sorted by id
  virtual MapState state() const = 0;         ///< all that save_map writes
  virtual UpdateStatistics statistics() const = 0;
  virtual const Counters& counters() const = 0;

  /// Of back-ends with samples: their poses in the map frame.
  virtual std::vector<Pose2> particles() const { return {}; }
  /// Of back-ends that revise the past: the most likely path as it is seen now, a pose for each
  /// step since the map was begun or loaded. Empty: what pose() told is all there is.
  virtual std::vector<StampedPose> path() const { return {}; }
  /// The grid map of back-ends that make one: all that is known of it, cut to what has been seen.
  virtual std::optional<OccupancyGrid> grid() const { return std::nullopt; }
  /// Grows whenever grid() would tell something else, also where all begins anew.
  virtual std::uint64_t gridRevision() const { return 0; }
  /// Figures of its own that are worth a diagnostic, by name.
  virtual std::map<std::string, double> figures() const { return {}; }

  /// As after configure().
  virtual void reset() = 0;
};

}  // namespace slam
