// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "slam_core/association/existence.hpp"
#include "slam_core/ekf/gaussian_transform.hpp"
#include "slam_core/ekf/linearization.hpp"
#include "slam_core/ekf/neighbourhood.hpp"
#include "slam_core/ekf/sensor_frame.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/line_model.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::ekf {

/// What distinguishes one filter of this family from another.
struct FilterVariant {
  std::shared_ptr<const Linearization> linearization;
  std::shared_ptr<const GaussianTransform> transform = std::make_shared<TaylorTransform>();
};

/// How much of the map an update touches: what limits an interval between two global updates
/// (Neighbourhood).
struct StretchLimits {
  /// The interval ends before more than this many landmarks are observed, or twice as many as are
  /// in view where that is more.
  Eigen::Index landmarks = 64;
  bool whole_map = false;  ///< every landmark is in the neighbourhood: no compression
};

/// The landmarks that the observations of a stamp may be of, by their numbers.
struct LandmarksInView {
  std::vector<Eigen::Index> landmarks;  ///< one may stand here more than once
  Eigen::Index others = 0;              ///< observations of landmarks that may be new
  Eigen::Index observations = 0;        ///< all of them
};

/// Where an observation puts a landmark, its Jacobian by the robot, and the observation's noise.
struct NewLandmark {
  Eigen::Vector2d m_map = Eigen::Vector2d::Zero();  ///< [m], or of a line [m, rad]
  Eigen::Matrix<double, 2, 3> J_robot = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();
  std::optional<MappedLine> line = std::nullopt;  ///< of a line

  /// A landmark so far away that its covariance would not be finite is not finite either.
  bool isFinite() const {
    return m_map.allFinite() && R.allFinite() && (J_robot * J_robot.transpose()).allFinite();
  }
};

/// The Gaussian over robot and map: estimates, their joint covariance (Neighbourhood), and the ids
/// of the landmarks in the order in which they were first seen, which is their number. The
/// linearisation says which error the covariance describes; what comes out is always that of (x, y,
/// theta) and (x, y). To look at the state does not change it, not by a bit. Where parameters are
/// calibrated, the Gaussian is over them as well: they take the first numbers, are in every
/// neighbourhood, and are in no map; robot and map are in the coordinates of a SensorFrame.
class EkfState {
 public:
  EkfState() = default;
  /// @param calibration nothing where nothing is calibrated
  EkfState(FilterVariant variant, StretchLimits limits, const PoseEstimate& robot,
           const std::optional<CalibrationEstimate>& calibration = std::nullopt);
  /// Landmarks without a joint covariance get their marginals times `inflation` squared.
  EkfState(FilterVariant variant, StretchLimits limits, const MapState& map, double inflation,
           const std::optional<CalibrationEstimate>& calibration = std::nullopt);

  const Pose2& robot() const { return robot_; }
  /// @return the number of landmarks, retired ones included; each has a number below it
  std::size_t landmarks() const { return ids_.size(); }
  /// @return the number of landmarks in the map
  std::size_t inMap() const { return index_.size(); }
  /// The number of the landmark with this id.
  std::optional<std::size_t> find(LandmarkId id) const;
  LandmarkId id(std::size_t landmark) const { return ids_[landmark]; }
  /// An id that no landmark has, nor one that was retired.
  LandmarkId freeId() const { return largest_id_ + 1; }
  /// The slot of a landmark in the neighbourhood; -1 where it was not taken.
  Eigen::Index slotOf(std::size_t landmark) const {
    return neighbourhood_.slot(static_cast<Eigen::Index>(landmark));
  }
  /// A landmark of the neighbourhood; with a candidate for the corrections of its position and of
  /// the reference's heading, before they are applied.
  LandmarkPoint point(Eigen::Index slot,
                      const Eigen::Vector2d& correction = Eigen::Vector2d::Zero(),
                      double turn = 0.0) const;
  /// The line that a landmark is; nullptr where it is a point.
  const MappedLine* line(std::size_t landmark) const {
    return lines_[landmark] ? &*lines_[landmark] : nullptr;
  }
  const DenseCovariance& covariance() const { return neighbourhood_.covariance(); }
  const Linearization& linearization() const { return *variant_.linearization; }
  /// nu, R and H of an observation of a landmark of the neighbourhood.
  Innovation innovation(const ObservedLandmark& observed, const ObservedCovariance& P) const;

