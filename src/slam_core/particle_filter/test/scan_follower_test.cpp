// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_follower.hpp"

#include <gtest/gtest.h>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::particle_filter {
namespace {

using test::RoomDrive;

/// A scan in a corridor that the robot drives along: what lies ahead stays as unsure as it was.
ScanCorrection inACorridor() {
  ScanCorrection correction;
  correction.left = Eigen::Vector3d(1.0, 0.0, 0.0).asDiagonal();
  return correction;
}

void expectEqual(const Pose2& pose, const Pose2& expected) {
  EXPECT_LT((pose.vector() - expected.vector()).norm(), 1e-12)
      << pose.vector().transpose() << " is not " << expected.vector().transpose();
}

TEST(ScanFollower, ALeftErrorLiesInTheFrameOfTheRobotAtTheScan) {
  const Pose2 strayed(0.1, 0.2, 0.03);
  expectEqual(corrected(strayed, Pose2(), inACorridor()), Pose2(0.1, 0.0, 0.0));
  const Pose2 quarter_turn(0.0, 0.0, M_PI / 2);
  expectEqual(corrected(strayed, quarter_turn, inACorridor()), Pose2(0.0, 0.2, 0.0));
}

TEST(ScanFollower, AMotionKeepsTheCovarianceThatTheScanLeaves) {
  Motion motion;
  motion.increment = Pose2(1.0, 0.0, 0.0);
  motion.covariance = Eigen::Vector3d(0.01, 0.02, 0.03).asDiagonal();
  auto correction = inACorridor();
  correction.pose = Pose2(0.0, 0.5, 0.0);
  const auto after = corrected(motion, correction);
  expectEqual(after.increment, Pose2(1.0, 0.5, 0.0));
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.01, 0.0, 0.0).asDiagonal();
  EXPECT_LT((after.covariance - expected).norm(), 1e-15);
}

struct Drive {
  double nees = 0.0;            ///< mean
  double landmark_error = 0.0;  ///< of the only one [m]
};

/// A landmark is seen by wheels alone, before the scan of the same stamp comes.
Drive drivenWithLandmarksBeforeScans(std::uint64_t seed) {
  const auto filter = std::make_unique<FastSlam>();
  as<MapChooser>(*filter).useMap(MapKind::kGrid);
  PfConfig config;
  config.particles = 15;
  filter->configure(config);
  RoomDrive drive(seed);
  const Eigen::Vector2d landmark(2.0, -1.0);  // from the first pose
  constexpr int kSteps = 290;
  Drive driven;
  give(drive.next().scan, *filter);
  filter->execute();
  for (int i = 1; i < kSteps; ++i) {
    const auto step = drive.next();
    LandmarkObservationArray seen;
    seen.stamp = step.motion.end;
    seen.observations = {drive.sight(7, landmark)};
    give(step.motion, *filter);
    give(seen, *filter);
    filter->execute();
    give(step.scan, *filter);
    filter->execute();
    const auto told = filter->pose();
    Eigen::Vector3d error = told.pose.vector() - step.truth.vector();
    error.z() = std::remainder(error.z(), 2.0 * M_PI);
    driven.nees += error.dot(told.covariance.inverse() * error) / (kSteps - 1);
  }
  driven.landmark_error =
      (as<LandmarkMapper>(*filter).landmarks().at(0).position - landmark).norm();
  return driven;
}

TEST(ScanFollower, LandmarksBeforeScansLeaveThePoseHonestAndThemselvesInPlace) {
  double nees = 0.0, error = 0.0;
  constexpr int kDrives = 4;
  for (int seed = 1; seed <= kDrives; ++seed) {
    const auto drive = drivenWithLandmarksBeforeScans(static_cast<std::uint64_t>(seed));
    nees += drive.nees / kDrives;
    error += drive.landmark_error / kDrives;
  }
  EXPECT_LT(nees, 3.0);
  EXPECT_LT(error, 0.0075) << "what landmarks have moved the particles by is taken back";
}

}  // namespace
}  // namespace slam::particle_filter
