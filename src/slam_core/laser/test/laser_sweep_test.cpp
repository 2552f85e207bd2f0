// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser/laser_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

LaserSweep sweepOf(std::vector<float> ranges) {
  LaserSweep sweep;
  sweep.frame = "laser";
  sweep.angle_min = -0.2f;
  sweep.angle_increment = 0.1f;
  sweep.angle_max = sweep.angle_min + 0.1f * static_cast<float>(ranges.size() - 1);
  sweep.range_min = 0.1f;
  sweep.range_max = 8.0f;
  sweep.ranges = std::move(ranges);
  return sweep;
}

LaserMount mountOf(double x, double y, double roll, double pitch, double yaw) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  LaserMount mount{"laser", Eigen::Isometry3d::Identity()};
  mount.T_base_laser = Eigen::Translation3d(x, y, 0.3) * AngleAxisd(yaw, Vector3d::UnitZ()) *
                       AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX());
  return mount;
}

/// Where a beam ends in the robot's plane.
Eigen::Vector2d endOf(const LaserScan& scan, std::size_t beam) {
  return scan.sensor_pose.transform(scan.beams[beam].end());
}

TEST(LaserSweep, KeepsWhatIsMeasuredInItsOrder) {
  const auto scan = toScan(sweepOf({1, 2, 3}), LaserMount());
  ASSERT_EQ(scan.beams.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(scan.beams[i].bearing, -0.2 + 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(scan.beams[i].range, static_cast<float>(i + 1));
    EXPECT_TRUE(scan.beams[i].hit);
  }
}

TEST(LaserSweep, LeavesOutWhatTellsNothing) {
  const auto scan = toScan(sweepOf({kNan, -kInf, 0.0f, -1.0f, 0.05f, 4.0f}), LaserMount());
  ASSERT_EQ(scan.beams.size(), 1u);
  EXPECT_EQ(scan.beams[0].range, 4.0f);
  EXPECT_NEAR(scan.beams[0].bearing, 0.3, 1e-6) << "of its own place in the sweep";
}

TEST(LaserSweep, IntensitiesStayWithTheirBeams) {
  auto sweep = sweepOf({kNan, 2, 3});
  sweep.intensities = {7, 8, kNan};
  const auto scan = toScan(sweep, LaserMount());
  ASSERT_EQ(scan.beams.size(), 2u);
  EXPECT_EQ(scan.beams[0].intensity, 8.0f);
  EXPECT_EQ(scan.beams[1].intensity, 0.0f) << "what is not a number tells nothing";
  sweep.intensities.pop_back();
  EXPECT_EQ(faultOf(sweep), "") << "ranges are good without";
  EXPECT_EQ(toScan(sweep, LaserMount()).beams[0].intensity, 0.0f);
}

TEST(LaserSweep, ABeamThatMetNothingReachesAsFarAsTheLaserSees) {
  const auto scan = toScan(sweepOf({kInf, 8.01f, 8.0f}), LaserMount());
  ASSERT_EQ(scan.beams.size(), 3u);
  for (const auto& beam : scan.beams) EXPECT_EQ(beam.range, 8.0f);
  EXPECT_FALSE(scan.beams[0].hit);
  EXPECT_FALSE(scan.beams[1].hit);
  EXPECT_TRUE(scan.beams[2].hit) << "the maximum itself is a measurement (REP-117)";
}

TEST(LaserSweep, TheMountOffTheCentreGoesIntoTheSensorPose) {
  const auto scan = toScan(sweepOf({1, 1, 1}), mountOf(0.4, -0.1, 0, 0, M_PI / 2));
  EXPECT_LT((scan.sensor_pose.vector() - Eigen::Vector3d(0.4, -0.1, M_PI / 2)).norm(), 1e-12);
  EXPECT_NEAR(endOf(scan, 2).x(), 0.4, 1e-6);
  EXPECT_NEAR(endOf(scan, 2).y(), 0.9, 1e-6);
}

TEST(LaserSweep, AnUpsideDownLaserSeesTheOtherWayRound) {
  for (const auto& [roll, pitch, yaw] : {std::tuple{M_PI, 0.0, 0.3}, {0.0, M_PI, 0.3}}) {
    const auto mount = mountOf(0.2, 0.0, roll, pitch, yaw);
    const auto sweep = sweepOf({1, 2, 3});
    const auto scan = toScan(sweep, mount);
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = -0.2 + 0.1 * static_cast<double>(i);
      const Eigen::Vector3d in_space =
          mount.T_base_laser * (sweep.ranges[i] * Eigen::Vector3d(cos(angle), sin(angle), 0.0));
      EXPECT_LT((endOf(scan, i) - in_space.head<2>()).norm(), 1e-6) << "beam " << i;
    }
  }
}

