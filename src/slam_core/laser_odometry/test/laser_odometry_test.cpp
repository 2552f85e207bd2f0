// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_odometry/laser_odometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/registry.hpp"
#include "slam_core/laser_odometry/laser_wheel_odometry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::laser_odometry {
namespace {

using test::RoomDrive;

/// A robot in a room, with or without wheels beside its laser.
class LaserOdometryInARoom : public testing::Test {
 protected:
  LaserOdometryInARoom() { use("laser"); }

  void use(const std::string& name) {
    loadLibraries({});
    inputs.reset();
    source = Registry<OdometrySource>::instance().create(name);
    Settings settings({}, {}, {});
    source->configure(settings);
    inputs = std::make_unique<test::ComponentDriver>(*source);
  }

  void execute() {
    do {
      const auto status = source->execute();
      if (!status.isOk()) message = status.message;
      if (source->motion()) motions.push_back(*source->motion());
    } while (source->isBusy());
  }
  void look(const LaserScan& scan) {
    inputs->set(scan);
    execute();
  }
  void turnWheels(Stamp stamp, const Pose2& pose) {
    OdometrySample sample;
    sample.stamp = stamp;
    sample.pose = pose;
    inputs->set(sample);
    execute();
  }
  RoomDrive::Step lookOn() {
    const auto step = drive.next();
    look(step.scan);
    return step;
  }
  /// The wheels first, then the laser. @param slip by which the wheels' pose is off from now on
  RoomDrive::Step driveOn(const Pose2& slip = Pose2()) {
    const auto step = drive.next();
    slipped = slipped * slip;
    turnWheels(step.scan.stamp, step.motion.odometry_end * slipped);
    look(step.scan);
    return step;
  }
  double errorAt(const Pose2& truth) const {
    return (motions.back().odometry_end.position() - truth.position()).norm();
  }

