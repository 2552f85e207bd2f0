// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/consistency_monitor.hpp"

#include <gtest/gtest.h>

#include <string>

#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

namespace slam {
namespace {

using test::SimulatedWorld;

/// For each source, the claimed variance as a share of the true one.
struct Claims {
  double range = 1.0, bearing = 1.0, motion = 1.0;
};

class ConsistencyMonitorTest : public testing::Test {
 protected:
  /// The update at which the first warning came, or -1.
  int run(std::uint64_t seed, const Claims& claims, int updates, int wrong_from = 0) {
    ekf::EkfSlam ekf;
    ekf.configure(ekf::EkfConfig());
    monitor = ConsistencyMonitor();
    SimulatedWorld world(seed);
    for (int i = 0; i < updates; ++i) {
      auto step = world.next();
      if (i >= wrong_from) {
        step.motion.covariance *= claims.motion;
        for (auto& z : step.observations.observations) {
          z.covariance(0, 0) *= claims.range;
          z.covariance(1, 1) *= claims.bearing;
        }
      }
      give(step.motion, ekf);
      give(step.observations, ekf);
      ekf.execute();
      monitor.add(as<LandmarkMapper>(ekf).statistics());
      if (!monitor.finding().empty()) return i;
    }
    return -1;
  }
  double sigma(ConsistencyMonitor::Source source) const { return monitor.factors()[source].sigma; }
  bool names(const std::string& text) const {
    return monitor.finding().find(text) != std::string::npos;
  }

  ConsistencyMonitor monitor;
};

TEST_F(ConsistencyMonitorTest, IsSilentWhereTheSigmasAreRight) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(run(seed, Claims(), 700), -1) << "seed " << seed << ": " << monitor.finding();
    EXPECT_NEAR(sigma(ConsistencyMonitor::kRange), 1.0, 0.35);
    EXPECT_NEAR(sigma(ConsistencyMonitor::kBearing), 1.0, 0.35);
  }
}

TEST_F(ConsistencyMonitorTest, NamesASigmaThreeTimesTooSmallWithinFiftyUpdates) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const int from : {0, 200}) {
      const Claims range{1.0 / 9.0, 1.0, 1.0}, bearing{1.0, 1.0 / 9.0, 1.0};
      int update = run(seed, range, from + 50, from);
      EXPECT_GE(update, from) << "seed " << seed;
      EXPECT_TRUE(names("range sigma looks")) << monitor.finding();
      EXPECT_TRUE(names("too small")) << monitor.finding();
      EXPECT_TRUE(monitor.overconfident());
      update = run(seed, bearing, from + 50, from);
      EXPECT_GE(update, from) << "seed " << seed;
      EXPECT_TRUE(names("bearing sigma looks")) << monitor.finding();
    }
}

/// An update carries less information about the odometry: its NIS is hardly above 1 here when the
/// odometry is named.
TEST_F(ConsistencyMonitorTest, NamesTheOdometryWhenItIsWorseThanItSays) {
  int named = 0, within_fifty = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const int update = run(seed, {1.0, 1.0, 1.0 / 9.0}, 300, 200);
    if (update < 0) continue;
    EXPECT_TRUE(names("odometry sigma looks")) << monitor.finding();
    EXPECT_TRUE(names("too small")) << monitor.finding();
    ++named;
    within_fifty += update < 250 ? 1 : 0;
  }
  EXPECT_EQ(named, 20);
  EXPECT_GE(within_fifty, 17);
}

TEST_F(ConsistencyMonitorTest, NamesTheOdometryOnceTheMapIsKnownWhereItWasWrongFromTheBeginning) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_GE(run(seed, {1.0, 1.0, 1.0 / 9.0}, 300), 0) << "seed " << seed;
    EXPECT_TRUE(names("odometry sigma looks")) << monitor.finding();
  }
}

TEST_F(ConsistencyMonitorTest, NamesASigmaThatIsTooLarge) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_GE(run(seed, {9.0, 1.0, 1.0}, 200), 0) << "seed " << seed;
    EXPECT_TRUE(names("range sigma looks")) << monitor.finding();
    EXPECT_TRUE(names("too large")) << monitor.finding();
    EXPECT_FALSE(monitor.overconfident()) << "no fault";
  }
}

TEST_F(ConsistencyMonitorTest, TellsTheFactorOnceTheWindowIsFull) {
  ekf::EkfSlam ekf;
  ekf.configure(ekf::EkfConfig());
  SimulatedWorld world(3);
  for (int i = 0; i < 300; ++i) {
    auto step = world.next();
    if (i >= 200)
      for (auto& z : step.observations.observations) z.covariance(0, 0) /= 9.0;
    give(step.motion, ekf);
    give(step.observations, ekf);
    ekf.execute();
    monitor.add(as<LandmarkMapper>(ekf).statistics());
  }
  EXPECT_EQ(monitor.updates(), 50);
  EXPECT_NEAR(sigma(ConsistencyMonitor::kRange), 3.0, 0.6);
  EXPECT_NEAR(sigma(ConsistencyMonitor::kBearing), 1.0, 0.35);
  EXPECT_GT(monitor.nisMean(), monitor.nisBounds()[1]);
}

TEST_F(ConsistencyMonitorTest, PassesOverStepsWithoutKnownLandmarks) {
  monitor.add(UpdateStatistics());
  EXPECT_EQ(monitor.updates(), 0);
  EXPECT_EQ(monitor.nisMean(), 0.0);
}

/// As run(), with a particle filter.
class ConsistencyOfParticles : public testing::TestWithParam<std::string> {
 protected:
  static std::string warningAfter(std::uint64_t seed, double range_claim, int updates) {
    particle_filter::PfConfig config;
    config.proposal = GetParam();
    particle_filter::FastSlam filter;
    filter.configure(config);
    ConsistencyMonitor monitor;
    SimulatedWorld world(seed);
    for (int i = 0; i < updates && monitor.finding().empty(); ++i) {
      auto step = world.next();
      for (auto& z : step.observations.observations) z.covariance(0, 0) *= range_claim;
      give(step.motion, filter);
      give(step.observations, filter);
      filter.execute();
      monitor.add(as<LandmarkMapper>(filter).statistics());
    }
    return monitor.finding();
  }
};

TEST_P(ConsistencyOfParticles, IsWatchedWithoutFalseAlarm) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) EXPECT_EQ(warningAfter(seed, 1.0, 120), "");
}

TEST_P(ConsistencyOfParticles, NamesTheSensorThatIsWrong) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    EXPECT_NE(warningAfter(seed, 1.0 / 9.0, 100).find("range sigma"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Proposals, ConsistencyOfParticles,
                         testing::Values("fastslam1", "fastslam2"));

}  // namespace
}  // namespace slam
