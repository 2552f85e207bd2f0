// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/laser_reflectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/laser_landmarks/test/simulated_walls.hpp"

namespace slam::laser_landmarks {
namespace {

using test::simulatedRoom;
using test::SimulatedWall;

constexpr double kRetro = 3000.0;  // brightness of a reflector; that of walls is 100

class LaserReflectorsTest : public testing::Test {
 protected:
  LaserReflectorsTest() { detector_.configure(LaserReflectorsConfig()); }

  const std::vector<LandmarkObservation>& see(const LaserScan& scan) {
    detector_.set(scan);
    EXPECT_TRUE(detector_.execute().isOk());
    for (const auto& z : detector_.observations()->observations) EXPECT_EQ(faultOf(z), "");
    return detector_.observations()->observations;
  }
  LaserScan scanOf(std::vector<SimulatedWall> walls, const Pose2& sensor = Pose2()) {
    for (const auto& wall : simulatedRoom()) walls.push_back(wall);
    return scanOfWalls(walls, sensor, {0.02, 0.003}, random_);
  }
  /// A flat reflector, 1 mm in front of the wall ahead.
  static SimulatedWall onTheWall(double y, double width, double brightness = kRetro) {
    return {{3.999, y - width / 2}, {3.999, y + width / 2}, brightness};
  }
  std::size_t counted(const std::string& reason) {
    const auto all = detector_.counters().all();
    const auto found = all.find(reason);
    return found == all.end() ? 0 : found->second;
  }

  LaserReflectors detector_;
  RandomStream random_{1, 0};
};

TEST_F(LaserReflectorsTest, SeesReflectorsOnAWallByTheirIntensity) {
  const auto& found = see(scanOf({onTheWall(0.5, 0.2), onTheWall(-1.0, 0.2)}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].bearing, std::atan2(-1.0, 4.0), 0.01);
  EXPECT_NEAR(found[0].range, std::hypot(1.0, 4.0), 0.05);
  EXPECT_NEAR(found[1].bearing, std::atan2(0.5, 4.0), 0.01);
  EXPECT_EQ(found[0].id, kUnknownId);
  EXPECT_TRUE(detector_.counters().all().empty());
}

TEST_F(LaserReflectorsTest, AFarReflectorIsComparedWithWhatAWallWouldSendFromThere) {
  const Pose2 near_a_wall(-3.8, 0, 0);  // which is 1500 times as bright as the reflector's wall
  const auto scan = scanOf({onTheWall(0.5, 0.3, kRetro / 2)}, near_a_wall);
  EXPECT_EQ(see(scan).size(), 1u);
  LaserReflectorsConfig config;
  config.range_exponent = 0.0;
  detector_.configure(config);
  EXPECT_TRUE(see(scan).empty()) << "as a plain threshold has it";
}

TEST_F(LaserReflectorsTest, WhatIsHardlyBrighterThanAWallIsNone) {
  EXPECT_TRUE(see(scanOf({onTheWall(0.5, 0.2, 250.0)})).empty());
}

TEST_F(LaserReflectorsTest, ALaserThatTellsReflectorsOnlyIsUnderstood) {
  auto scan = scanOf({onTheWall(0.5, 0.2)});
  for (auto& beam : scan.beams) beam.intensity = beam.intensity > 50.0f ? 1.0f : 0.0f;
  EXPECT_EQ(see(scan).size(), 1u);
}

TEST_F(LaserReflectorsTest, TheLandmarkOfACylinderIsItsAxis) {
  LaserReflectorsConfig config;
  config.radius = 0.2;
  detector_.configure(config);
  std::vector<SimulatedWall> walls;
  const auto corner = [](int side) -> Eigen::Vector2d {
    return {2.0 + 0.2 * std::cos(M_PI * side / 16), 1.0 + 0.2 * std::sin(M_PI * side / 16)};
  };
  for (int side = 0; side < 32; ++side) walls.push_back({corner(side), corner(side + 1), kRetro});
  const auto& found = see(scanOf(walls));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].range, std::hypot(2.0, 1.0), 0.02);
  EXPECT_NEAR(found[0].bearing, std::atan2(1.0, 2.0), 0.01);
}

TEST_F(LaserReflectorsTest, WhatIsTooWideOrTooFarIsNone) {
  EXPECT_TRUE(see(scanOf({onTheWall(0.0, 1.5)})).empty()) << "a window, a mirror";
  EXPECT_EQ(counted("too_wide"), 1u);
  LaserReflectorsConfig config;
  config.min_width = 0.3;
  detector_.configure(config);
  EXPECT_TRUE(see(scanOf({onTheWall(0.0, 0.1)})).empty());
  EXPECT_EQ(counted("too_narrow"), 1u);
  config = {};
  config.max_range = 3.0;
  detector_.configure(config);
  EXPECT_TRUE(see(scanOf({onTheWall(0.0, 0.2)})).empty());
}

TEST_F(LaserReflectorsTest, WhatMayBeHiddenOrCutOffIsNone) {
  const SimulatedWall pillar{{2.0, 0.0}, {2.0, 0.5}};
  EXPECT_TRUE(see(scanOf({onTheWall(0.0, 0.3), pillar})).empty());
  EXPECT_EQ(counted("hidden"), 1u);
  auto scan = scanOf({onTheWall(0.0, 0.3)});
  scan.beams.erase(scan.beams.begin() + 360);
  EXPECT_TRUE(see(scan).empty()) << "a beam in its middle told nothing";
  EXPECT_EQ(counted("cut_off"), 2u);
}

TEST_F(LaserReflectorsTest, IsAsWrongAsItSays) {
  double nees = 0.0;
  int seen = 0;
  for (int view = 0; view < 1000; ++view) {
    const Pose2 sensor(4.0 * random_.uniform() - 3.0, 2.0 * random_.uniform() - 1.0, 0.002 * view);
    const Eigen::Vector2d place = sensor.inverse().transform({3.999, 0.3});
    for (const auto& z : see(scanOf({onTheWall(0.3, 0.2)}, sensor))) {
      const Eigen::Vector2d error(z.range - place.norm(),
                                  z.bearing - std::atan2(place.y(), place.x()));
      nees += error.dot(z.covariance.inverse() * error);
      ++seen;
    }
  }
  EXPECT_GT(seen, 900);
  EXPECT_LT(nees / seen, 2.6);
  EXPECT_GT(nees / seen, 1.2);
}

TEST_F(LaserReflectorsTest, ALaserWithoutIntensitiesIsWorthAWord) {
  auto scan = scanOf({});
  for (auto& beam : scan.beams) beam.intensity = 0.0f;
  Status status;
  for (int i = 0; i < 60; ++i) {
    detector_.set(scan);
    status = detector_.execute();
    EXPECT_TRUE(detector_.observations()) << "it moves time on";
  }
  EXPECT_NE(status.message.find("told no intensity"), std::string::npos) << status.message;
  see(scanOf({}));
  detector_.set(scan);
  EXPECT_TRUE(detector_.execute().isOk()) << "it has told some";
}

TEST_F(LaserReflectorsTest, RefusesLimitsThatNothingMeets) {
  LaserReflectorsConfig config;
  config.min_width = 1.0;
  try {
    detector_.configure(config);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("less than laser_reflectors.max_width"),
              std::string::npos);
  }
}

TEST(LaserReflectors, IsADetectorByName) {
  EXPECT_NE(Registry<LandmarkDetector>::instance().create("laser_reflectors"), nullptr);
}

}  // namespace
}  // namespace slam::laser_landmarks