  const LaserOdometry of_library;  // a library that no symbol is named of would not be linked
  RoomDrive drive{1};
  std::unique_ptr<OdometrySource> source;
  std::unique_ptr<test::ComponentDriver> inputs;
  std::vector<Motion> motions;
  std::string message;
  Pose2 slipped;
};

TEST_F(LaserOdometryInARoom, FollowsTheRobotWithoutWheels) {
  constexpr int kScans = 145;  // once around
  Pose2 truth;
  for (int i = 0; i < kScans; ++i) truth = lookOn().truth;
  ASSERT_EQ(motions.size(), kScans - 1u) << "one for every scan after the first";
  EXPECT_LT(errorAt(truth), 0.05) << "after 14.4 m";
  EXPECT_NEAR(truth.between(motions.back().odometry_end).theta(), 0.0, 0.015);
  EXPECT_EQ(message, "");
  for (std::size_t i = 1; i < motions.size(); ++i) {
    EXPECT_EQ(motions[i].start, motions[i - 1].end);
    EXPECT_EQ(motions[i].sequence, i);
    EXPECT_EQ(faultOf(motions[i]), "");
  }
}

TEST_F(LaserOdometryInARoom, ErrsByAsMuchAsItSays) {
  Pose2 before;
  double squares = 0.0;
  constexpr int kScans = 400;
  for (int i = 0; i < kScans; ++i) {
    const auto truth = lookOn().truth;
    if (!motions.empty()) {
      const auto& motion = motions.back();
      const Eigen::Vector3d error = motion.increment.vector() - before.between(truth).vector();
      squares += error.dot(motion.covariance.inverse() * error);
    }
    before = truth;
  }
  const double mean = squares / static_cast<double>(motions.size());
  EXPECT_GT(mean, 1.0) << "3 is expected of errors that are exactly as large as told";
  EXPECT_LT(mean, 4.2);
}

TEST_F(LaserOdometryInARoom, IsUnsureWhileTheLaserIsBlindAndGoesOnAfterwards) {
  for (int i = 0; i < 30; ++i) lookOn();
  const double sure = motions.back().covariance(0, 0);
  for (int i = 0; i < 5; ++i) {
    auto step = drive.next();
    step.scan.beams.clear();
    look(step.scan);
    EXPECT_EQ(faultOf(motions.back()), "");
    EXPECT_GT(motions.back().covariance(0, 0), 100 * sure);
  }
  EXPECT_NE(message.find("the last velocity is used meanwhile"), std::string::npos) << message;
  Pose2 truth;
  for (int i = 0; i < 30; ++i) truth = lookOn().truth;
  EXPECT_LT(errorAt(truth), 0.1);
  EXPECT_EQ(source->counters()["unmatched"], 5u);
}

TEST_F(LaserOdometryInARoom, TakesTheWheelsWhileTheLaserIsBlind) {
  use("laser_wheel");
  for (int i = 0; i < 30; ++i) driveOn();
  const auto before = motions.size();
  for (int i = 0; i < 20; ++i) {
    const auto step = drive.next();
    auto blind = step.scan;
    blind.beams.clear();
    turnWheels(step.scan.stamp, step.motion.odometry_end);
    look(blind);
    EXPECT_LT((motions.back().increment.position() - step.motion.increment.position()).norm(),
              1e-6);
  }
  EXPECT_EQ(motions.size(), before + 20);
  EXPECT_NE(message.find("the wheels' motion is used meanwhile"), std::string::npos) << message;
}

TEST_F(LaserOdometryInARoom, SurvivesAndTellsASlipOfTheWheels) {
  use("laser_wheel");
  for (int i = 0; i < 30; ++i) driveOn();
  EXPECT_EQ(message, "");
  Pose2 truth = driveOn(Pose2(0.2, 0.1, 0.3)).truth;
  EXPECT_EQ(source->counters()["slips"], 1u);
  EXPECT_NE(message.find("the wheels tell another motion"), std::string::npos) << message;
  EXPECT_LT(errorAt(truth), 0.03);
  for (int i = 0; i < 10; ++i) truth = driveOn().truth;
  EXPECT_LT(errorAt(truth), 0.03);
  EXPECT_EQ(source->counters()["slips"], 1u);
}

TEST_F(LaserOdometryInARoom, WheelsThatStandStillWhileTheRobotDrivesDoNotHoldIt) {
  use("laser_wheel");
  Pose2 truth;
  for (int i = 0; i < 100; ++i) {
    const auto step = drive.next();
    turnWheels(step.scan.stamp, Pose2());
    look(step.scan);
    truth = step.truth;
  }
  EXPECT_LT(errorAt(truth), 0.06) << "after 10 m";
}

TEST_F(LaserOdometryInARoom, ScansWaitForTheWheelsSoThatTheOrderOfArrivalDoesNotMatter) {
  std::vector<std::vector<Motion>> runs;
  for (const bool wheels_first : {true, false}) {
    use("laser_wheel");
    drive = RoomDrive(1);
    motions.clear();
    for (int i = 0; i < 40; ++i) {
      const auto step = drive.next();
      if (wheels_first) turnWheels(step.scan.stamp, step.motion.odometry_end);
      look(step.scan);
      if (!wheels_first) turnWheels(step.scan.stamp, step.motion.odometry_end);
    }
    runs.push_back(motions);
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t i = 0; i < runs[0].size(); ++i)
    EXPECT_EQ(runs[0][i].increment.vector(), runs[1][i].increment.vector());
}

TEST_F(LaserOdometryInARoom, AScanTurnedOnItsHeadDoesNoHarm) {
  for (int i = 0; i < 30; ++i) lookOn();
  auto turned = drive.next();
  for (auto& beam : turned.scan.beams) beam.bearing = -beam.bearing;
  look(turned.scan);
  EXPECT_EQ(faultOf(motions.back()), "");
  Pose2 truth;
  for (int i = 0; i < 10; ++i) truth = lookOn().truth;
  EXPECT_LT(errorAt(truth), 0.05);
}

TEST_F(LaserOdometryInARoom, PeopleAroundTheRobotDoNotMoveIt) {
  RandomStream people(5, 0);
  Pose2 truth;
  for (int i = 0; i < 100; ++i) {
    auto step = drive.next();
    for (auto& beam : step.scan.beams)
      if (people.uniform() < 0.3) beam.range *= static_cast<float>(0.2 + 0.5 * people.uniform());
    look(step.scan);
    truth = step.truth;
  }
  EXPECT_LT(errorAt(truth), 0.1) << "after 10 m";
}

TEST_F(LaserOdometryInARoom, AStampThatIsFarAheadDoesNotMakeTheRestLate) {
  Pose2 truth;
  for (int i = 0; i < 30; ++i) {
    auto step = drive.next();
    truth = step.truth;
    if (i == 10) step.scan.stamp += std::chrono::seconds(100);
    look(step.scan);
  }
  EXPECT_EQ(motions.size(), 28u);
  EXPECT_EQ(source->counters()["stamp_jump"], 1u);
  EXPECT_EQ(source->counters()["late"], 0u);
  EXPECT_LT(errorAt(truth), 0.03);
}

TEST_F(LaserOdometryInARoom, AFreshStartForgetsAll) {
  for (int i = 0; i < 20; ++i) lookOn();
  const auto first = motions;
  source->reset();
  motions.clear();
  drive = RoomDrive(1);
  for (int i = 0; i < 20; ++i) lookOn();
  ASSERT_EQ(motions.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(motions[i].increment.vector(), first[i].increment.vector());
    EXPECT_EQ(motions[i].covariance, first[i].covariance);
  }
}

TEST(LocalMap, HoldsTheLastMetresOfTheWayAndNoMore) {
  LocalMap map(grid_map::GridMapConfig(), 10.0);
  LaserScan scan;
  for (int i = 0; i < 100; ++i) scan.beams.push_back({0.06f * static_cast<float>(i), 3.0f, true});
  std::size_t largest = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose2 pose(0.5 * i, 0.0, 0.0);
    map.insert(scan_matching::pointsOf(scan, scan_matching::levelModels({}), 0.02), pose);
    if (i == 100) largest = map.bytes();
    const auto& grid = map.view().finest().map;
    EXPECT_FALSE(grid.isEmpty());
    const double metres = 0.05 * grid.rectangle().width;
    ASSERT_LT(metres, 2 * 10.0 + 2 * 3.2 + 4 * 3.2)
        << i << ", with a tile of 3.2 m more on each side";
    if (i < 100) continue;
    ASSERT_LT(map.bytes(), 2 * largest) << i;
  }
}

}  // namespace
}  // namespace slam::laser_odometry
