// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "slam_core/common/random.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::SimulatedWorld;

/// Trees in pairs that stand closely together, of which one is thin and one thick.
std::map<LandmarkId, Eigen::Vector2d> pairsOfTrees() {
  constexpr int kPairs = 20;
  RandomStream random(11, 0);
  std::map<LandmarkId, Eigen::Vector2d> trees;
  while (trees.size() < 2 * kPairs) {
    const Eigen::Vector2d place(14.0 * random.uniform() - 7.0, 14.0 * random.uniform() - 3.0);
    const double angle = 2.0 * M_PI * random.uniform();
    const auto is_near = [&](const auto& other) { return (other.second - place).norm() < 1.2; };
    const double from_way = std::abs((place - Eigen::Vector2d(0.0, 4.0)).norm() - 4.0);
    if (from_way < 0.8 || std::any_of(trees.begin(), trees.end(), is_near)) continue;
    const auto id = static_cast<LandmarkId>(trees.size());
    trees[id] = place;
    trees[id + 1] = place + 0.12 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return trees;
}

/// The result of a drive of two laps through the wood.
struct Outcome {
  int paired = 0, wrong = 0, seen = 0;
  double squared = 0.0;  ///< mean of the squared error of position [m^2]
  std::size_t landmarks = 0;
  double pairedShare() const { return paired / double(seen); }
  double wrongShare() const { return wrong / double(std::max(1, paired)); }
};

Outcome driven(const std::string& backend, const std::string& association) {
  constexpr int kSteps = 250;
  Settings settings({}, {}, {"association=" + association, "relocalisation.enabled=false"});
  Estimator estimator;
  estimator.use(Registry<Backend>::instance().create(backend));
  estimator.configure(settings);
  SimulatedWorld world(2, pairsOfTrees());
  RandomStream random(3, 0);
  std::map<LandmarkId, LandmarkId> tree_of;  // by landmark
  Outcome outcome;
  for (int i = 0; i < kSteps; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations) {
      const double radius = z.id % 2 == 0 ? 0.1 : 0.3;
      z.descriptor = descriptorOf(radius + 0.03 * random.gaussian(), 0.03);
    }
    estimator.set(step.motion);
    estimator.set(step.observations);
    for (estimator.execute(); estimator.report(); estimator.execute()) {
      const auto& report = *estimator.report();
      outcome.squared +=
          (report.pose.pose.position() - step.truth.position()).squaredNorm() / kSteps;
      for (const auto& z : report.statistics.associations) {
        ++outcome.seen;
        if (z.taken_for == TakenFor::kNew) tree_of[z.landmark] = z.own_id;
        if (z.taken_for != TakenFor::kLandmark) continue;
        ++outcome.paired;
        // a particle other than the most likely one may have begun it
        outcome.wrong += tree_of.try_emplace(z.landmark, z.own_id).first->second != z.own_id;
      }
    }
  }
  outcome.landmarks = estimator.capabilities().find<LandmarkMapper>()->landmarks().size();
  testing::Test::RecordProperty(
      association, fmt::format("{:.1f} % paired, {:.2f} % wrong, ATE {:.3f} m, {} landmarks",
                               100.0 * outcome.pairedShare(), 100.0 * outcome.wrongShare(),
                               std::sqrt(outcome.squared), outcome.landmarks));
  return outcome;
}

class WoodOfPairs : public testing::TestWithParam<std::string> {};

TEST_P(WoodOfPairs, DescriptorsTellTreesApartThatStandTogether) {
  const auto by_place = driven(GetParam(), "jcbb");
  const auto by_descriptor = driven(GetParam(), "descriptor");
  EXPECT_LT(by_descriptor.wrongShare(), 0.002);
  EXPECT_LE(by_descriptor.wrongShare(), by_place.wrongShare());
  EXPECT_GT(by_descriptor.pairedShare(), by_place.pairedShare() + 0.2)
      << "what place alone leaves out as ambiguous";
  EXPECT_EQ(by_descriptor.landmarks, 40u) << "each tree once";
  EXPECT_LT(std::sqrt(by_descriptor.squared), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Backends, WoodOfPairs, testing::Values("ekf", "pf", "graph", "seif"),
                         [](const auto& backend) { return backend.param; });

}  // namespace
}  // namespace slam
