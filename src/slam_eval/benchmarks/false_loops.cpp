// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "false_loops.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "slam_core/common/random.hpp"

namespace slam::eval {
namespace {

constexpr int kGroup = 20, kLocalSteps = 20, kTrials = 1000;
constexpr double kSigmaPosition = 0.3, kSigmaHeading = 10.0 * M_PI / 180.0;  // [m], [rad]
constexpr double kTrueBound = 16.27;  // 99.9 % of chi2 with 3 degrees of freedom

class FalseLoops {
 public:
  FalseLoops(const PoseGraph& graph, FalseLoopKind kind)
      : poses_(graph.truth.empty() ? deadReckoning(graph) : graph.truth),
        is_local_(kind == FalseLoopKind::kLocal || kind == FalseLoopKind::kLocalGroups),
        is_grouped_(kind == FalseLoopKind::kRandomGroups || kind == FalseLoopKind::kLocalGroups) {
    const auto is_loop = [](const PoseEdge& edge) { return edge.isLoop(); };
    const auto& edges = graph.edges;
    const auto loop = std::find_if(edges.begin(), edges.end(), is_loop);
    if (!edges.empty()) information_ = (loop == edges.end() ? edges.front() : *loop).information;
  }

  /// Loops that belong together, all of them false.
  std::vector<PoseEdge> draw(int most, RandomStream random) const {
    const int size = is_grouped_ ? std::min(kGroup, most) : 1;
    for (int i = 0; i < kTrials; ++i) {
      auto loops = candidates(size, random);
      if (!loops.empty() &&
          std::all_of(loops.begin(), loops.end(), [this](const PoseEdge& e) { return isFalse(e); }))
        return loops;
    }
    throw std::runtime_error("a graph of " + std::to_string(poses_.size()) +
                             " poses is too small for false loops of this kind; take a larger one "
                             "or another kind");
  }

 private:
  /// Empty where the poses that were drawn cannot be joined.
  std::vector<PoseEdge> candidates(int size, RandomStream& random) const {
    const int last = static_cast<int>(poses_.size()) - size;  // that a group can begin at
    if (last < 0) return {};
    int a = between(0, last, random);
    int b =
        is_local_ ? between(a, std::min(last, a + kLocalSteps), random) : between(0, last, random);
    if (std::abs(b - a) < 2) return {};
    if (a > b) std::swap(a, b);
    const Pose2 z(kSigmaPosition * random.gaussian(), kSigmaPosition * random.gaussian(),
                  kSigmaHeading * random.gaussian());
    std::vector<PoseEdge> loops;
    loops.reserve(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) loops.push_back({a + i, b + i, z, information_, true});
    return loops;
  }

  bool isFalse(const PoseEdge& loop) const {
    const auto e = loop.error(poses_[static_cast<std::size_t>(loop.a)],
                              poses_[static_cast<std::size_t>(loop.b)])
                       .vector();
    return e.dot(information_ * e) > kTrueBound;
  }

  /// A whole number, both bounds included.
  static int between(int low, int high, RandomStream& random) {
    return low + static_cast<int>(random.uniform() * (high - low + 1));
  }

  std::vector<Pose2> poses_;
  bool is_local_, is_grouped_;
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Identity();
};

}  // namespace

void addFalseLoops(PoseGraph& graph, FalseLoopKind kind, int count, std::uint64_t seed) {
  const FalseLoops source(graph, kind);
  for (std::uint64_t draw = 0; count > 0; ++draw) {
    const auto loops = source.draw(count, {seed, draw});
    graph.edges.insert(graph.edges.end(), loops.begin(), loops.end());
    count -= static_cast<int>(loops.size());
  }
}

}  // namespace slam::eval
