// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/filter/fast_slam.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::particle_filter {
namespace {

using test::SimulatedWorld;

template <class Filter>
Pose2 run(Filter& filter, SimulatedWorld world, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) {
    const auto step = world.next();
    give(step.motion, filter);
    give(step.observations, filter);
    filter.execute();
    truth = step.truth;
  }
  return truth;
}

std::vector<double> numbersOf(FastSlam& filter) {
  std::vector<double> numbers;
  const auto add = [&](const auto& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) numbers.push_back(matrix.data()[i]);
  };
  add(filter.pose().pose.vector());
  add(filter.pose().covariance);
  for (const auto& landmark : as<MapKeeper>(filter).state().landmarks) {
    add(landmark.position);
    add(landmark.covariance);
  }
  for (const auto& [stamp, pose] : as<PathReviser>(filter).path()) add(pose.vector());
  for (const auto& pose : as<PoseSampler>(filter).particles()) add(pose.vector());
  return numbers;
}

std::vector<double> numbersAfter(const PfConfig& config, std::uint64_t seed, int steps = 80) {
  FastSlam filter;
  filter.seed(seed);
  filter.configure(config);
  run(filter, SimulatedWorld(3), steps);
  return numbersOf(filter);
}

class FastSlamVariant : public testing::TestWithParam<std::string> {
 protected:
  static PfConfig config() {
    PfConfig config;
    config.proposal = GetParam();
    return config;
  }
};

TEST_P(FastSlamVariant, GivesTheSameBitsOnAnyNumberOfThreads) {
  auto one = config(), two = config(), seven = config();
  one.size = two.size = seven.size = SetSize::kKld;
  two.threads = 2;
  seven.threads = 7;
  const auto numbers = numbersAfter(one, 5);
  EXPECT_EQ(numbers, numbersAfter(two, 5));
  EXPECT_EQ(numbers, numbersAfter(seven, 5));
}

TEST_P(FastSlamVariant, GivesOtherBitsForAnotherSeed) {
  EXPECT_NE(numbersAfter(config(), 5), numbersAfter(config(), 6));
}

TEST_P(FastSlamVariant, AgreesWithTheEkfWhereTheWorldIsNearlyLinear) {
  auto many = config();
  many.particles = 1000;
  FastSlam filter;
  filter.configure(many);
  ekf::EkfSlam reference;
  reference.configure(ekf::EkfConfig());
  run(filter, SimulatedWorld(21), 30);
  run(reference, SimulatedWorld(21), 30);
  const auto a = filter.pose(), b = reference.pose();
  const Eigen::Vector3d sigma = b.covariance.diagonal().cwiseSqrt();
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(std::abs(a.pose.vector()[i] - b.pose.vector()[i]), 0.6 * sigma[i]) << i;
    EXPECT_NEAR(std::sqrt(a.covariance(i, i)) / sigma[i], 1.0, 0.35) << i;
  }
  const auto state = as<MapKeeper>(filter).state(), expected = as<MapKeeper>(reference).state();
  ASSERT_EQ(state.landmarks.size(), expected.landmarks.size());
  for (std::size_t i = 0; i < state.landmarks.size(); ++i) {
    const auto& landmark = expected.landmarks[i];
    EXPECT_EQ(state.landmarks[i].id, landmark.id);
    const Eigen::Vector2d d = state.landmarks[i].position - landmark.position;
    EXPECT_LT(d.norm(), 2.5 * std::sqrt(landmark.covariance.trace())) << landmark.id;
  }
}

