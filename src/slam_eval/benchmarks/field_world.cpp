// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "field_world.hpp"

#include <algorithm>
#include <cmath>

namespace slam::eval {

FieldWorld::FieldWorld(const FieldWorldConfig& config, std::uint64_t seed)
    : config_(config), random_(seed, 0) {
  const double square = std::sqrt(static_cast<double>(config_.landmarks)) * config_.spacing;
  if (config_.lane <= 0.0) config_.lane = square;
  columns_ = std::max(1, static_cast<int>(std::lround(config_.lane / config_.spacing)));
  for (int i = 0; i < config_.landmarks; ++i) {
    const double dx = random_.uniform(), dy = random_.uniform();
    places_.emplace_back(config_.spacing * (i % columns_ + dx),
                         config_.spacing * (i / columns_ + dy));
  }
  start_ = at_ = Pose2(0.0, 0.5 * config_.between, 0.0);
}

double FieldWorld::height() const {
  return config_.spacing * (static_cast<double>(config_.landmarks) / columns_);
}

/// At the end of a lane the robot turns half round on an arc to the next one.
Pose2 FieldWorld::trueStep() {
  const double radius = 0.5 * config_.between;
  if (way_ >= (is_in_lane_ ? config_.lane : M_PI * radius)) {
    if (!is_in_lane_) turns_left_ = !turns_left_;
    is_in_lane_ = !is_in_lane_;
    way_ = 0.0;
  }
  const double length =
      std::min(config_.step_length, (is_in_lane_ ? config_.lane : M_PI * radius) - way_);
  way_ += length;
  const double turn = is_in_lane_ ? 0.0 : (turns_left_ ? 1.0 : -1.0) * length / radius;
  return Pose2::exp({length, 0.0, turn});
}

Motion FieldWorld::measured(const Pose2& true_step) {
  const Eigen::Vector3d sigma(config_.sigma_position, config_.sigma_position,
                              config_.sigma_heading);
  const double x = random_.gaussian(), y = random_.gaussian(), theta = random_.gaussian();
  Motion motion;
  motion.sequence = static_cast<std::uint64_t>(count_);
  motion.start = stampFromNanoseconds(count_ * std::int64_t{1000000000});
  motion.end = motion.start + std::chrono::seconds(1);
  motion.increment =
      Pose2::fromVector(true_step.vector() + sigma.cwiseProduct(Eigen::Vector3d(x, y, theta)));
  motion.covariance = sigma.cwiseAbs2().asDiagonal();
  return motion;
}

LandmarkObservationArray FieldWorld::observed() {
  LandmarkObservationArray array;
  const Pose2 field_in_robot = at_.inverse();
  const auto cell = [&](double x) { return static_cast<int>(std::floor(x / config_.spacing)); };
  for (int row = std::max(0, cell(at_.y() - config_.view_range));
       row <= cell(at_.y() + config_.view_range); ++row)
    for (int column = std::max(0, cell(at_.x() - config_.view_range));
         column <= std::min(columns_ - 1, cell(at_.x() + config_.view_range)); ++column) {
      const auto id = row * columns_ + column;
      if (id >= config_.landmarks) continue;
      const auto seen = field_in_robot.transform(places_[static_cast<std::size_t>(id)]);
      if (seen.norm() > config_.view_range) continue;
      LandmarkObservation z;
      z.id = id;
      z.range = seen.norm() + config_.sigma_range * random_.gaussian();
      z.bearing = std::atan2(seen.y(), seen.x()) + config_.sigma_bearing * random_.gaussian();
      z.covariance =
          Eigen::Vector2d(config_.sigma_range, config_.sigma_bearing).cwiseAbs2().asDiagonal();
      if (z.range > 0.0) array.observations.push_back(z);
    }
  return array;
}

std::optional<LoopStep> FieldWorld::next() {
  if (at_.y() > height()) return std::nullopt;
  LoopStep step;
  const Pose2 true_step = trueStep();
  step.motion = measured(true_step);
  at_ = at_ * true_step;
  step.truth = start_.between(at_);
  step.observations = observed();
  step.observations.stamp = step.motion.end;
  step.observations.sequence = step.motion.sequence;
  ++count_;
  return step;
}

}  // namespace slam::eval
