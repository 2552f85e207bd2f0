// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "corridor_world.hpp"
#include "slam_core/point_map/point_map.hpp"

// Time of one scan of 682 beams into a point map, against the number of its points.

namespace {

constexpr int kBeams = 682;
constexpr double kBuild = 0.8, kStep = 0.1;  // of the drive [m]

/// A point map, and a filter that knows where the robot is.
class MappedCorridor {
 public:
  MappedCorridor(const std::string& fusion, std::size_t points) {
    slam::Settings settings({}, {}, {"point_map.fusion=" + fusion});
    map_.configure(settings);
    take(drive_.step(0.0));
    while (map_.points().size() < points) take(drive_.step(kBuild));
    length_ = way_;
  }

  /// A step through what is mapped already.
  slam::eval::CorridorDrive::Step next() {
    if (way_ >= length_) {
      way_ = 0.0;
      drive_.jumpTo(way_);
    }
    return drive_.step(kStep);
  }

  void take(const slam::eval::CorridorDrive::Step& step) {
    way_ = step.truth.x();
    map_.set(step.motion);
    map_.set(slam::FilterPose::of(step.scan.stamp, step.truth));
    map_.set(step.scan);
    do benchmark::DoNotOptimize(map_.execute());
    while (map_.isBusy());
  }

  std::size_t points() const { return map_.points().size(); }

 private:
  slam::eval::CorridorDrive drive_{kBeams};
  slam::point_map::PointMap map_;
  double way_ = 0.0, length_ = 0.0;
};

void scanOfPointMap(benchmark::State& state, const std::string& fusion) {
  MappedCorridor corridor(fusion, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    const auto step = corridor.next();
    state.ResumeTiming();
    corridor.take(step);
  }
  state.counters["points"] = static_cast<double>(corridor.points());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1000)->Arg(10000)->Arg(100000)->Arg(300000)->ArgName("points");
  benchmark->Unit(benchmark::kMillisecond)->Iterations(300);
}

BENCHMARK_CAPTURE(scanOfPointMap, euclidean, "euclidean")->Apply(sizes);
BENCHMARK_CAPTURE(scanOfPointMap, aligned, "aligned")->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
