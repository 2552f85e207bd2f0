// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_imu_odometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/registry.hpp"
#include "slam_core/gyro/test/turning_robot.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::laser_odometry {
namespace {

using gyro::test::Leg;
using gyro::test::TurningRobot;

constexpr double kScanRate = 5.0;  // [Hz]
constexpr TurningRobot::Rates kRates = {kScanRate, 100.0};
constexpr gyro::test::GyroErrors kMems = {0.008, 2e-5, 2e-4, 0.005};
/// Around the box in the room, so that the turns confirm the gyro.
const std::vector<Leg> kRound = {{2.0, 0.0, 0.0}, {8.0, 0.5, 0.5 / 2.3}};

std::vector<Leg> roundAnd(const std::vector<Leg>& legs) {
  auto all = kRound;
  all.insert(all.end(), legs.begin(), legs.end());
  return all;
}

/// A robot in a room, with the scans that its laser takes and the samples of its gyro.
class LaserAndGyro : public testing::Test {
 protected:
  LaserAndGyro() { loadLibraries({}); }

  void drive(const std::vector<Leg>& legs) {
    robot = TurningRobot(1, {}, kMems, kRates);
    robot.drive(legs);
    samples = robot.gyro();
    scans.clear();
    RandomStream random(7, 0);
    for (const auto& truth : robot.truth()) {
      const auto pose = test::RoomDrive::start() * truth.pose;
      scans.push_back(test::scanOf(room, pose, test::RoomDrive::sensorPose(), 181, 0.01, random));
      scans.back().stamp = truth.stamp;
    }
  }
  void blind(double begin, double end) {
    for (auto& scan : scans)
      if (secondOf(scan.stamp) >= begin && secondOf(scan.stamp) < end) scan.beams.clear();
  }
  template <class Change>
  void changeSamples(double begin, double end, Change change) {
    for (auto& sample : samples)
      if (secondOf(sample.stamp) >= begin && secondOf(sample.stamp) < end) change(sample);
  }
  double secondOf(Stamp stamp) const { return seconds(stamp - robot.truth().front().stamp); }

  /// @param lead by which the samples arrive before scans of the same stamp [s]
  void run(const std::string& name, double lead = 0.1) {
    source = Registry<OdometrySource>::instance().create(name);
    Settings settings({}, {}, {});
    source->configure(settings);
    inputs = std::make_unique<test::ComponentDriver>(*source);
    motions.clear();
    messages.clear();
    auto sample = samples.begin();
    for (const auto& scan : scans) {
      const auto until = scan.stamp + durationFromSeconds(lead);
      for (; sample != samples.end() && sample->stamp <= until; ++sample)
        if (name == "laser_imu") take(*sample);
      take(scan);
    }
  }
  template <class Input>
  void take(const Input& input) {
    inputs->set(input);
    do {
      const auto status = source->execute();
      if (!status.isOk()) messages.push_back(status.message);
      if (source->motion()) motions.push_back(*source->motion());
    } while (source->isBusy());
  }

  bool said(const std::string& part) const {
    return std::any_of(messages.begin(), messages.end(), [&](const auto& message) {
      return message.find(part) != std::string::npos;
    });
  }
  /// At the end of the last motion.
  Pose2 error() const {
    const auto is_there = [&](const auto& truth) { return truth.stamp == motions.back().end; };
    const auto truth = std::find_if(robot.truth().begin(), robot.truth().end(), is_there);
    return truth->pose.between(motions.back().odometry_end);
  }
  void expectRight(double position = 0.05, double heading = 0.02) const {
    ASSERT_FALSE(motions.empty());
    EXPECT_LT(error().position().norm(), position);
    EXPECT_NEAR(error().theta(), 0.0, heading);
    for (const auto& motion : motions) EXPECT_EQ(faultOf(motion), "");
  }

