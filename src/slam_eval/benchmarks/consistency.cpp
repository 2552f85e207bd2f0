// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cpu_time.hpp"
#include "loop_world.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/command_line.hpp"

// Runs a back-end over the consistency case for many seeds and prints, as JSON, the NEES of every
// step averaged over the seeds, the NIS per degree of freedom, and the CPU time of a step with the
// reported pose. slam_bench makes the table.

namespace slam::eval {
namespace {

struct Sums {
  std::vector<double> nees;  ///< by step, over the seeds
  double nis = 0.0;
  double nis_dof = 0.0;
  double squared_error = 0.0;
  double cpu_ms = 0.0;
};

double nees(const slam::PoseEstimate& estimate, const slam::Pose2& truth) {
  Eigen::Vector3d error = estimate.pose.vector() - truth.vector();
  error.z() = slam::wrapAngle(error.z());
  return error.dot(estimate.covariance.inverse() * error);
}

/// @throw std::runtime_error where the back-end has no such input
template <class T>
const slam::InputPort& inputOf(const slam::Ports& ports) {
  for (const auto& input : ports.inputs())
    if (input.kind == slam::kindOf<T>()) return input;
  throw std::runtime_error("the back-end does not take " + slam::nameOf(slam::kindOf<T>()));
}

void runSeed(slam::Backend& backend, const LoopWorldConfig& world, std::uint64_t seed, Sums& sums) {
  const auto steps = simulateLoop(world, seed);
  sums.nees.resize(steps.size());
  backend.reset();
  const auto ports = slam::portsOf(backend);
  const auto* mapper = slam::capabilitiesOf(backend).find<slam::LandmarkMapper>();
  if (mapper == nullptr) throw std::runtime_error("the back-end maps no landmarks");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    inputOf<slam::Motion>(ports).set(&steps[i].motion);
    inputOf<slam::LandmarkObservationArray>(ports).set(&steps[i].observations);
    const double start = cpuMilliseconds();
    const auto status = backend.execute();
    const auto estimate = backend.pose();
    sums.cpu_ms += cpuMilliseconds() - start;
    if (status.level == slam::Status::Level::kError) throw std::runtime_error(status.message);
    sums.nees[i] += nees(estimate, steps[i].truth);
    sums.squared_error += (estimate.pose.position() - steps[i].truth.position()).squaredNorm();
    const auto statistics = mapper->statistics();
    sums.nis += statistics.nis;
    sums.nis_dof += statistics.nis_dof;
  }
}

void run(const std::string& name, const std::vector<std::string>& overrides,
         const LoopWorldConfig& world, int first, int seeds) {
  slam::loadLibraries({});
  slam::Settings settings({}, {}, overrides);
  auto backend = slam::Registry<slam::Backend>::instance().create(name);
  backend->configure(settings);
  Sums sums;
  slam::Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  progress.begin("consistency of " + name, static_cast<std::size_t>(seeds));
  for (int i = 0; i < seeds; ++i) {
    runSeed(*backend, world, static_cast<std::uint64_t>(first + i), sums);
    progress.update(static_cast<std::size_t>(i + 1));
  }
  progress.end();
  for (auto& value : sums.nees) value /= seeds;
  const double count = static_cast<double>(sums.nees.size()) * seeds;
  const nlohmann::json result = {{"seeds", seeds},
                                 {"average_nees", sums.nees},
                                 {"nis_mean", sums.nis / sums.nis_dof},
                                 {"position_rmse_m", std::sqrt(sums.squared_error / count)},
                                 {"step_ms", sums.cpu_ms / count}};
  std::puts(result.dump().c_str());
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_consistency",
      "NEES and NIS of a back-end over a simulated loop, averaged over seeds");
  std::string backend = "ekf";
  std::vector<std::string> overrides;
  slam::eval::LoopWorldConfig world;
  int first = 1, seeds = 50;
  double noise = 1.0;
  line.add("--backend", backend, "name of the back-end").withDefault();
  line.add("--set", overrides, "section.key=value of the back-end");
  line.add("--loop", world.loop_length, "length of the loop [m]").withDefault();
  line.add("--noise", noise, "factor on every sigma of motion and sensor").positive().withDefault();
  line.add("--first", first, "seed of the first run").nonNegative().withDefault();
  line.add("--seeds", seeds, "number of runs").positive().withDefault();
  return line.run(argc, argv, [&] {
    for (auto* sigma :
         {&world.sigma_range, &world.sigma_bearing, &world.sigma_position, &world.sigma_heading})
      *sigma *= noise;
    slam::eval::run(backend, overrides, world, first, seeds);
  });
}
