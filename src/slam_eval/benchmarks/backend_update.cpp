// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <cmath>

#include "slam_core/ekf/ekf_slam.hpp"

// Time of one update against the size of the map and the number of observations, while the robot
// stays in one neighbourhood, of the extended and the unscented filter; of the global update that
// leaving it costs; and of a look at the marginals of the whole map in between.

namespace {

/// A robot in the middle of `landmarks` landmarks on a square grid, 1 m apart.
class GridWorld {
 public:
  explicit GridWorld(std::int64_t landmarks)
      : landmarks_(landmarks), side_(static_cast<std::int64_t>(std::ceil(std::sqrt(landmarks)))) {}

  slam::MapState map() const {
    slam::MapState map;
    map.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    for (std::int64_t id = 0; id < landmarks_; ++id)
      map.landmarks.push_back({id, position(id), 1e-2 * Eigen::Matrix2d::Identity()});
    return map;
  }
  slam::LandmarkObservationArray observe(std::int64_t first, std::int64_t count) const {
    slam::LandmarkObservationArray array;
    for (std::int64_t i = first; i < first + count; ++i) {
      slam::LandmarkObservation z;
      z.id = i % landmarks_;
      const auto m = position(z.id);
      z.range = m.norm();
      z.bearing = std::atan2(m.y(), m.x());
      z.covariance = Eigen::Vector2d(1e-2, 1e-3).asDiagonal();
      array.observations.push_back(z);
    }
    return array;
  }

 private:
  Eigen::Vector2d position(std::int64_t id) const {
    return {0.5 + static_cast<double>(id % side_ - side_ / 2),
            0.5 + static_cast<double>(id / side_ - side_ / 2)};
  }

  std::int64_t landmarks_, side_;
};

/// An EKF in the middle of a map.
class Filter {
 public:
  explicit Filter(std::int64_t landmarks, const slam::ekf::EkfConfig& config = {})
      : world_(landmarks) {
    ekf_.configure(config);
    slam::as<slam::MapKeeper>(ekf_).set(world_.map());
    ekf_.execute();
  }
  void step(std::int64_t first, std::int64_t count) {
    slam::Motion motion;
    motion.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal();
    ekf_.set(motion);
    ekf_.set(world_.observe(first, count));
    benchmark::DoNotOptimize(ekf_.execute());
  }
  /// A new pose for the robot goes with a global update.
  void leave() {
    ekf_.set(ekf_.pose());
    benchmark::DoNotOptimize(ekf_.execute());
  }
  slam::LandmarkMapper& map() { return slam::as<slam::LandmarkMapper>(ekf_); }

 private:
  GridWorld world_;
  slam::ekf::EkfSlam ekf_;
};

constexpr std::int64_t kNeighbourhood = 60;

void update(benchmark::State& state, const slam::ekf::EkfConfig& config) {
  Filter filter(state.range(0), config);
  const auto count = state.range(1);
  for (std::int64_t first = 0; first < kNeighbourhood; first += count) filter.step(first, count);
  std::int64_t first = 0;
  for (auto _ : state) {
    filter.step(first, count);
    first = (first + count) % kNeighbourhood;
  }
}

void updateOfEkf(benchmark::State& state) { update(state, {}); }

void updateOfUnscentedFilter(benchmark::State& state) {
  slam::ekf::EkfConfig config;
  config.filter = "unscented";
  update(state, config);
}

void globalUpdateOfEkf(benchmark::State& state) {
  Filter filter(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    filter.step(0, kNeighbourhood);
    state.ResumeTiming();
    filter.leave();
  }
}

void marginalsOfEkf(benchmark::State& state) {
  Filter filter(state.range(0));
  filter.step(0, kNeighbourhood);
  filter.step(0, kNeighbourhood);
  for (auto _ : state) benchmark::DoNotOptimize(filter.map().landmarks());
}

const std::vector<std::int64_t> kSizes = {100, 300, 1000, 3000, 10000};

BENCHMARK(updateOfEkf)
    ->ArgsProduct({kSizes, {1, 10, 30}})
    ->ArgNames({"landmarks", "observations"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(updateOfUnscentedFilter)
    ->ArgsProduct({kSizes, {1, 10, 30}})
    ->ArgNames({"landmarks", "observations"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(globalUpdateOfEkf)
    ->ArgsProduct({kSizes})
    ->ArgNames({"landmarks"})
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(marginalsOfEkf)
    ->ArgsProduct({kSizes})
    ->ArgNames({"landmarks"})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
