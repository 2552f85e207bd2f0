// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/linearization.hpp"

#include <cmath>

#include "slam_core/common/policy_table.hpp"
#include "slam_core/geometry/angle.hpp"

// Symbols: p position of the robot, m landmark, J the rotation by a right angle (d R(a) v / da =
// J R(a) v), w correction of a heading.

namespace slam::ekf {
namespace {

/// How far apart the headings of robot and reference may be, and how much either may be corrected
/// at a time [rad]: what is neglected is of second order in these.
constexpr double kStaleSigma = 0.03;
constexpr double kLargeTurn = 0.02;

Eigen::Vector2d J(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

/// The exponential map's action on a point: turned by w, and the rest of the correction along the
/// arc on which it turns. To first order point + correction.
Eigen::Vector2d movedOnGroup(const Eigen::Vector2d& point, const Eigen::Vector2d& correction,
                             double w) {
  const Eigen::Vector2d xi = correction - w * J(point);
  const Pose2 T = Pose2::exp({xi.x(), xi.y(), w});
  return T.transform(point);
}

Innovation linearized(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
                      const Eigen::Vector2d& m_map, const LandmarkObservation& z) {
  Innovation innovation;
  const Eigen::Vector2d z_predicted =
      model.predict(robot, sensor, m_map, &innovation.H_robot, &innovation.H_landmark);
  innovation.nu = model.innovation(z.vector(), z_predicted);
  innovation.R = z.covariance;
  return innovation;
}

}  // namespace

Pose2 Linearization::moved(const Pose2& robot, const Eigen::Vector3d& correction) const {
  return Pose2::fromVector(robot.vector() + correction);
}

Eigen::Vector3d Linearization::correctionTo(const Pose2& robot, const Pose2& moved) const {
  const Eigen::Vector2d way = moved.position() - robot.position();
  return {way.x(), way.y(), wrapAngle(moved.theta() - robot.theta())};
}

Eigen::Vector2d Linearization::moved(const Eigen::Vector2d& start,
                                     const Eigen::Vector2d& correction, double /*turn*/) const {
  return start + correction;
}

Eigen::Vector2d Linearization::moved(const LineModel& /*line*/, const Eigen::Vector2d& start,
                                     const Eigen::Vector2d& correction, double /*turn*/) const {
  return start + correction;
}

Eigen::Vector2d Linearization::robotTransport(const Pose2&, const Pose2&) const {
  return Eigen::Vector2d::Zero();
}

Eigen::Vector2d Linearization::landmarkTransport(const LandmarkPoint&) const {
  return Eigen::Vector2d::Zero();
}

Innovation TextbookLinearization::innovation(const ObservationModel& model, const Pose2& robot,
                                             const Pose2& /*origin*/, const Pose2& sensor,
                                             const LandmarkPoint& landmark,
                                             const LandmarkObservation& z) const {
  return linearized(landmark.modelOr(model), robot, sensor, landmark.now, z);
}

Innovation FirstEstimatesLinearization::innovation(const ObservationModel& of_points,
                                                   const Pose2& robot, const Pose2& origin,
                                                   const Pose2& sensor,
                                                   const LandmarkPoint& landmark,
                                                   const LandmarkObservation& z) const {
  const auto& model = landmark.modelOr(of_points);
  const bool on_top = model.isSingular(model.predict(origin, sensor, landmark.first));
  auto innovation = linearized(model, origin, sensor, on_top ? landmark.now : landmark.first, z);
  innovation.nu = model.innovation(z.vector(), model.predict(robot, sensor, landmark.now));
  return innovation;
}

Eigen::Vector2d FirstEstimatesLinearization::robotTransport(const Pose2& before,
                                                            const Pose2& after) const {
  return J(after.position() - before.position());
}

Innovation ConstrainedLinearization::innovation(const ObservationModel& model, const Pose2& robot,
                                                const Pose2& /*origin*/, const Pose2& sensor,
                                                const LandmarkPoint& landmark,
                                                const LandmarkObservation& z) const {
  if (landmark.line != nullptr) return linearized(*landmark.line, robot, sensor, landmark.now, z);
  if (model.isSingular(model.predict(robot, sensor, landmark.first)))
    return linearized(model, robot, sensor, landmark.now, z);
  // H = (-A, -A J (offset of the sensor) - b, A) with b = A J d, d from the sensor to the
  // landmark, both at one point. A is changed so that A J d = b holds for the first estimate.
  auto innovation = linearized(model, robot, sensor, landmark.now, z);
  const Eigen::Vector2d p_sensor = robot.transform(sensor.position());
  auto& A = innovation.H_landmark;
  const Eigen::Vector2d b = A * J(landmark.now - p_sensor), Jd = J(landmark.first - p_sensor);
  A -= (A * Jd - b) * Jd.transpose() / Jd.squaredNorm();
  innovation.H_robot.leftCols<2>() = -A;
  innovation.H_robot.col(2) = -A * J(p_sensor - robot.position()) - b;
  return innovation;
}

Innovation RightInvariantLinearization::innovation(const ObservationModel& model,
                                                   const Pose2& robot, const Pose2& origin,
                                                   const Pose2& sensor,
                                                   const LandmarkPoint& landmark,
                                                   const LandmarkObservation& z) const {
  auto innovation = linearized(landmark.modelOr(model), robot, sensor, landmark.now, z);
  innovation.H_robot.col(2) += innovation.H_robot.leftCols<2>() * robotTransport(origin, robot);
  innovation.H_heading = innovation.H_landmark * landmarkTransport(landmark);
  return innovation;
}

Pose2 RightInvariantLinearization::moved(const Pose2& robot,
                                         const Eigen::Vector3d& correction) const {
  const Eigen::Vector2d p = movedOnGroup(robot.position(), correction.head<2>(), correction.z());
  return {p.x(), p.y(), robot.theta() + correction.z()};
}

Eigen::Vector3d RightInvariantLinearization::correctionTo(const Pose2& robot,
                                                          const Pose2& moved) const {
  const Eigen::Vector3d xi = (moved * robot.inverse()).log();
  const Eigen::Vector2d p = xi.head<2>() + xi.z() * J(robot.position());
  return {p.x(), p.y(), xi.z()};
}

Eigen::Vector2d RightInvariantLinearization::moved(const Eigen::Vector2d& start,
                                                   const Eigen::Vector2d& correction,
                                                   double turn) const {
  return movedOnGroup(start, correction, turn);
}

Eigen::Vector2d RightInvariantLinearization::moved(const LineModel& line,
                                                   const Eigen::Vector2d& start,
                                                   const Eigen::Vector2d& correction,
                                                   double turn) const {
  return line.turned(start, turn) + correction - turn * line.turnDerivative(start);
}

Eigen::Vector2d RightInvariantLinearization::robotTransport(const Pose2& before,
                                                            const Pose2& after) const {
  return J(after.position() - before.position());
}

Eigen::Vector2d RightInvariantLinearization::landmarkTransport(
    const LandmarkPoint& landmark) const {
  if (landmark.line != nullptr)
    return landmark.line->turnDerivative(landmark.now) -
           landmark.line->turnDerivative(landmark.start);
  return J(landmark.now - landmark.start);
}

bool RightInvariantLinearization::isStale(double turn, double variance) const {
  return std::abs(turn) > kLargeTurn || variance > kStaleSigma * kStaleSigma;
}

bool RightInvariantLinearization::isTooLarge(double heading_correction) const {
  return std::abs(heading_correction) > kLargeTurn;
}

namespace {

const PolicyTable<Linearization>& linearizationTable() {
  static const PolicyTable<Linearization> kTable(
      {{"textbook", makePolicyOf<Linearization, TextbookLinearization>},
       {"first_estimates", makePolicyOf<Linearization, FirstEstimatesLinearization>},
       {"observability_constrained", makePolicyOf<Linearization, ConstrainedLinearization>},
       {"right_invariant", makePolicyOf<Linearization, RightInvariantLinearization>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& linearizationNames() { return linearizationTable().names(); }

std::unique_ptr<Linearization> makeLinearization(const std::string& name) {
  return linearizationTable().make(name);
}

}  // namespace slam::ekf
