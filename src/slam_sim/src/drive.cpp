// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/drive.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "slam_core/common/config_error.hpp"
#include "slam_core/geometry/angle.hpp"

namespace slam::sim {
namespace {

constexpr double kCheckStep = 0.05;  // of the way's clearance [s]
constexpr double kStep = 0.005;      // of the speed profile [m]
constexpr double kSharpTurn = 0.1;   // a step that turns by more is divided [rad]
constexpr double kTurn = 0.01;       // until each part turns by no more than this [rad]
constexpr double kLeastStep = 1e-6;  // or is no longer than this [m]
constexpr double kAlike = 0.95;      // a limit above this share of the speed changes nothing
constexpr int kParts = 8;            // of a step; their headings are compared
constexpr double kSwayLength = 3.0;  // of one swing of the heading, about [m]

double swayFrequency(double length) {
  return 2.0 * M_PI * std::max(1.0, std::round(length / kSwayLength)) / length;
}

}  // namespace

Drive::Drive(const DrivePath& path, const RobotModel& robot)
    : curve_(path.points),
      sway_(robot.heading_sway),
      sway_frequency_(swayFrequency(curve_.length())) {
  divide(curve_.length() * path.laps);
  for (std::size_t i = 0; i < distances_.size(); ++i)
    speeds_.push_back(isAtCusp(i) ? path.speed : limitAt(distances_[i], robot.limits, path.speed));
  limitTurns(robot.limits.turn_rate);
  limitAcceleration(robot.limits.acceleration);
  times_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < distances_.size(); ++i)
    times_.push_back(times_.back() +
                     2.0 * (distances_[i + 1] - distances_[i]) / (speeds_[i] + speeds_[i + 1]));
}

/// Divides the way into the steps of the speed profile. They are short at a cusp, where the way
/// nearly goes back along itself.
void Drive::divide(double total) {
  const auto count = static_cast<std::size_t>(std::ceil(total / kStep));
  const double step = total / static_cast<double>(count);
  distances_.push_back(0.0);
  for (std::size_t i = 1; i <= count; ++i) {
    const double end = total * static_cast<double>(i) / static_cast<double>(count);
    if (turn(distances_.back(), end) > kSharpTurn)
      refine(distances_.back(), end);
    else
      append(end, step);
  }
}

void Drive::refine(double begin, double end) {
  if (end - begin <= kLeastStep || turn(begin, end) <= kTurn) return append(end, end - begin);
  const double middle = 0.5 * (begin + end);
  refine(begin, middle);
  refine(middle, end);
}

void Drive::append(double end, double step) {
  distances_.push_back(end);
  steps_.push_back(step);
}

/// Returns whether a step that begins or ends here is short. The curvature there limits no speed,
/// since it may be arbitrarily large at a single point.
bool Drive::isAtCusp(std::size_t i) const {
  const auto is_short = [this](std::size_t step) {
    return step < steps_.size() && steps_[step] <= 0.5 * kStep;
  };
  return is_short(i) || (i > 0 && is_short(i - 1));
}

/// Finds the place in a step at which the heading changes fastest. Returns the angle by which it
/// would change in the step if it changed everywhere as fast [rad].
double Drive::turn(double begin, double end) const {
  double largest = 0.0, before = poseAt(begin).theta();
  for (int i = 1; i <= kParts; ++i) {
    const double heading = poseAt(begin + (end - begin) * i / kParts).theta();
    largest = std::max(largest, std::abs(wrapAngle(heading - before)));
    before = heading;
  }
  return largest * kParts;
}

double Drive::turnPerMetre(double s) const {
  return curve_.curvature(s) + sway_ * sway_frequency_ * std::cos(sway_frequency_ * s);
}

double Drive::limitAt(double s, const DriveLimits& limits, double wanted) const {
  const double curvature = std::abs(curve_.curvature(s)), turn = std::abs(turnPerMetre(s));
  double speed = wanted;
  if (curvature > 0.0) speed = std::min(speed, std::sqrt(limits.lateral_acceleration / curvature));
  if (turn > 0.0) speed = std::min(speed, limits.turn_rate / turn);
  return speed;
}

/// Lowers the speed in steps in which the robot turns faster than at their ends.
void Drive::limitTurns(double turn_rate) {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double limit = steps_[i] * turn_rate / turn(distances_[i], distances_[i + 1]);
    if (limit > kAlike * std::min(speeds_[i], speeds_[i + 1])) continue;
    for (const auto end : {i, i + 1}) speeds_[end] = std::min(speeds_[end], limit);
  }
}

/// From rest and to rest, forth and back (the usual two passes of time-optimal path following).
void Drive::limitAcceleration(double acceleration) {
  const auto faster = [&](double speed, double step) {
    return std::sqrt(speed * speed + 2.0 * acceleration * step);
  };
  speeds_.front() = speeds_.back() = 0.0;
  for (std::size_t i = 1; i < speeds_.size(); ++i)
    speeds_[i] = std::min(speeds_[i], faster(speeds_[i - 1], steps_[i - 1]));
  for (std::size_t i = speeds_.size() - 1; i-- > 0;)
    speeds_[i] = std::min(speeds_[i], faster(speeds_[i + 1], steps_[i]));
}

std::size_t Drive::segment(double t) const {
  const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  return static_cast<std::size_t>(next - times_.begin()) - 1;
}

double Drive::distance(double t) const {
  if (t <= 0.0) return 0.0;
  if (t >= duration()) return length();
  const auto i = segment(t);
  const double elapsed = t - times_[i];
  const double acceleration = (speeds_[i + 1] - speeds_[i]) / (times_[i + 1] - times_[i]);
  return distances_[i] + elapsed * (speeds_[i] + 0.5 * acceleration * elapsed);
}

double Drive::speed(double t) const {
  if (t <= 0.0 || t >= duration()) return 0.0;
  const auto i = segment(t);
  const double share = (t - times_[i]) / (times_[i + 1] - times_[i]);
  return speeds_[i] + share * (speeds_[i + 1] - speeds_[i]);
}

Pose2 Drive::pose(double t) const { return poseAt(distance(t)); }

Pose2 Drive::poseAt(double s) const {
  const auto point = curve_.point(s);
  return Pose2(point.x(), point.y(),
               wrapAngle(curve_.heading(s) + sway_ * std::sin(sway_frequency_ * s)));
}

void requireClearance(const Drive& drive, const FloorPlan& plan, double radius) {
  for (double t = 0.0; t < drive.duration(); t += kCheckStep) {
    double distance = 0.0;
    const auto* face = plan.nearest(drive.pose(t).position(), 0.0, &distance);
    if (face == nullptr || distance > radius) continue;
    std::ostringstream text;
    text << "the path leads past " << face->name << " at " << distance << " m near "
         << pointText(drive.pose(t).position()) << ", the robot's radius is " << radius << " m";
    throw ConfigError(text.str());
  }
}

}  // namespace slam::sim
