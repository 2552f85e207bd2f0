// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_world.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "slam_core/common/random.hpp"

namespace slam::eval {
namespace {

enum Purpose : std::uint32_t { kWay, kNoise, kLoops };  // of a stream of random numbers

using Place = std::pair<int, int>;  // whole metres

constexpr Place kAhead[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

/// A robot on the streets of a city that is a square.
class StreetWalk {
 public:
  StreetWalk(const GraphWorldConfig& config, std::uint64_t seed)
      : seed_(seed), block_(config.block) {
    // so many metres of street as there are places to visit
    const double streets = static_cast<double>(config.poses) / config.visits;
    blocks_ = std::max(1, static_cast<int>(std::sqrt(streets / (2.0 * config.block))));
  }

  Place place() const { return place_; }
  Pose2 pose() const {
    return {static_cast<double>(place_.first), static_cast<double>(place_.second),
            heading_ * M_PI / 2};
  }

  void step() {
    place_ = placeAhead(heading_);
    ++steps_;
    if (isCrossing()) turn();
  }

 private:
  Place placeAhead(int heading) const {
    return {place_.first + kAhead[heading].first, place_.second + kAhead[heading].second};
  }
  bool isCrossing() const { return place_.first % block_ == 0 && place_.second % block_ == 0; }
  bool isInCity(Place place) const {
    const int side = blocks_ * block_;
    return std::min(place.first, place.second) >= 0 && std::max(place.first, place.second) <= side;
  }

  /// The robot goes straight on half of the time, where it can.
  void turn() {
    std::vector<int> ways;
    for (const int left : {0, 0, 1, 3})
      if (isInCity(placeAhead((heading_ + left) % 4))) ways.push_back((heading_ + left) % 4);
    RandomStream random(seed_, steps_, kWay);
    heading_ = ways[static_cast<std::size_t>(random.uniform() * static_cast<double>(ways.size()))];
  }

  std::uint64_t seed_, steps_ = 0;
  int block_, blocks_, heading_ = 0;
  Place place_{0, 0};
};

/// Where the robot was, by place.
class Visits {
 public:
  explicit Visits(const GraphWorldConfig& config) : config_(config) {}

  void add(Place place, int pose) { poses_[place].push_back(pose); }

  /// Earlier poses that are recognised from a place, the latest ones first.
  std::vector<int> recognised(Place place, int pose, RandomStream random) const {
    std::vector<int> loops;
    for (const int other : nearby(place, pose - config_.loop_gap)) {
      if (static_cast<int>(loops.size()) == config_.most_loops) break;
      if (random.uniform() < config_.loop_chance) loops.push_back(other);
    }
    return loops;
  }

 private:
  std::vector<int> nearby(Place place, int latest) const {
    const int reach = static_cast<int>(config_.loop_radius);
    std::vector<int> found;
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y) {
        const auto poses = poses_.find({place.first + x, place.second + y});
        if (poses == poses_.end() || std::hypot(x, y) > config_.loop_radius) continue;
        for (const int pose : poses->second)
          if (pose <= latest) found.push_back(pose);
      }
    std::sort(found.rbegin(), found.rend());
    return found;
  }

  const GraphWorldConfig& config_;
  std::map<Place, std::vector<int>> poses_;
};

/// Measures poses with the noise of the city.
class PoseMeter {
 public:
  PoseMeter(const GraphWorldConfig& config, const std::vector<Pose2>& truth)
      : sigma_(config.sigma_position, config.sigma_position, config.sigma_heading), truth_(truth) {}

  /// The error z^-1 a^-1 b is drawn, and z is what has it.
  PoseEdge measure(int a, int b, RandomStream& random) const {
    const Eigen::Vector3d white(random.gaussian(), random.gaussian(), random.gaussian());
    const Pose2 e = Pose2::fromVector(sigma_.cwiseProduct(white));
    const Pose2 exact =
        truth_[static_cast<std::size_t>(a)].between(truth_[static_cast<std::size_t>(b)]);
    return {a, b, exact * e.inverse(), sigma_.cwiseAbs2().cwiseInverse().asDiagonal()};
  }

 private:
  Eigen::Vector3d sigma_;
  const std::vector<Pose2>& truth_;
};

}  // namespace

PoseGraph makeGraphWorld(const GraphWorldConfig& config, std::uint64_t seed) {
  PoseGraph graph;
  graph.name = "world_" + std::to_string(seed) + "_" + std::to_string(config.poses);
  StreetWalk walk(config, seed);
  Visits visits(config);
  const PoseMeter meter(config, graph.truth);
  for (int i = 0; i < config.poses; ++i) {
    if (i > 0) walk.step();
    graph.ids.push_back(i);
    graph.truth.push_back(walk.pose());
    const auto step = static_cast<std::uint64_t>(i);
    RandomStream noise(seed, step, kNoise);
    if (i > 0) graph.edges.push_back(meter.measure(i - 1, i, noise));
    for (const int other : visits.recognised(walk.place(), i, {seed, step, kLoops}))
      graph.edges.push_back(meter.measure(other, i, noise));
    visits.add(walk.place(), i);
  }
  return graph;
}

}  // namespace slam::eval
