// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/product/data_flow.hpp"
#include "slam_core/product/test/product_run.hpp"

namespace slam {
namespace {

using test::faultsOfWords;
using test::oneSays;
using Overrides = std::vector<std::string>;

const Overrides kScanGrid = {"backend=grid", "map=grid", "odometry=wheel", "detector=none"};

Overrides adding(Overrides words, const std::string& more) {
  words.push_back(more);
  return words;
}

Stamp laserStamp(int milliseconds) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(milliseconds);
}

/// A robot that drives round the box of a room, with two lasers of 180 degrees back to back. The
/// rear one sees between the scans of the front one.
class RearLaser : public testing::Test, protected test::ProductRun {
 protected:
  void configure(const Overrides& overrides) {
    ProductRun::configure(overrides);
    know("scan", T_base_front);
    if (findPort(coordinator.wiring().ports().open(), "rear_scan", kindOf<LaserSweep>()) != nullptr)
      know("rear_scan", T_base_rear);
  }
  void know(const std::string& laser, const Pose2& pose) {
    LaserMount mount{frameOf(laser), Eigen::Isometry3d::Identity()};
    mount.T_base_laser.translation().head<2>() = pose.position();
    mount.T_base_laser.linear().topLeftCorner<2, 2>() = pose.rotation();
    coordinator.put(laser, mount);
  }
  std::string frameOf(const std::string& laser) const { return has_one_frame ? "laser" : laser; }
  /// The robot's pose in the frame of its first one.
  static Pose2 truth(int milliseconds) {
    const double way = 0.5e-3 * std::max(0, milliseconds - 500);  // it stands at first
    return Pose2::exp({way, 0.0, way / 2.3});
  }
  void look(const std::string& laser, const Pose2& T_base_laser, int milliseconds) {
    constexpr int kBeams = 181;
    const Pose2 at = test::RoomDrive::start() * truth(milliseconds) * T_base_laser;
    LaserSweep sweep;
    sweep.stamp = laserStamp(milliseconds);
    sweep.frame = frameOf(laser);
    sweep.angle_min = static_cast<float>(-M_PI / 2);
    sweep.angle_max = static_cast<float>(M_PI / 2);
    sweep.angle_increment = static_cast<float>(M_PI / (kBeams - 1));
    sweep.range_max = 8.0f;
    for (int i = 0; i < kBeams; ++i) {
      const double bearing = M_PI * (i / (kBeams - 1.0) - 0.5);
      sweep.ranges.push_back(static_cast<float>(room.range(at.position(), at.theta() + bearing)));
    }
    coordinator.put(laser, sweep);
    drain();
  }
  void drive(int from, int until) {
    for (int time = from; time < until; time += 10) {
      if (time % 50 == 0 && has_wheels) roll(time);
      if (time % 100 == 10 && has_front) look("scan", T_base_front, time);
      if (time % 100 == 60 && has_rear) look("rear_scan", T_base_rear, time);
    }
  }
  void roll(int time) {
    OdometrySample sample;
    sample.stamp = laserStamp(time);
    sample.pose = truth(time);
    coordinator.set(sample);
    drain();
  }
  OccupancyGrid grid() const {
    return *coordinator.estimator().capabilities().find<GridMapper>()->grid();
  }
  /// Cells of the map that are known.
  long known() const {
    const auto cells = grid().cells;
    return std::count_if(cells.begin(), cells.end(), [](int cell) { return cell >= 0; });
  }
  double errorOfPose() const {
    const auto& last = reports.back();
    const auto time =
        std::chrono::duration_cast<std::chrono::milliseconds>(last.stamp - laserStamp(0));
    return (last.pose.pose.position() - truth(static_cast<int>(time.count())).position()).norm();
  }

  const Pose2 T_base_front{0.2, 0.0, 0.0}, T_base_rear{-0.2, 0.05, 3.0};
  test::Room room;
  bool has_front = true, has_rear = true, has_wheels = true, has_one_frame = false;
};

TEST_F(RearLaser, OfAProductIsAnInputOfItsMapsAndOfNobodyElse) {
  configure(adding(adding({"backend=graph", "map=grid", "odometry=laser_wheel",
                           "detector=laser_corners", "association=nearest"},
                          "pointmap=true"),
                   "rear_laser=true"));
  const DataFlow flow(coordinator.components());
  for (const auto& part : flow.parts()) {
    const bool sees_both = part.is_backend || part.isModule();
    EXPECT_NE(part.input("scan", kindOf<LaserSweep>()), nullptr) << part.key;
    EXPECT_EQ(part.input("rear_scan", kindOf<LaserSweep>()) != nullptr, sees_both) << part.key;
    const auto motions = std::count_if(part.inputs.begin(), part.inputs.end(),
                                       [](const auto& input) { return input.name == "motion"; });
    EXPECT_EQ(motions, sees_both ? 1 : 0) << part.key;
  }
}

TEST_F(RearLaser, BringsABetterMap) {
  configure(kScanGrid);
  drive(0, 9000);
  const auto with_one = known();
  const double error_with_one = errorOfPose();
  const auto right_with_one = test::shareOnWalls(grid(), room);
  coordinator = MetaCoordinator();
  reports.clear();
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 9000);
  EXPECT_GT(known(), 1.02 * static_cast<double>(with_one));
  EXPECT_LT(errorOfPose(), error_with_one + 0.01);
  EXPECT_GT(test::shareOnWalls(grid(), room), right_with_one - 0.02);
  EXPECT_TRUE(sentences.empty()) << sentences.front();
}

