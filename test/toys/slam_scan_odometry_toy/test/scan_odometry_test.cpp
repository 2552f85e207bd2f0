// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"
#include "slam_scan_odometry_toy/scan_alignment.hpp"

namespace slam_toy {
namespace {

class ScanOdometryTest : public testing::Test {
 protected:
  ScanOdometryTest() {
    slam::Settings settings({}, {}, {});
    odometry_->configure(settings);
  }
  const std::optional<slam::Motion>& after(const slam::LaserScan& scan) {
    inputs_.set(scan);
    odometry_->execute();
    return odometry_->motion();
  }

  std::unique_ptr<slam::OdometrySource> odometry_ =
      slam::Registry<slam::OdometrySource>::instance().create("scan_toy");
  slam::test::ComponentDriver inputs_{*odometry_};
};

TEST_F(ScanOdometryTest, TellsHowTheRobotMovedBetweenScansWithACovarianceToMatch) {
  slam::test::RoomDrive drive(1);
  slam::Pose2 before;
  double nees = 0.0;
  int count = 0;
  for (int i = 0; i < 145; ++i) {  // a lap
    const auto step = drive.next();
    const auto& motion = after(step.scan);
    ASSERT_EQ(motion.has_value(), i > 0);
    if (motion) {
      EXPECT_EQ(slam::faultOf(*motion), "");
      EXPECT_EQ(motion->end, step.scan.stamp);
      const auto truth = before.between(step.truth);
      EXPECT_LT((motion->increment.vector() - truth.vector()).norm(), 0.05);
      nees += slam::test::nees(truth, motion->increment, motion->covariance);
      ++count;
    }
    before = step.truth;
  }
  EXPECT_EQ(odometry_->counters()["coasted"], 0U);
  // 3 expected; neighbouring scans share an error, and the covariance is on the safe side
  EXPECT_GT(nees / count, 0.3);
  EXPECT_LT(nees / count, 3.5);
}

TEST_F(ScanOdometryTest, GoesOnAtItsVelocityWhereAScanTellsNothing) {
  slam::test::RoomDrive drive(2);
  for (int i = 0; i < 10; ++i) after(drive.next().scan);
  const auto known = *odometry_->motion();
  auto blind = drive.next().scan;
  blind.beams.clear();
  const auto assumed = after(blind);
  ASSERT_TRUE(assumed);
  EXPECT_LT((assumed->increment.vector() - known.increment.vector()).norm(), 1e-9);
  EXPECT_GT(assumed->covariance(0, 0), 10 * known.covariance(0, 0));
  EXPECT_EQ(slam::faultOf(*assumed), "");
  EXPECT_EQ(odometry_->counters()["coasted"], 1U);
}

TEST_F(ScanOdometryTest, LeavesOutAScanThatIsLate) {
  slam::test::RoomDrive drive(3);
  const auto first = drive.next().scan, second = drive.next().scan;
  after(second);
  EXPECT_FALSE(after(first));
  EXPECT_FALSE(after(second));
  EXPECT_EQ(odometry_->counters()["late"], 2U);
  const auto motion = after(drive.next().scan);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->start, second.stamp);
}

TEST(ScanAlignment, RefusesWallsThatLeaveADirectionOpen) {
  Points corridor;
  for (int i = 0; i < 100; ++i) corridor.emplace_back(0.1 * i, -1.0);
  for (int i = 0; i < 100; ++i) corridor.emplace_back(10.0 - 0.1 * i, 1.0);
  EXPECT_FALSE(align(corridor, corridor, {}));
  EXPECT_FALSE(align({}, corridor, {}));
  EXPECT_FALSE(align(corridor, {}, {}));
}

TEST(ScanAlignment, TakesPointsOfWhatWasMetInTheRobotsFrame) {
  slam::LaserScan scan;
  scan.sensor_pose = slam::Pose2(1, 2, M_PI / 2);
  scan.beams = {{0.0f, 3.0f, true}, {0.1f, 8.0f, false}};
  const auto points = pointsOf(scan);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT((points[0] - Eigen::Vector2d(1, 5)).norm(), 1e-6);
  EXPECT_TRUE(pointsOf({}).empty());
}

}  // namespace
}  // namespace slam_toy
