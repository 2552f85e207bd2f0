// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/ekf/innovation.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/line_model.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::ekf {

/// A landmark as a linearisation looks at it: a point [m], map frame, or a line [m, rad].
struct LandmarkPoint {
  Eigen::Vector2d now;              ///< the newest estimate
  Eigen::Vector2d start;            ///< when the interval began, or when it was added since
  Eigen::Vector2d first;            ///< when it was added to the map
  const LineModel* line = nullptr;  ///< of a line

  /// The model by which the landmark is observed.
  const ObservationModel& modelOr(const ObservationModel& of_points) const {
    return line != nullptr ? static_cast<const ObservationModel&>(*line) : of_points;
  }
};

/// Which error the covariance describes, where Jacobians are evaluated and how a correction moves
/// the estimate. An interval is the time between two choices of the reference pose, a past pose of
/// the robot (neighbourhood.hpp). What the filter always does, with e the errors in (x, y, theta):
/// - the robot's error refers to its newest estimate: a correction that moves it by d turns e_xy
///   into e_xy + robotTransport e_theta;
/// - a landmark's error refers to where it was when the interval began. When the interval ends, it
///   becomes e_m + landmarkTransport e_theta of the reference.
/// The published covariances are always those of (x, y, theta) and (x, y).
class Linearization {
 public:
  virtual ~Linearization() = default;

  /// nu, R and H of an observation.
  /// @param model of points
  /// @param robot where Jacobians may be evaluated, a candidate within an iterated update
  /// @param origin the predicted pose, to which the error of the robot refers
  virtual Innovation innovation(const ObservationModel& model, const Pose2& robot,
                                const Pose2& origin, const Pose2& sensor,
                                const LandmarkPoint& landmark,
                                const LandmarkObservation& z) const = 0;
  /// The pose after a correction of (x, y, theta).
  virtual Pose2 moved(const Pose2& robot, const Eigen::Vector3d& correction) const;
  /// The correction that moves one pose to another: the inverse of the above.
  virtual Eigen::Vector3d correctionTo(const Pose2& robot, const Pose2& moved) const;
  /// The landmark after all corrections of an interval; `turn`: those of the reference's heading.
  virtual Eigen::Vector2d moved(const Eigen::Vector2d& start, const Eigen::Vector2d& correction,
                                double turn) const;

  /// The same of a line.
  virtual Eigen::Vector2d moved(const LineModel& line, const Eigen::Vector2d& start,
                                const Eigen::Vector2d& correction, double turn) const;

  virtual Eigen::Vector2d robotTransport(const Pose2& before, const Pose2& after) const;
  virtual Eigen::Vector2d landmarkTransport(const LandmarkPoint& landmark) const;

  /// Whether another linearisation point gives other Jacobians, so that iterating makes sense.
  virtual bool relinearizes() const { return true; }
  /// Whether the interval has to end after a step. turn: as above; variance: of the robot's heading
  /// relative to that of the reference.
  virtual bool isStale(double /*turn*/, double /*variance*/) const { return false; }
  /// Whether the interval has to end before so large a correction of the robot's heading.
  virtual bool isTooLarge(double /*heading_correction*/) const { return false; }
};

/// At the newest estimate (Thrun, Burgard, Fox 2005, ch. 10). With each correction the filter
/// believes to have learnt something of the map's heading, which nothing can be known of.
class TextbookLinearization final : public Linearization {
 public:
  Innovation innovation(const ObservationModel& model, const Pose2& robot, const Pose2& origin,
                        const Pose2& sensor, const LandmarkPoint& landmark,
                        const LandmarkObservation& z) const override;
};

/// At the predicted pose and where the landmark was first estimated (Huang, Mourikis, Roumeliotis
/// 2010, FEJ-EKF): what cannot be observed stays so, at the price of old linearisation points.
/// Their motion Jacobian from one predicted pose to the next is the textbook's after
/// robotTransport.
class FirstEstimatesLinearization : public Linearization {
 public:
  Innovation innovation(const ObservationModel& model, const Pose2& robot, const Pose2& origin,
                        const Pose2& sensor, const LandmarkPoint& landmark,
                        const LandmarkObservation& z) const override;
  Eigen::Vector2d robotTransport(const Pose2& before, const Pose2& after) const override;
  bool relinearizes() const override { return false; }
};

/// The Jacobian nearest to the textbook's (least squares) under which the directions that cannot
/// be observed at the first estimates stay so (OC-EKF: the same constraint in Huang, Mourikis,
/// Roumeliotis 2010, solved by projection).
class ConstrainedLinearization final : public FirstEstimatesLinearization {
 public:
  Innovation innovation(const ObservationModel& model, const Pose2& robot, const Pose2& origin,
                        const Pose2& sensor, const LandmarkPoint& landmark,
                        const LandmarkObservation& z) const override;
};

/// The right-invariant error of the group SE_{1+N}(2) (Barrau and Bonnabel 2015, 2017): robot and
/// map turn together with the heading's error, so that a correction leaves unobservable what was
/// so. Of a line, which the group moves otherwise, this holds for its turning; its shift refers to
/// the newest direction. Written in the coordinates (x, y, theta) it is the textbook filter with
/// two changes: the correction goes through the group's exponential, and the covariance is carried
/// along with the estimate (the transports). Landmarks turn with the reference's heading instead of
/// the robot's, which equals it at the start of the interval: so landmarks out of sight need not be
/// touched at every step. The interval ends before the two headings part.
class RightInvariantLinearization final : public Linearization {
 public:
  Innovation innovation(const ObservationModel& model, const Pose2& robot, const Pose2& origin,
                        const Pose2& sensor, const LandmarkPoint& landmark,
                        const LandmarkObservation& z) const override;
  Pose2 moved(const Pose2& robot, const Eigen::Vector3d& correction) const override;
  Eigen::Vector3d correctionTo(const Pose2& robot, const Pose2& moved) const override;
  Eigen::Vector2d moved(const Eigen::Vector2d& start, const Eigen::Vector2d& correction,
                        double turn) const override;
  Eigen::Vector2d moved(const LineModel& line, const Eigen::Vector2d& start,
                        const Eigen::Vector2d& correction, double turn) const override;
  Eigen::Vector2d robotTransport(const Pose2& before, const Pose2& after) const override;
  Eigen::Vector2d landmarkTransport(const LandmarkPoint& landmark) const override;
  bool isStale(double turn, double variance) const override;
  bool isTooLarge(double heading_correction) const override;
};

const std::vector<std::string>& linearizationNames();

/// `name` is one of linearizationNames().
std::unique_ptr<Linearization> makeLinearization(const std::string& name);

}  // namespace slam::ekf