  const LaserImuOdometry of_library;  // a library that no symbol is named of would not be linked
  test::Room room;
  TurningRobot robot{1, {}, kMems, kRates};
  std::vector<ImuSample> samples;
  std::vector<LaserScan> scans;
  std::unique_ptr<OdometrySource> source;
  std::unique_ptr<test::ComponentDriver> inputs;
  std::vector<Motion> motions;
  std::vector<std::string> messages;
};

TEST_F(LaserAndGyro, FollowSpinsThatAreTooFastForTheLaserAlone) {
  drive(roundAnd({{1.2, 0.0, 4.0}, {1.2, 0.0, -4.0}, {1.2, 0.0, 4.0}, {2.0, 0.5, 0.2}}));
  run("laser_imu");
  expectRight();
  EXPECT_EQ(source->counters()["unmatched"], 0U);
  EXPECT_TRUE(messages.empty()) << messages[0];
  run("laser");
  EXPECT_GT(source->counters()["unmatched"], 0U);
}

TEST_F(LaserAndGyro, KnowTheTurnWhileTheLaserIsBlind) {
  drive(roundAnd({{3.0, 0.3, 0.8}, {3.0, 0.0, 0.0}}));
  blind(11.0, 12.6);
  run("laser_imu");
  EXPECT_TRUE(said("the last velocity and the gyro are used meanwhile"));
  expectRight(0.3, 0.02);
  for (const auto& motion : motions)
    if (secondOf(motion.end) > 11.0 && secondOf(motion.end) < 12.6) {
      EXPECT_LT(std::sqrt(motion.covariance(2, 2)), 0.03);
    }
  run("laser");
  EXPECT_GT(std::sqrt(motions[57].covariance(2, 2)), 0.5) << "at 11.6 s";
}

TEST_F(LaserAndGyro, AGyroThatCountsInDegreesIsNotBelieved) {
  drive(roundAnd({{3.0, 0.3, -0.6}, {3.0, 0.0, 0.8}}));
  changeSamples(0.0, 1e9, [](auto& sample) { sample.angular_velocity *= 180.0 / M_PI; });
  run("laser_imu");
  expectRight();
  ASSERT_EQ(messages.size(), 1U) << "it is said once";
  EXPECT_TRUE(said("times as large as those that the laser measured")) << messages[0];
  EXPECT_GT(source->counters()["gyro_implausible"], 10U);
}

TEST_F(LaserAndGyro, AGyroThatHangsUpsideDownIsNotBelieved) {
  drive(roundAnd({{3.0, 0.3, -0.6}, {3.0, 0.0, 0.8}}));
  changeSamples(0.0, 1e9, [](auto& sample) { sample.angular_velocity *= -1.0; });
  run("laser_imu");
  expectRight();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(said("opposite to those that the laser measured")) << messages[0];
}

TEST_F(LaserAndGyro, SpikesOfTheGyroDoNotTurnTheRobot) {
  drive(roundAnd({{4.0, 0.3, -0.6}, {4.0, 0.0, 0.8}}));
  changeSamples(11.0, 11.5, [](auto& sample) { sample.angular_velocity.z() += 3.0; });
  changeSamples(13.0, 13.2, [](auto& sample) { sample.angular_velocity.z() -= 50.0; });
  changeSamples(15.0, 15.5, [](auto& sample) { sample.angular_velocity.z() -= 1.0; });
  run("laser_imu");
  expectRight();
  EXPECT_FALSE(said("counts in degrees")) << "they do not refute a gyro that turns have confirmed";
}

TEST_F(LaserAndGyro, AGyroThatHangsIsReported) {
  drive(roundAnd({{4.0, 0.3, -0.6}, {4.0, 0.0, 0.8}}));
  changeSamples(11.0, 1e9, [](auto& sample) { sample.angular_velocity.z() = 0.01; });
  run("laser_imu");
  expectRight();
  EXPECT_TRUE(said("repeats one angular velocity while the laser"));
  EXPECT_GT(source->counters()["gyro_stuck"], 10U);
}

TEST_F(LaserAndGyro, TheLaserGoesOnAloneWhereTheGyroIsSilent) {
  drive(roundAnd({{4.0, 0.3, -0.6}, {4.0, 0.0, 0.8}}));
  samples.erase(samples.begin() + 1000, samples.end());
  run("laser_imu");
  expectRight();
  EXPECT_GE(motions.size() + 7, scans.size()) << "the last second waits for the gyro";
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(said("the IMU is silent")) << messages[0];
  EXPECT_GT(source->counters()["gyro_silent"], 10U);
}

TEST_F(LaserAndGyro, TheOrderOfArrivalDoesNotMatter) {
  drive(roundAnd({{3.0, 0.3, 0.8}}));
  run("laser_imu", 0.3);
  const auto early = motions;
  run("laser_imu", -0.5);
  ASSERT_GT(motions.size(), 50U);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_EQ(motions[i].increment.vector(), early[i].increment.vector());
    EXPECT_EQ(motions[i].covariance, early[i].covariance);
  }
}

TEST_F(LaserAndGyro, TellTheBiasOfTheGyro) {
  drive(roundAnd({{3.0, 0.3, 0.8}, {10.0, 0.0, 0.0}, {3.0, 0.3, -0.6}, {10.0, 0.0, 0.0}}));
  run("laser_imu");
  std::map<std::string, double> figures;
  for (const auto& [name, value] : source->figures()) figures[name] = value;
  EXPECT_NEAR(figures.at("gyro_bias"), robot.bias(), 3.0 * figures.at("gyro_bias_sigma"));
  EXPECT_LT(figures.at("gyro_bias_sigma"), 0.002) << "[rad/s], of 0.01 in the beginning";
}

}  // namespace
}  // namespace slam::laser_odometry
