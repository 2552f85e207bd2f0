// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <string>

#include "corridor_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

// Time of one scan of the particle filter with grid maps, and memory, against particles, threads,
// beams and the length of the corridor that has been mapped before. Each scan is used.

namespace {

constexpr double kStep = 0.1;   // of the drive that is measured [m]
constexpr double kBuild = 0.4;  // of the drive that makes the map [m]

slam::Settings settingsFor(const benchmark::State& state) {
  return {{},
          {},
          {"pf.particles=" + std::to_string(state.range(0)),
           "pf.threads=" + std::to_string(state.range(1)), "scan_matching.update_distance=0"}};
}

/// A filter and the robot that it is told of.
class MappedCorridor {
 public:
  explicit MappedCorridor(const benchmark::State& state)
      : drive_(static_cast<int>(state.range(2))) {
    auto settings = settingsFor(state);
    slam::as<slam::MapChooser>(filter_).useMap(slam::MapKind::kGrid);
    filter_.configure(settings);
    const auto length = static_cast<double>(state.range(3));
    for (double way = 0.0; way < length; way += kBuild) take(drive_.step(kBuild));
  }

  slam::eval::CorridorDrive::Step next() { return drive_.step(kStep); }

  void take(const slam::eval::CorridorDrive::Step& step) {
    slam::give(step.motion, filter_);
    benchmark::DoNotOptimize(filter_.execute());
    slam::give(step.scan, filter_);
    benchmark::DoNotOptimize(filter_.execute());
  }

 private:
  slam::eval::CorridorDrive drive_;
  slam::particle_filter::FastSlam filter_;
};

void scanOfGrid(benchmark::State& state) {
  MappedCorridor corridor(state);
  for (auto _ : state) {
    state.PauseTiming();
    const auto step = corridor.next();
    state.ResumeTiming();
    corridor.take(step);
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int particles : {10, 30, 100}) benchmark->Args({particles, 1, 180, 50});
  for (const int threads : {2, 4}) benchmark->Args({30, threads, 180, 50});
  for (const int beams : {90, 360, 682}) benchmark->Args({30, 1, beams, 50});
  for (const int length : {25, 100, 400}) benchmark->Args({30, 1, 180, length});
}

BENCHMARK(scanOfGrid)
    ->Apply(sizes)
    ->ArgNames({"particles", "threads", "beams", "metres"})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