TEST_P(FastSlamVariant, SurvivesNoiseThatIsClaimedFarTooSmall) {
  FastSlam filter;
  filter.configure(config());
  SimulatedWorld world(4);
  Pose2 truth;
  for (int i = 0; i < 125; ++i) {
    auto step = world.next();
    for (auto& z : step.observations.observations) z.covariance *= 0.01;  // a tenth of the sigma
    give(step.motion, filter);
    give(step.observations, filter);
    filter.execute();
    truth = step.truth;
    ASSERT_TRUE(isCovariance(filter.pose().covariance)) << "step " << i;
  }
  EXPECT_LT((filter.pose().pose.position() - truth.position()).norm(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(All, FastSlamVariant, testing::ValuesIn(proposalNames()),
                         [](const auto& name) { return name.param; });

TEST(FastSlamTest, WorksWithEveryPolicy) {
  for (const auto& weighting : weightingNames()) {
    for (const auto& resampling : resamplingNames()) {
      PfConfig config;
      config.weighting = weighting;
      config.resampling = resampling;
      config.map = ToldMap::kMixture;
      FastSlam filter;
      filter.configure(config);
      const auto truth = run(filter, SimulatedWorld(6), 150);
      EXPECT_LT((filter.pose().pose.position() - truth.position()).norm(), 0.2)
          << weighting << ", " << resampling;
    }
  }
}

TEST(FastSlamTest, ResamplesOnlyBelowItsThreshold) {
  PfConfig config;
  for (const double threshold : {0.0, 0.5, 1.0}) {
    config.resampling_threshold = threshold;
    FastSlam filter;
    filter.configure(config);
    SimulatedWorld world(7);
    for (int i = 0; i < 60; ++i) {
      const auto before = filter.counters()["resampled"];
      const auto step = world.next();
      give(step.motion, filter);
      give(step.observations, filter);
      filter.execute();
      const bool below = test::figureOf(filter, "effective_sample_size") <
                         threshold * test::figureOf(filter, "particles");
      ASSERT_EQ(filter.counters()["resampled"] - before, below ? 1u : 0u);
    }
    if (threshold == 0.0) {
      EXPECT_EQ(filter.counters()["resampled"], 0u);
    }
    if (threshold == 0.5) {
      EXPECT_LT(filter.counters()["resampled"], 50u);
    }
    if (threshold == 1.0) {
      EXPECT_GT(filter.counters()["resampled"], 50u);
    }
  }
}

TEST(FastSlamTest, AdaptsItsNumberOfParticlesBetweenTheBounds) {
  PfConfig config;
  config.size = SetSize::kKld;
  config.min_particles = 20;
  config.max_particles = 300;
  config.resampling_threshold = 1.0;
  const auto sizeWith = [&](double sigma) {
    config.initial_sigma_position = sigma;
    FastSlam filter;
    filter.configure(config);
    run(filter, SimulatedWorld(8), 5);
    return as<PoseSampler>(filter).particles().size();
  };
  EXPECT_GE(sizeWith(1e-4), 20u);
  EXPECT_LT(sizeWith(1e-4), 250u);
  EXPECT_EQ(sizeWith(2.0), 300u) << "more bins than can be filled";
}

TEST(FastSlamTest, TellsThePathOfTheBestParticleAsItIsSeenNow) {
  PfConfig config;
  config.pose = ToldPose::kBest;
  config.resampling_threshold = 0.0;
  FastSlam filter;
  filter.configure(config);
  run(filter, SimulatedWorld(9), 50);
  const auto path = as<PathReviser>(filter).path();
  ASSERT_EQ(path.size(), 50u);
  EXPECT_EQ(nanoseconds(path.back().stamp), 1005000000000);
  EXPECT_EQ(path.back().pose.vector(), filter.pose().pose.vector());
  for (std::size_t i = 1; i < path.size(); ++i)  // of one particle: it never jumps
    EXPECT_LT(path[i - 1].pose.between(path[i].pose).position().norm(), 0.3);
}

TEST(FastSlamTest, SharesMapsAndPathsBetweenParticles) {
  FastSlam filter;
  filter.configure(PfConfig());
  run(filter, SimulatedWorld(10), 300);
  const auto& set = filter.particleSet();
  EXPECT_LT(set.memory().paths.posesInUse(), 300u * set.size() / 5);
  EXPECT_LE(set.memory().maps.leavesInUse(), 4u * set.size()) << "16 landmarks in leaves of 4";
}

TEST(FastSlamTest, KeepsNoPosesOfStepsThatSawNothing) {
  FastSlam filter;
  filter.configure(PfConfig());
  SimulatedWorld world(10);
  for (int i = 0; i < 200; ++i) {
    auto step = world.next();
    step.observations.observations.clear();
    give(step.motion, filter);
    give(step.observations, filter);
    filter.execute();
  }
  EXPECT_EQ(filter.particleSet().memory().paths.posesInUse(), 0u);
  const auto path = as<PathReviser>(filter).path();
  ASSERT_EQ(path.size(), 200u);
  for (std::size_t i = 1; i < path.size(); ++i)
    EXPECT_NEAR(path[i - 1].pose.between(path[i].pose).position().norm(), 0.2, 0.05);
}

TEST(FastSlamTest, SpreadsTwoParticlesAsWellAsMany) {
  PfConfig config;
  config.particles = 2;
  FastSlam filter;
  filter.configure(config);
  filter.set(PoseEstimate{Pose2(1, 2, 0), 0.25 * Eigen::Matrix3d::Identity()});
  filter.execute();
  const auto particles = as<PoseSampler>(filter).particles();
  EXPECT_GT((particles[0].position() - particles[1].position()).norm(), 0.01);
}

TEST(FastSlamTest, HasNoMemoryOfTheMapBeforeReset) {
  FastSlam filter;
  filter.configure(PfConfig());
  run(filter, SimulatedWorld(10), 30);
  filter.reset();
  EXPECT_EQ(filter.particleSet().memory().maps.leavesInUse(), 0u);
  EXPECT_EQ(filter.particleSet().memory().paths.posesInUse(), 0u);
  EXPECT_TRUE(as<PathReviser>(filter).path().empty());
}

TEST(PfConfigTest, RefusesWhatMakesNoFilter) {
  PfConfig config;
  config.particles = 0;
  config.resampling_threshold = 1.5;
  config.gate_probability = 0.0;
  config.proposal = "fastslam3";
  config.min_particles = 500;
  config.max_particles = 30;
  config.threads = 0;
  const auto faults = test::faultsOf([&] { FastSlam().configure(config); });
  EXPECT_EQ(faults.size(), 6u);
  EXPECT_TRUE(test::oneSays(faults, {"pf.particles", "0 is not allowed", "[1, 100000]"}));
  EXPECT_TRUE(test::oneSays(faults, {"pf.resampling_threshold", "[0, 1]"}));
  EXPECT_TRUE(test::oneSays(faults, {"pf.min_particles", "more than pf.max_particles"}));
  EXPECT_TRUE(test::oneSays(faults, {"pf.proposal", "did you mean 'fastslam1'"}));
}

TEST(PfConfigTest, RefusesToStartWithANumberOfParticlesOutsideItsBounds) {
  PfConfig config;
  config.particles = 10;
  config.min_particles = 30;
  EXPECT_NO_THROW(FastSlam().configure(config)) << "a fixed number has no bounds";
  config.size = SetSize::kKld;
  const auto faults = test::faultsOf([&] { FastSlam().configure(config); });
  EXPECT_TRUE(test::oneSays(faults, {"pf.particles", "pf.min_particles, 30", "not at 10"}));
}

TEST(PfConfigTest, RefusesAThresholdOfBeingLostThatIsNeverReached) {
  PfConfig config;
  config.gate_probability = 0.99;
  const auto faults = test::faultsOf([&] { FastSlam().configure(config); });
  EXPECT_TRUE(test::oneSays(faults, {"pf.lost_nis", "never reached", "pf.gate_probability"}));
}

TEST(PfConfigTest, RefusesAMatcherThatIsNotKnown) {
  FastSlam filter;
  as<MapChooser>(filter).useMap(MapKind::kGrid);
  Settings settings({}, {}, {"scan_matching.proposal=guessing"});
  const auto faults = test::faultsOf([&] { filter.configure(settings); });
  EXPECT_TRUE(test::oneSays(faults, {"scan_matching.proposal", "'guessing'", "matched"}));
}

}  // namespace
}  // namespace slam::particle_filter
