// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/base_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::sim {
namespace {

CommandModel model() {
  CommandModel model;
  model.pace.rate = 20.0;
  return model;
}

TEST(BaseController, TellsTheTwistOfAnArc) {
  const auto path = [](double t) { return Pose2(1, 2, 3) * Pose2::exp({0.5 * t, 0.0, 0.2 * t}); };
  RandomStream random(1, 1);
  EXPECT_LT((commandFor(path, model(), random) - Eigen::Vector3d(0.5, 0, 0.2)).norm(), 1e-9);
}

TEST(BaseController, TellsMoreThanTheBaseDoesWhereItSpeedsUp) {
  auto lagging = model();
  lagging.time_constant = 0.2;
  // v = t + 0.4: the base is 0.2 s behind a command that grows by 1 m/s^2
  const auto path = [](double t) { return Pose2(0.5 * t * t + 0.4 * t, 0.0, 0.0); };
  RandomStream random(1, 1);
  EXPECT_NEAR(commandFor(path, lagging, random).x(), 0.4 + 0.025 + 0.2, 1e-9);
}

TEST(BaseController, ErrsAsItsModelSays) {
  auto erring = model();
  erring.speed_scale = 0.9;
  erring.turn_scale = 1.1;
  erring.relative_noise = 0.1;
  const auto path = [](double t) { return Pose2::exp({0.5 * t, 0.0, 0.2 * t}); };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
  constexpr int kRuns = 5000;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    RandomStream random(3, run);
    const auto command = commandFor(path, erring, random);
    mean += command / kRuns;
    squares += command.cwiseAbs2() / kRuns;
  }
  EXPECT_NEAR(mean.x(), 0.5 / 0.9, 0.005);
  EXPECT_NEAR(mean.z(), 0.2 / 1.1, 0.002);
  EXPECT_NEAR(std::sqrt(squares.x() - mean.x() * mean.x()), 0.1 * 0.5 / 0.9, 0.003);
}

}  // namespace
}  // namespace slam::sim
