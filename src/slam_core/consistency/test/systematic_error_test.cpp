// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam {
namespace {

using test::ComponentDriver;
using test::SimulatedStep;
using test::SimulatedWorld;
using Error = std::function<void(SimulatedStep&)>;

Error bearingOffset(double offset) {
  return [offset](SimulatedStep& step) {
    for (auto& z : step.observations.observations) z.bearing += offset;
  };
}

Error rangeScale(double scale) {
  return [scale](SimulatedStep& step) {
    for (auto& z : step.observations.observations) z.range *= scale;
  };
}

Error odometryScale(double way, double turn) {
  return [way, turn](SimulatedStep& step) {
    const auto u = step.motion.increment.vector();
    step.motion.increment = Pose2(way * u.x(), way * u.y(), turn * u.z());
  };
}

/// The findings of a drive in which an error begins at some update.
class SystematicErrorTest : public testing::Test {
 protected:
  struct Found {
    std::string first;  ///< of all findings
    int update = -1;    ///< at which it came
    bool is_bias = false, is_lost = false, is_sensor = false, is_odometry = false;
  };

  static bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
  static Found drive(Backend& backend, std::uint64_t seed, const Error& error, int from,
                     int updates) {
    ConsistencyMonitor monitor;
    SimulatedWorld world(seed);
    ComponentDriver inputs(backend);
    const auto* statistics = capabilitiesOf(backend).find<LandmarkMapper>();
    Found found;
    for (int i = 0; i < updates; ++i) {
      auto step = world.next();
      if (i >= from) error(step);
      inputs.set(step.motion);
      inputs.set(step.observations);
      backend.execute();
      monitor.add(statistics->statistics());
      const auto finding = monitor.finding();
      if (finding.empty()) continue;
      if (found.update < 0) found = {finding, i};
      found.is_bias |= contains(finding, "biased");
      found.is_lost |= contains(finding, "may be lost");
      found.is_sensor |= contains(finding, "range sigma") || contains(finding, "bearing sigma");
      found.is_odometry |= contains(finding, "odometry sigma");
    }
    return found;
  }
  static Found drive(std::uint64_t seed, const Error& error, int from = 0, int updates = 200) {
    ekf::EkfSlam ekf;
    ekf.configure(ekf::EkfConfig());
    return drive(ekf, seed, error, from, from + updates);
  }
  static void expectBias(const std::vector<Found>& drives) {
    std::size_t odometry = 0;
    for (const auto& found : drives) {
      EXPECT_TRUE(found.is_bias) << found.first;
      EXPECT_FALSE(found.is_sensor) << found.first;
      odometry += found.is_odometry ? 1 : 0;
    }
    EXPECT_LE(10 * odometry, drives.size());
  }
};

/// Until the bias is significant, the odometry may be reported as worse than its sigma, which is
/// true. But that must be rare, and no sensor may be blamed for its noise.
TEST_F(SystematicErrorTest, ABearingOffsetIsNamedABias) {
  std::vector<Found> all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const double offset : {0.02, -0.05, 0.1})
      all.push_back(drive(seed, bearingOffset(offset)));
  expectBias(all);
}

TEST_F(SystematicErrorTest, NoSensorSigmaIsNamedForABearingThatIsKnockedOffOnTheWay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto found = drive(seed, bearingOffset(-0.1), 200);
    EXPECT_GE(found.update, 200) << "seed " << seed;
    EXPECT_TRUE(found.is_bias || found.is_lost) << "seed " << seed;
    EXPECT_FALSE(found.is_sensor) << found.first;
  }
}

TEST_F(SystematicErrorTest, AScaleOfRangesIsNamedABias) {
  std::vector<Found> all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const double scale : {0.8, 1.03, 1.2}) all.push_back(drive(seed, rangeScale(scale)));
  expectBias(all);
}

TEST_F(SystematicErrorTest, AScaleOfTheOdometryIsNamedABias) {
  std::vector<Found> all;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const auto& error : {odometryScale(1.05, 1.0), odometryScale(1.1, 1.0),
                              odometryScale(0.8, 1.0), odometryScale(1.0, 1.1)})
      all.push_back(drive(seed, error));
  expectBias(all);
}

TEST_F(SystematicErrorTest, APoseThatIsLostIsNamedWithinAWindowAndNoSigma) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    bool is_first = true;
    const auto kidnap = [&](SimulatedStep& step) {
      // the odometry jumps once, with a covariance so small that no observation fits any more
      if (std::exchange(is_first, false))
        step.motion.increment = step.motion.increment * Pose2(2.0, 1.0, 0.7);
    };
    const auto found = drive(seed, kidnap, 100, 100);
    EXPECT_TRUE(found.is_lost) << "seed " << seed << ": " << found.first;
    EXPECT_GE(found.update, 100);
    EXPECT_LE(found.update, 150);
    EXPECT_TRUE(contains(found.first, "observations failed the gate: the pose may be lost"))
        << found.first;
  }
}

TEST_F(SystematicErrorTest, HealthyDrivesPassWithoutAlarm) {
  for (std::uint64_t seed = 101; seed <= 160; ++seed) {
    const auto found = drive(
        seed, [](SimulatedStep&) {}, 0, 300);
    EXPECT_EQ(found.update, -1) << "seed " << seed << ": " << found.first;
  }
}

TEST_F(SystematicErrorTest, AFewWrongReadingsPassWithoutAlarm) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomStream random(seed, 1);
    const auto wrong = [&](SimulatedStep& step) {
      for (auto& z : step.observations.observations)
        if (random.uniform() < 0.1) z.range += 2.0 * random.gaussian();
    };
    EXPECT_FALSE(drive(seed, wrong, 50).is_lost) << "seed " << seed;
  }
}

TEST_F(SystematicErrorTest, AParticleFilterIsJudgedTheSameWay) {
  for (const std::string proposal : {"fastslam1", "fastslam2"}) {
    particle_filter::PfConfig config;
    config.proposal = proposal;
    particle_filter::FastSlam filter;
    filter.configure(config);
    const auto found = drive(filter, 1, bearingOffset(0.1), 0, 120);
    EXPECT_TRUE(found.is_bias || found.is_lost) << proposal << ": " << found.first;
    EXPECT_FALSE(contains(found.first, "sigma")) << proposal << ": " << found.first;
  }
}

}  // namespace
}  // namespace slam
