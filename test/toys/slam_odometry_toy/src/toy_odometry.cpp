// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "toy_odometry.hpp"

#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam_toy {
namespace {

const slam::Registrar<slam::OdometrySource, ToyOdometry> kRegistrar("toy");
const slam::SectionRegistrar<ToyOdometryConfig> kSectionRegistrar;

}  // namespace

void ToyOdometryConfig::describe(slam::Fields& fields) {
  fields.add("relative_sigma", &relative_sigma, "standard deviation as a part of the motion")
      .unit("1")
      .in(slam::Range::above(0));
  fields.add("floor", &floor, "standard deviation of a motion of nothing")
      .unit("m, rad")
      .in(slam::Range::above(0));
}

void ToyOdometry::configure(slam::Settings& settings) {
  config_ = settings.read<ToyOdometryConfig>();
  reset();
}

void ToyOdometry::describe(slam::Ports& ports) {
  ports.takes<slam::OdometrySample>("odom", "odometry", this);
  ports.makes<slam::Motion>("motion", motion_);
}

void ToyOdometry::reset() {
  last_.reset();
  sample_.reset();
  motion_.reset();
  sequence_ = 0;
  counters_.clear();
}

slam::Status ToyOdometry::execute() {
  motion_.reset();
  if (!sample_) return slam::Status::ok();
  const auto sample = *std::exchange(sample_, std::nullopt);
  if (!sample.pose || !sample.pose->isFinite()) {
    counters_.add("invalid");
    return slam::Status::warning("odometry without a pose is left out");
  }
  if (last_ && sample.stamp <= last_->stamp) {
    counters_.add("late");
    return slam::Status::warning("odometry that is not newer than the last is left out");
  }
  if (last_) motion_ = between(*last_, sample);
  last_ = sample;
  return slam::Status::ok();
}

slam::Motion ToyOdometry::between(const slam::OdometrySample& first,
                                  const slam::OdometrySample& second) {
  slam::Motion motion;
  motion.sequence = sequence_++;
  motion.start = first.stamp;
  motion.end = second.stamp;
  motion.odometry_start = *first.pose;
  motion.odometry_end = *second.pose;
  motion.increment = first.pose->between(*second.pose);
  motion.odometry_frame = second.odometry_frame;
  motion.base_frame = second.base_frame;
  const double driven = config_.relative_sigma * motion.increment.position().norm() + config_.floor;
  const double turned = config_.relative_sigma * std::abs(motion.increment.theta()) + config_.floor;
  motion.covariance.diagonal() << driven * driven, driven * driven, turned * turned;
  return motion;
}

}  // namespace slam_toy
