// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "slam_core/common/random.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

// Time of one update of the particle filter against the number of particles and the size of the
// map.

namespace {

constexpr std::int64_t kObservations = 50;
constexpr double kSigmaRange = 0.1, kSigmaBearing = 0.03;       // [m], [rad]
constexpr double kSigmaPosition = 0.01, kSigmaHeading = 0.005;  // of a step [m], [rad]

/// A robot that stands among `landmarks` landmarks on a square grid, 1 m apart, and sees them with
/// noise. Those of one step lie far from one another in the map, which is the hard case for maps
/// that share what lies together.
class GridWorld {
 public:
  explicit GridWorld(std::int64_t landmarks)
      : landmarks_(landmarks),
        side_(static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(landmarks))))) {}

  slam::LandmarkObservationArray all() {
    slam::LandmarkObservationArray array;
    for (std::int64_t id = 0; id < landmarks_; ++id) array.observations.push_back(observe(id));
    return array;
  }
  slam::LandmarkObservationArray some() {
    slam::LandmarkObservationArray array;
    const auto count = std::min(kObservations, landmarks_), stride = landmarks_ / count;
    const auto first = static_cast<std::int64_t>(random_.uniform() * static_cast<double>(stride));
    for (std::int64_t i = 0; i < count; ++i)
      array.observations.push_back(observe(first + i * stride));
    return array;
  }

 private:
  slam::LandmarkObservation observe(std::int64_t id) {
    const double x = 0.5 + static_cast<double>(id % side_ - side_ / 2);
    const double y = 0.5 + static_cast<double>(id / side_ - side_ / 2);
    slam::LandmarkObservation z;
    z.id = id;
    z.range = std::max(0.1, std::hypot(x, y) + kSigmaRange * random_.gaussian());
    z.bearing = std::atan2(y, x) + kSigmaBearing * random_.gaussian();
    z.covariance =
        Eigen::Vector2d(kSigmaRange * kSigmaRange, kSigmaBearing * kSigmaBearing).asDiagonal();
    return z;
  }

  std::int64_t landmarks_, side_;
  slam::RandomStream random_{1, 0};
};

void updateOfPf(benchmark::State& state) {
  slam::Settings settings({}, {}, {"pf.particles=" + std::to_string(state.range(0))});
  slam::particle_filter::FastSlam filter;
  filter.configure(settings);
  GridWorld world(state.range(1));
  slam::Motion motion;
  motion.covariance =
      Eigen::Vector3d(kSigmaPosition * kSigmaPosition, kSigmaPosition * kSigmaPosition,
                      kSigmaHeading * kSigmaHeading)
          .asDiagonal();
  const auto step = [&](const slam::LandmarkObservationArray& observations) {
    slam::give(motion, filter);
    slam::give(observations, filter);
    benchmark::DoNotOptimize(filter.execute());
  };
  step(world.all());  // every particle builds a map of its own: nothing is shared
  for (int i = 0; i < 20; ++i) step(world.some());
  for (auto _ : state) step(world.some());
  const double resampled = static_cast<double>(filter.counters()["resampled"]);
  state.counters["resampled"] = resampled / static_cast<double>(state.iterations() + 20);
}

BENCHMARK(updateOfPf)
    ->ArgsProduct({{10, 100, 1000}, {100, 1000, 10000}})
    ->ArgNames({"particles", "landmarks"})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
