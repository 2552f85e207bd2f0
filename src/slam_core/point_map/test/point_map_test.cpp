// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/point_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/point_map/pcd_file.hpp"
#include "slam_core/point_map/test/room.hpp"

namespace slam::point_map {
namespace {

Settings settingsWith(const std::vector<std::string>& overrides) {
  return {
      {"product", YAML::Load("{version: 1}")}, {"robot", YAML::Load("{version: 1}")}, overrides};
}

class PointMapTest : public testing::Test {
 protected:
  void configure(const std::vector<std::string>& overrides = {}) {
    auto settings = settingsWith(overrides);
    map.configure(settings);
    count = 0;
  }
  /// A scan with the filter's pose at its very stamp.
  Status take(const LaserScan& scan, const Pose2& T_map_base, double begin = 0.0) {
    const auto start = Stamp(durationFromSeconds(begin + 0.1 * static_cast<double>(count)));
    Motion motion;
    motion.sequence = count;
    motion.start = start;
    motion.end = start + std::chrono::milliseconds(100);
    motion.covariance = Eigen::Matrix3d::Identity() * 1e-4;
    map.set(motion);
    map.set(FilterPose::of(motion.end, T_map_base));
    auto stamped = scan;
    stamped.stamp = motion.end;
    stamped.sequence = count++;
    map.set(stamped);
    Status last = Status::ok();
    do {
      const auto status = map.execute();
      if (!status.isOk()) last = status;
    } while (map.isBusy());
    return last;
  }
  static LaserScan beam(float range, bool hit = true) {
    LaserScan scan;
    scan.beams = {{0.0f, range, hit}};
    return scan;
  }
  /// Mean distance of the points from the true walls [m], each weighted by its end points.
  double thickness(const test::Room& room) const {
    double sum = 0.0, weights = 0.0;
    for (const auto& [position, weight] : map.points()) {
      sum += weight * room.distance(position);
      weights += weight;
    }
    return sum / weights;
  }
  /// Drives through a room, the filter's poses off by their errors.
  double thicknessAfterDrive(const test::Room& room) {
    RandomStream random(7, 0);
    for (int i = 0; i < 60; ++i) {
      const Pose2 truth(1.5 + 0.05 * i, 2.0, 0.1 * i);
      const Pose2 error = i == 0 ? Pose2()
                                 : Pose2(0.05 * random.gaussian(), 0.05 * random.gaussian(),
                                         0.02 * random.gaussian());
      take(room.scan(truth, 0.005, &random), truth * error);
    }
    return thickness(room);
  }

