// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "loop_world.hpp"

#include <cmath>

namespace slam::eval {
namespace {

using slam::Pose2;
using slam::RandomStream;

std::vector<Eigen::Vector2d> placeLandmarks(const LoopWorldConfig& config, RandomStream& random) {
  const double radius = config.loop_length / (2.0 * M_PI);
  std::vector<Eigen::Vector2d> landmarks;
  for (int i = 0; i < config.landmarks; ++i) {
    const double angle = 2.0 * M_PI * random.uniform();
    const double r = radius + config.landmark_band * (2.0 * random.uniform() - 1.0);
    landmarks.emplace_back(r * std::sin(angle), radius - r * std::cos(angle));
  }
  return landmarks;
}

slam::Motion measureMotion(const LoopWorldConfig& config, const Pose2& true_step, int step,
                           RandomStream& random) {
  const Eigen::Vector3d sigma(config.sigma_position, config.sigma_position, config.sigma_heading);
  const Eigen::Vector3d noise(random.gaussian(), random.gaussian(), random.gaussian());
  slam::Motion motion;
  motion.sequence = static_cast<std::uint64_t>(step);
  motion.start = slam::stampFromNanoseconds(step * std::int64_t{1000000000});
  motion.end = motion.start + std::chrono::seconds(1);
  motion.increment = Pose2::fromVector(true_step.vector() + sigma.cwiseProduct(noise));
  motion.covariance = sigma.cwiseAbs2().asDiagonal();
  return motion;
}

slam::LandmarkObservationArray observe(const LoopWorldConfig& config, const Pose2& truth,
                                       const std::vector<Eigen::Vector2d>& landmarks,
                                       RandomStream& random) {
  slam::LandmarkObservationArray array;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Eigen::Vector2d seen = truth.inverse().transform(landmarks[i]);
    if (seen.norm() > config.view_range) continue;
    slam::LandmarkObservation z;
    z.id = static_cast<slam::LandmarkId>(i);
    z.range = seen.norm() + config.sigma_range * random.gaussian();
    z.bearing = std::atan2(seen.y(), seen.x()) + config.sigma_bearing * random.gaussian();
    z.covariance =
        Eigen::Vector2d(config.sigma_range, config.sigma_bearing).cwiseAbs2().asDiagonal();
    if (z.range > 0.0) array.observations.push_back(z);
  }
  return array;
}

}  // namespace

std::vector<LoopStep> simulateLoop(const LoopWorldConfig& config, std::uint64_t seed) {
  RandomStream random(seed, 0);
  const auto landmarks = placeLandmarks(config, random);
  const double turn = 2.0 * M_PI * config.step_length / config.loop_length;
  const Pose2 true_step = Pose2::exp({config.step_length, 0.0, turn});
  const int count = static_cast<int>(config.laps * config.loop_length / config.step_length);

  std::vector<LoopStep> steps;
  Pose2 truth;
  for (int i = 0; i < count; ++i) {
    LoopStep step;
    step.motion = measureMotion(config, true_step, i, random);
    truth = truth * true_step;
    step.truth = truth;
    step.observations = observe(config, truth, landmarks, random);
    step.observations.stamp = step.motion.end;
    step.observations.sequence = step.motion.sequence;
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace slam::eval