TEST_F(RearLaser, SeesWhatIsBehindWhileTheRobotStands) {
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 500);
  const auto map = grid();
  const auto occupied = [&](double x, double y) {
    const Eigen::Vector2d at = (Eigen::Vector2d(x, y) - map.origin) / map.resolution;
    int most = -1;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto column = static_cast<std::size_t>(at.x() + dx);
        const auto row = static_cast<std::size_t>(at.y() + dy);
        if (column < map.width && row < map.height)
          most = std::max<int>(most, map.cells[row * map.width + column]);
      }
    return most > 50;
  };
  const double wall = -4.0 - test::RoomDrive::start().y();
  EXPECT_TRUE(occupied(-1.5, wall)) << "behind the robot";
  EXPECT_TRUE(occupied(1.5, wall)) << "ahead";
}

TEST_F(RearLaser, ThatDiesDoesNotStopTheMap) {
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 2000);
  has_rear = false;
  drive(2000, 5000);
  EXPECT_GE(reports.back().stamp, laserStamp(4800));
  EXPECT_TRUE(oneSays(sentences, {"the rear laser has sent no scan since"}));
  EXPECT_GT(coordinator.counters()["joined_scan_front_alone"], 20u);
}

TEST_F(RearLaser, GoesOnAloneWhereTheFrontOneDies) {
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 2000);
  has_front = false;
  drive(2000, 5000);
  EXPECT_GE(reports.back().stamp, laserStamp(4800));
  EXPECT_TRUE(oneSays(sentences, {"the front laser has sent no scan since"}));
  EXPECT_LT(errorOfPose(), 0.05);
}

TEST_F(RearLaser, SaysWhereScansWaitForOdometryThatDoesNotCome) {
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 2000);
  has_wheels = false;
  drive(2000, 4500);
  EXPECT_TRUE(sentences.empty()) << sentences.front();
  drive(4500, 6000);
  EXPECT_TRUE(oneSays(sentences, {"no update: laser scans since", "wait for motion"}));
}

TEST_F(RearLaser, WithTheFrameOfTheFrontOneIsLeftOut) {
  has_one_frame = true;
  configure(adding(kScanGrid, "rear_laser=true"));
  know("rear_scan", T_base_front);  // by the frame
  drive(0, 9000);
  EXPECT_TRUE(oneSays(sentences, {"both lasers have the frame 'laser'", "a frame_id of its own"}));
  EXPECT_GE(coordinator.counters()["joined_scan_same_mount"], 88u);
  EXPECT_LT(errorOfPose(), 0.05);
  EXPECT_GT(test::shareOnWalls(grid(), room), 0.9);
}

TEST_F(RearLaser, WithoutAMountDoesNotStopTheMap) {
  Settings settings({}, {}, adding(kScanGrid, "rear_laser=true"));
  coordinator.configure(settings);
  know("scan", T_base_front);
  drive(0, 4000);
  EXPECT_GE(reports.back().stamp, laserStamp(3800));
  EXPECT_TRUE(oneSays(sentences, {"'rear_scan' is mounted", "rear_scan.sensor_pose"}));
  EXPECT_GT(heldAtGates(coordinator.wiring())["rear_scan_no_mount"], 0u);
}

TEST_F(RearLaser, HasAMountInTheRobotFile) {
  Settings settings({}, {},
                    adding(adding(kScanGrid, "rear_laser=true"),
                           "rear_scan.sensor_pose=[-0.2, 0.05, 0, 0, 0, 3]"));
  coordinator.configure(settings);
  know("scan", T_base_front);
  drive(0, 3000);
  EXPECT_TRUE(sentences.empty());
  EXPECT_LT(errorOfPose(), 0.05);
}

TEST_F(RearLaser, ThatNobodySaysIsThereChangesNothing) {
  configure(kScanGrid);
  for (const auto& gate : coordinator.wiring().gates()) EXPECT_EQ(gate->name(), "laser");
  EXPECT_EQ(findPort(coordinator.wiring().ports().open(), "rear_scan", kindOf<LaserSweep>()),
            nullptr);
}

TEST_F(RearLaser, GoesOnFromASavedState) {
  configure(adding(kScanGrid, "rear_laser=true"));
  drive(0, 2000);
  const auto state = stateOf(coordinator);
  drive(2000, 3000);
  const auto whole = reports.back().pose.pose.vector();
  coordinator = MetaCoordinator();
  Settings settings({}, {}, adding(kScanGrid, "rear_laser=true"));
  coordinator.configure(settings);
  restore(state, coordinator);
  drive(2000, 3000);
  EXPECT_EQ(reports.back().pose.pose.vector(), whole);
}

TEST(RearLaserConfig, IsRefusedWithoutMotionBetweenTheStamps) {
  EXPECT_TRUE(
      oneSays(faultsOfWords({"backend=grid", "map=grid", "odometry=none", "rear_laser=true"}),
              {"rear_laser", "odometry: none"}));
}

TEST(RearLaserConfig, IsRefusedWhereNobodyMakesAMapOfScans) {
  EXPECT_TRUE(oneSays(faultsOfWords({"backend=ekf", "detector=laser_trunks", "association=nearest",
                                     "rear_laser=true"}),
                      {"rear_laser", "map of scans"}));
}

}  // namespace
}  // namespace slam
