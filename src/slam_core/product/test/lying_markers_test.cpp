// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/lying_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::Lies;
using test::LyingWorld;

/// Four laps of a robot between markers that lie from some step on, which has to notice it itself.
class LyingMarkers : public testing::TestWithParam<std::string> {
 protected:
  static constexpr int kSteps = 500;

  void SetUp() override {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void drive(const Lies& lies, int from = 0) {
    for (int i = 0; i < kSteps; ++i) {
      if (i == from) world.lies() = lies;
      take(world.next());
    }
  }
  void take(const test::SimulatedStep& step) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    do {
      const auto status = estimator.execute();
      if (!estimator.report()) return;
      if (!status.isOk()) messages.insert(status.message);
      const auto& [pose, covariance] = estimator.report()->pose;
      squared += (pose.position() - step.truth.position()).squaredNorm() / kSteps;
      nees += test::nees(step.truth, pose, covariance) / kSteps;
    } while (estimator.report());
  }
  /// The back-ends err as little as without lies, where they reach 0.05 m and a NEES of 3.
  void expectSurvival() const {
    RecordProperty("ate", fmt::format("{:.3f} m", std::sqrt(squared)));
    RecordProperty("nees", fmt::format("{:.1f}", nees));
    EXPECT_LT(std::sqrt(squared), 0.08);
    EXPECT_LT(nees, 6.0);
  }
  /// Messages that hold both of these.
  int said(const std::string& name, const std::string& what) const {
    int count = 0;
    for (const auto& message : messages)
      count +=
          message.find(name + " ") != std::string::npos && message.find(what) != std::string::npos;
    return count;
  }
  const Landmark* landmark(LandmarkId id) {
    map = estimator.capabilities().find<LandmarkMapper>()->landmarks();
    for (const auto& landmark : map)
      if (landmark.id == id) return &landmark;
    return nullptr;
  }
  std::uint64_t counted(const std::string& reason) { return estimator.counters()[reason]; }

  LyingWorld world{3};
  Estimator estimator;
  LandmarkMap map;
  std::set<std::string> messages;
  double squared = 0.0, nees = 0.0;
};

TEST_P(LyingMarkers, NoneThatIsHonestIsDoubted) {
  drive(Lies());
  expectSurvival();
  EXPECT_EQ(counted("begun_anew"), 0u);
  landmark(10);
  EXPECT_EQ(map.size(), world.landmarks().size());
}

TEST_P(LyingMarkers, TwoOfOneIdAreNotUsedOnceTheyAreFoundOut) {
  Lies lies;
  lies.printed_as = {{14, 10}};  // across the circle: never seen together
  drive(lies);
  expectSurvival();
  EXPECT_EQ(said("landmark 10", "several markers have this id"), 1);
  EXPECT_EQ(counted("distrusted"), 1u);
  EXPECT_GT(counted("distrusted_id"), 50u);
  EXPECT_EQ(landmark(10), nullptr);
  EXPECT_EQ(map.size(), world.landmarks().size() - 2);
}

TEST_P(LyingMarkers, TwoOfOneIdThatAreSeenTogetherAreNotUsedEither) {
  Lies lies;
  lies.printed_as = {{46, 50}};
  drive(lies);
  expectSurvival();
  EXPECT_EQ(said("landmark 50", "several markers have this id"), 1);
  EXPECT_EQ(landmark(50), nullptr);
}

TEST_P(LyingMarkers, OneThatWasMovedIsFoundWhereItIsNow) {
  Lies lies;
  const Eigen::Vector2d place = world.landmarks().at(10) + Eigen::Vector2d(1.0, 1.0);
  lies.moved = {{10, place}};
  drive(lies, 150);
  expectSurvival();
  EXPECT_EQ(said("landmark 10", "it was moved"), 1);
  EXPECT_EQ(counted("begun_anew"), 1u);
  EXPECT_EQ(counted("distrusted"), 0u);
  ASSERT_NE(landmark(10), nullptr);
  EXPECT_LT((landmark(10)->position - place).norm(), 0.2);
}

TEST_P(LyingMarkers, FourThatWereMovedAreNotTakenForALostRobot) {
  Lies lies;
  for (const LandmarkId id : {10, 13, 48, 50})
    lies.moved[id] = world.landmarks().at(id) + Eigen::Vector2d(1.0, 0.5);
  drive(lies, 150);
  expectSurvival();
  EXPECT_EQ(counted("begun_anew"), 4u);
  EXPECT_EQ(counted("relocalised"), 0u);
  for (const auto& [id, place] : lies.moved) {
    ASSERT_NE(landmark(id), nullptr) << id;
    EXPECT_LT((landmark(id)->position - place).norm(), 0.2) << id;
  }
}

TEST_P(LyingMarkers, AFifthOfFalseIdsCostsNoLandmark) {
  Lies lies;
  lies.false_ids = 0.2;
  drive(lies);
  expectSurvival();
  EXPECT_GT(counted("gated"), 300u);
  for (const auto& [id, place] : world.landmarks()) {
    ASSERT_NE(landmark(id), nullptr) << id;
    EXPECT_LT((landmark(id)->position - place).norm(), 0.2) << id;
  }
}

TEST_P(LyingMarkers, AFifthOfFalseRangesIsLeftOut) {
  Lies lies;
  lies.false_ranges = 0.2;
  drive(lies);
  expectSurvival();
  EXPECT_GT(counted("gated"), 500u);
  EXPECT_EQ(counted("distrusted"), 0u);
}

INSTANTIATE_TEST_SUITE_P(Backends, LyingMarkers, testing::Values("ekf", "pf", "graph", "seif"),
                         [](const auto& backend) { return backend.param; });

}  // namespace
}  // namespace slam