  /// Takes these into the neighbourhood; where it would grow too large the interval ends first.
  void take(const LandmarksInView& view);
  /// @param J_increment by the calibrated parameters, of (x, y, theta)
  PosePrediction predict(const Pose2& increment, const Eigen::Matrix3d& Q,
                         const CalibrationJacobian<3>& J_increment = {});
  /// x <- x + dx and P <- P - W W^T, rows as in covariance().
  void update(const Eigen::VectorXd& dx, const Eigen::MatrixXd& W);
  /// The same for the robot only, the map being known (Schmidt-Kalman update).
  void updateRobot(const Eigen::VectorXd& dx, const Eigen::MatrixXd& W);
  /// Another part of a line of the neighbourhood was seen.
  void extend(Eigen::Index slot, const Pose2& sensor, const LandmarkObservation& z);
  /// Appends m = g(robot, z): J = dg/drobot, R the noise of z mapped into the plane.
  void append(LandmarkId id, const NewLandmark& m);
  /// Re-initialises a known landmark, in its place in the order.
  void beginAnew(LandmarkId id, const NewLandmark& m);
  /// A landmark is not found any more, nor in map() and state(). The Gaussian keeps it, which
  /// leaves the others as if it were marginalised. Its number is never given again; its id may be.
  void retire(LandmarkId id);
  /// The robot is put elsewhere: its correlations become zero.
  void relocate(const PoseEstimate& robot);
  /// A new interval with the same landmarks, unless this one has just begun.
  void renewReference();

  /// The estimated parameters; nothing where nothing is calibrated.
  std::optional<CalibrationVector> parameters() const;
  /// The same with their covariance.
  std::optional<CalibrationEstimate> calibration() const;
  /// Robot and parameters; only where parameters are calibrated.
  SensorFrame::Joint robotAndParameters() const;
  PoseEstimate pose() const { return {robot_, covariance().robot()}; }
  std::vector<association::LandmarkPlace> places() const;  ///< of points, sorted by id
  LandmarkMap map() const;                                 ///< sorted by id, with marginals
  /// The same with diagonal covariances that are no less than the marginals, at a fraction of the
  /// cost.
  LandmarkMap boundedMap() const;
  /// Sorted by id, with the joint covariance of (pose, parameters if any, landmarks).
  MapState state() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(robot_, neighbourhood_, parameter_pairs_, ids_, largest_id_, index_, starts_, firsts_,
            lines_, born_, is_seen_, seen_);
  }

 private:
  LandmarkPoint point(Eigen::Index landmark, const Eigen::Vector2d& correction, double turn,
                      double born) const;
  double turn() const { return neighbourhood_.correction()(DenseCovariance::kHeadingRow); }
  std::vector<LandmarkPoint> allPoints() const;
  Eigen::Matrix2Xd transports(const std::vector<LandmarkPoint>& points) const;
  template <class CovarianceOf>
  LandmarkMap mapOf(const std::vector<LandmarkPoint>& points,
                    const CovarianceOf& covariance_of) const;
  Landmark landmark(Eigen::Index landmark, const LandmarkPoint& point) const;
  void correctRobot(const Eigen::Vector3d& dx);
  void renew();
  void add(const std::optional<CalibrationEstimate>& calibration);
  bool isParameter(Eigen::Index landmark) const { return landmark < parameter_pairs_; }
  void takeAlways();
  std::vector<Eigen::Index> orderById() const;

  FilterVariant variant_;
  StretchLimits limits_;
  Pose2 robot_;
  Neighbourhood neighbourhood_;
  Eigen::Index parameter_pairs_ = 0;  ///< so many of the first landmarks are parameters
  std::vector<LandmarkId> ids_;
  LandmarkId largest_id_ = kUnknownId;
  std::unordered_map<LandmarkId, Eigen::Index> index_;  // looked up only, never iterated
  std::vector<Eigen::Vector2d> starts_, firsts_;        ///< see LandmarkPoint
  std::vector<std::optional<MappedLine>> lines_;        ///< by landmark
  std::vector<double> born_;   ///< turn() when the landmark was added, by landmark
  std::vector<bool> is_seen_;  ///< in this interval, by landmark
  Eigen::Index seen_ = 0;      ///< how many of them
};

}  // namespace slam::ekf