  PointMap map;
  std::uint64_t count = 0;
};

TEST_F(PointMapTest, FusesEndPointsWithinTheDistanceAndAppendsOthers) {
  configure({"point_map.fusion_distance=0.1"});
  take(beam(2.0f), {});
  take(beam(2.06f), {});
  take(beam(2.2f), {});
  ASSERT_EQ(map.points().size(), 2u);
  EXPECT_NEAR(map.points()[0].position.x(), 2.03, 1e-6) << "their mean";
  EXPECT_EQ(map.points()[0].count, 2u);
  EXPECT_EQ(map.points()[1].count, 1u);
}

TEST_F(PointMapTest, PutsEndPointsWhereRobotAndMountTell) {
  configure();
  auto scan = beam(2.0f);
  scan.sensor_pose = {0.5, 0.0, M_PI / 2};
  take(scan, {10, 20, M_PI / 2});
  ASSERT_EQ(map.points().size(), 1u);
  EXPECT_LT((map.points()[0].position - Eigen::Vector2d(8.0, 20.5)).norm(), 1e-6);
}

TEST_F(PointMapTest, ABeamThatMetNothingMakesNoPoint) {
  configure();
  take(beam(2.0f, false), {});
  EXPECT_TRUE(map.points().empty());
}

TEST_F(PointMapTest, AlignedScansMakeThinnerWalls) {
  const test::Room room(6, 4);
  configure({"point_map.fusion=euclidean"});
  const double euclidean = thicknessAfterDrive(room);
  configure({"point_map.fusion=aligned"});
  const double aligned = thicknessAfterDrive(room);
  EXPECT_GT(euclidean, 0.02) << "the filter's errors are in it";
  EXPECT_LT(aligned, 0.4 * euclidean);
}

TEST_F(PointMapTest, AScanThatCannotBeAlignedIsPutWhereTheFilterTells) {
  const test::Room room(6, 4);
  configure({"point_map.fusion=aligned"});
  const Pose2 error(0.05, -0.05, 0.03), truth(2.0, 2.0, 0.0), far(30.0, 1.0, 0.5);
  take(room.scan(truth), truth);
  for (int i = 0; i < 3; ++i) take(room.scan(truth), error * truth);
  EXPECT_LT(thickness(room), 0.01) << "these are";
  take(beam(2.0f), far);
  const Eigen::Vector2d expected = far.transform(Eigen::Vector2d(2.0, 0.0));
  EXPECT_LT((map.points().back().position - expected).norm(), 1e-6);
}

TEST_F(PointMapTest, TheSameInputTwiceGivesTheSameFile) {
  std::string first;
  for (const auto* fusion : {"point_map.fusion=euclidean", "point_map.fusion=aligned"}) {
    configure({fusion});
    thicknessAfterDrive(test::Room(6, 4));
    first = toPcd(map.points());
    map.reset();
    EXPECT_TRUE(map.points().empty());
    count = 0;
    thicknessAfterDrive(test::Room(6, 4));
    EXPECT_EQ(toPcd(map.points()), first) << fusion;
  }
}

TEST_F(PointMapTest, IsBoundedAndSaysWhenItIsFull) {
  configure({"point_map.max_points=50"});
  const auto status = take(test::Room(6, 4).scan({3, 2, 0}), {3, 2, 0});
  EXPECT_EQ(map.points().size(), 50u);
  EXPECT_NE(status.message.find("full with 50 points"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("point_map.max_points"), std::string::npos) << status.message;
  EXPECT_GT(map.counters()["full"], 100u);
}

TEST_F(PointMapTest, LeavesOutInputsThatAreNone) {
  configure();
  Motion motion;
  map.set(motion);
  EXPECT_FALSE(map.execute().isOk());
  map.set(FilterPose{Stamp(), std::numeric_limits<double>::quiet_NaN(), 0, 0, 1});
  EXPECT_NE(map.execute().message.find("pose"), std::string::npos);
  EXPECT_EQ(map.counters()["invalid_motion"], 1u);
  EXPECT_EQ(map.counters()["invalid_pose"], 1u);
}

TEST_F(PointMapTest, CrossesAGapOfLostMotionByTheOdometrysPoses) {
  const auto mapped = [this](bool is_cut, bool is_restarted = false) {
    configure();
    const auto at = [](int i) { return Stamp(i * std::chrono::milliseconds(100)); };
    Pose2 odometry(3, 4, 1);
    map.set(FilterPose::of(at(0), Pose2()));
    for (int i = 0; i < 30; ++i) {
      Motion motion;
      motion.sequence = static_cast<std::uint64_t>(is_restarted && i > 20 ? i - 21 : i);
      motion.start = at(i);
      motion.end = at(i + 1);
      motion.increment = Pose2::exp({0.1, 0.0, 0.03});
      motion.covariance = Eigen::Matrix3d::Identity() * 1e-4;
      motion.odometry_start = odometry;
      motion.odometry_end = odometry = odometry * motion.increment;
      if (!is_cut || i < 5 || i > 20) map.set(motion);
    }
    auto scan = beam(2.0f);
    scan.stamp = at(25);
    map.set(scan);
    map.set(FilterPose::of(at(30), Pose2()));
    EXPECT_TRUE(map.execute().isOk());
    return map.points();
  };
  const auto complete = mapped(false), bridged = mapped(true);
  EXPECT_EQ(map.counters()["bridged"], 1u);
  ASSERT_EQ(complete.size(), 1u);
  ASSERT_EQ(bridged.size(), 1u);
  EXPECT_LT((bridged[0].position - complete[0].position).norm(), 1e-9);
  const auto restarted = mapped(true, true);
  EXPECT_EQ(map.counters()["bridged"], 1u);
  ASSERT_EQ(restarted.size(), 1u);
  EXPECT_LT((restarted[0].position - complete[0].position).norm(), 1e-9) << "it counts from 0";
}

TEST_F(PointMapTest, BeginsAnewWhenTimeGoesBack) {
  configure();
  for (int i = 0; i < 3; ++i) take(beam(2.0f), {}, 100.0);
  const auto revision = map.revision();
  for (int i = 0; i < 3; ++i) take(beam(5.0f), {}, 10.0);
  ASSERT_EQ(map.points().size(), 1u);
  EXPECT_NEAR(map.points()[0].position.x(), 5.0, 1e-6);
  EXPECT_GT(map.revision(), revision);
}

TEST_F(PointMapTest, ListsTheFaultsOfItsSection) {
  const auto faults = slam::test::faultsOf([&] {
    configure({"point_map.fusion=icp", "point_map.fusion_distance=0", "point_map.radius=1"});
  });
  EXPECT_TRUE(slam::test::oneSays(faults, {"point_map.fusion", "euclidean"}));
  EXPECT_TRUE(slam::test::oneSays(faults, {"point_map.fusion_distance"}));
  EXPECT_TRUE(slam::test::oneSays(faults, {"point_map.radius", "unknown"}));
}

TEST(PcdFile, HoldsAHeaderAndALineForEachPoint) {
  std::istringstream text(toPcd({{{1.5, -2.25}, 3}, {{-0.0, 0.0}, 1}}));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 13u);
  EXPECT_EQ(lines[1], "VERSION 0.7");
  EXPECT_EQ(lines[6], "WIDTH 2");
  EXPECT_EQ(lines[9], "POINTS 2");
  EXPECT_EQ(lines[11], "1.500000 -2.250000 0 3");
  EXPECT_EQ(lines[12], "0.000000 0.000000 0 1");
}

}  // namespace
}  // namespace slam::point_map
