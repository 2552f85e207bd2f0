// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpu_time.hpp"
#include "loop_world.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_ros/command_line.hpp"

// Drives the graph back-end round the same loop for many kilometres and prints, for each part of
// the way, how large the graph is, how long a step takes and how well the robot knows where it is.

namespace slam::eval {
namespace {

double nees(const PoseEstimate& estimate, const Pose2& truth) {
  Eigen::Vector3d error = estimate.pose.vector() - truth.vector();
  error.z() = wrapAngle(error.z());
  return error.dot(estimate.covariance.inverse() * error);
}

double figure(const graph_slam::GraphSlam& backend, const std::string& name) {
  for (const auto& [each, value] : backend.figures())
    if (each == name) return value;
  throw std::runtime_error("the back-end has no figure " + name);
}

/// The cost and the error of a part of the way.
struct Part {
  double ms = 0.0, worst_ms = 0.0, squared_error = 0.0, nees = 0.0;
  int steps = 0;
};

void take(graph_slam::GraphSlam& backend, const LoopStep& step, Part& part) {
  backend.set(step.motion);
  backend.set(step.observations);
  const double begin = cpuMilliseconds();
  const auto status = backend.execute();
  const double ms = cpuMilliseconds() - begin;
  if (status.level == Status::Level::kError) throw std::runtime_error(status.message);
  const auto estimate = backend.pose();
  part.ms += ms;
  part.worst_ms = std::max(part.worst_ms, ms);
  part.squared_error += (estimate.pose.position() - step.truth.position()).squaredNorm();
  part.nees += nees(estimate, step.truth);
  ++part.steps;
}

void print(double metres, const graph_slam::GraphSlam& backend, const Part& part) {
  std::printf("| %.0f | %.0f | %.1f | %.3f | %.2f | %.3f | %.2f |\n", metres,
              figure(backend, "nodes"), figure(backend, "factor_megabytes"), part.ms / part.steps,
              part.worst_ms, std::sqrt(part.squared_error / part.steps), part.nees / part.steps);
  std::fflush(stdout);
}

void run(const std::vector<std::string>& overrides, const LoopWorldConfig& world, int seed,
         int rows) {
  Settings settings({}, {}, overrides);
  graph_slam::GraphSlam backend;
  backend.configure(settings);
  const auto steps = simulateLoop(world, static_cast<std::uint64_t>(seed));
  std::puts("| way [m] | nodes | factors [MB] | step, mean [ms] | worst [ms] | error [m] | NEES |");
  std::puts("|---|---|---|---|---|---|---|");
  const auto rows_at = std::max<std::size_t>(1, steps.size() / static_cast<std::size_t>(rows));
  Part part;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    take(backend, steps[i], part);
    if ((i + 1) % rows_at != 0) continue;
    print(static_cast<double>(i + 1) * world.step_length, backend, part);
    part = {};
  }
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_long_drive",
      "size and step time of the graph back-end on a long way round the same loop");
  slam::eval::LoopWorldConfig world;
  std::vector<std::string> overrides;
  double metres = 10000.0;
  int seed = 1, rows = 10;
  line.add("--set", overrides, "section.key=value of the back-end");
  line.add("--loop", world.loop_length, "length of the loop [m]").between(1.0, 1e4).withDefault();
  line.add("--metres", metres, "length of the way [m]").between(1.0, 1e6).withDefault();
  line.add("--rows", rows, "parts of the way, of which each one is a row of the table")
      .between(1, 1000)
      .withDefault();
  line.add("--seed", seed, "seed of the world").nonNegative().withDefault();
  return line.run(argc, argv, [&] {
    world.laps = std::max(1, static_cast<int>(std::lround(metres / world.loop_length)));
    slam::eval::run(overrides, world, seed, rows);
  });
}
