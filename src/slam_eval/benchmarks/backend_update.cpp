// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <cmath>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/product_config.hpp"

// Time of one update against the size of the map and the number of observations.

namespace {

/// A robot in the middle of `landmarks` landmarks on a square grid, 1 m apart.
class GridWorld {
 public:
  explicit GridWorld(std::int64_t landmarks)
      : landmarks_(landmarks), side_(static_cast<std::int64_t>(std::ceil(std::sqrt(landmarks)))) {}

  slam::LandmarkObservationArray observe(std::int64_t first, std::int64_t count) const {
    slam::LandmarkObservationArray array;
    for (std::int64_t i = first; i < first + count; ++i) {
      const auto id = i % landmarks_;
      const double x = 0.5 + static_cast<double>(id % side_ - side_ / 2);
      const double y = 0.5 + static_cast<double>(id / side_ - side_ / 2);
      slam::LandmarkObservation z;
      z.id = id;
      z.range = std::hypot(x, y);
      z.bearing = std::atan2(y, x);
      z.covariance = Eigen::Vector2d(1e-2, 1e-3).asDiagonal();
      array.observations.push_back(z);
    }
    return array;
  }

 private:
  std::int64_t landmarks_, side_;
};

void updateOfEkf(benchmark::State& state) {
  slam::loadLibraries({});
  slam::Settings settings;
  auto backend = slam::Registry<slam::Backend>::instance().create("ekf");
  backend->configure(settings);
  const GridWorld world(state.range(0));
  const auto step = [&](std::int64_t first, std::int64_t count) {
    slam::Motion motion;
    motion.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal();
    backend->set(motion);
    backend->set(world.observe(first, count));
    benchmark::DoNotOptimize(backend->execute());
  };
  step(0, state.range(0));
  std::int64_t first = 0;
  for (auto _ : state) step(first += state.range(1), state.range(1));
}

BENCHMARK(updateOfEkf)
    ->ArgsProduct({{100, 300, 1000, 3000}, {1, 10, 50}})
    ->ArgNames({"landmarks", "observations"})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