TEST(LaserSweep, MayRunClockwise) {
  auto sweep = sweepOf({1, 2, 3});
  std::swap(sweep.angle_min, sweep.angle_max);
  sweep.angle_increment = -0.1f;
  EXPECT_EQ(faultOf(sweep), "");
  for (const double roll : {0.0, M_PI}) {
    const auto mount = mountOf(0.2, 0.1, roll, 0, 0.3);
    const auto forth = toScan(sweepOf({3, 2, 1}), mount), back = toScan(sweep, mount);
    ASSERT_EQ(back.beams.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT((endOf(back, i) - endOf(forth, 2 - i)).norm(), 1e-6) << "beam " << i;
  }
}

TEST(LaserSweep, ASidewaysMountIsRefused) {
  EXPECT_EQ(faultOf(mountOf(0, 0, 0.05, 0, 1)), "");
  EXPECT_EQ(faultOf(mountOf(0, 0, M_PI - 0.05, 0, 1)), "");
  EXPECT_NE(faultOf(mountOf(0, 0, M_PI / 2, 0, 0)).find("not horizontal"), std::string::npos);
  EXPECT_NE(faultOf(mountOf(0, 0, 0, 0.3, 0)).find("tilted by 0.30 rad"), std::string::npos);
  auto mount = mountOf(0, 0, 0, 0, 0);
  mount.T_base_laser.matrix()(0, 3) = kNan;
  EXPECT_NE(faultOf(mount).find("not a number"), std::string::npos);
}

TEST(LaserSweep, SaysWhyItCannotBeUsed) {
  const auto faultWith = [](auto change) {
    auto sweep = sweepOf({1, 2, 3, 4, 5});
    EXPECT_EQ(faultOf(sweep), "");
    change(sweep);
    return faultOf(sweep);
  };
  const auto expect = [&](auto change, const std::string& words) {
    const auto fault = faultWith(change);
    EXPECT_NE(fault.find(words), std::string::npos) << words << ": " << fault;
  };
  expect([](auto& s) { s.ranges.clear(); }, "no ranges");
  expect([](auto& s) { s.ranges.resize(9); }, "it has 9 ranges, while its angles tell 5");
  expect([](auto& s) { s.angle_increment = 0.0f; }, "angle_increment is 0");
  expect([](auto& s) { s.angle_increment = -0.1f; },
         "its angles run from -0.2 to 0.2 and its angle_increment of -0.1 the other way");
  expect([](auto& s) { s.angle_increment = kNan; }, "angle_increment is nan");
  expect([](auto& s) { s.angle_min = kNan; }, "angle_min");
  expect([](auto& s) { s.range_min = kNan; }, "range_min");
  expect([](auto& s) { s.range_max = kInf; }, "range_max");
  expect([](auto& s) { s.range_max = 0.05f; }, "range_max is 0.05");
}

TEST(LaserSweep, DriversMayCountTheirLastAngleInOrOut) {
  auto sweep = sweepOf({1, 2, 3, 4, 5});
  sweep.angle_max += sweep.angle_increment;
  EXPECT_EQ(faultOf(sweep), "");
}

}  // namespace
}  // namespace slam
