// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_path.hpp"

#include <gtest/gtest.h>

namespace slam::graph_slam {
namespace {

constexpr double kScanSigma = 0.001, kOdometrySigma = 0.02;  // [m], [rad]

Eigen::Matrix3d covarianceOf(double sigma) { return sigma * sigma * Eigen::Matrix3d::Identity(); }

/// A path that begins at the origin of map and odom frame, with a scan there that is drawn.
struct ScannedPath {
  ScannedPath() {
    path.addNode();
    reference = scans.insert(seen(Pose2()), covarianceOf(kScanSigma), true);
  }
  static PoseEstimate seen(const Pose2& robot) { return {robot, covarianceOf(kScanSigma)}; }
  void move(const Pose2& increment) {
    Motion motion;
    motion.increment = increment;
    motion.covariance = covarianceOf(kOdometrySigma);
    path.predict(motion);
    scans.predict(motion);
  }
  /// @return whether the path has taken it
  bool scan(const Pose2& robot, bool is_determined = true) {
    scans.locate(ScannedPath::seen(last));
    scans.takeMotion();
    last = robot;
    const bool is_taken = scans.follow(seen(robot), is_determined);
    path.optimize(3);
    return is_taken;
  }
  void expectRobot(const Pose2& pose, double tolerance) {
    EXPECT_LT(path.robot().pose.between(pose).vector().norm(), tolerance);
  }
  std::size_t chords(graph::Key node) { return chainOf(path)[node].chords.size(); }

  PathGraph path{{0.05, 0.05}, {Pose2(), covarianceOf(1e-4)}};
  ScanPath scans{path, Eigen::Vector3d::Constant(1e-8), 3};
  graph::Key reference = -1;
  Pose2 last;
};

const Pose2 kScanStep(0.1, 0.0, 0.02), kTold(0.12, 0.01, 0.0);

TEST(ScanPath, TellsTheMotionSinceTheLastNode) {
  ScannedPath drive;
  drive.move(kTold);
  EXPECT_TRUE(drive.scan(kScanStep));
  EXPECT_EQ(drive.path.tail().node, drive.reference);
  drive.expectRobot(kScanStep, 1e-9);
}

TEST(ScanPath, JoinsANodeToTheReferenceWhereALandmarkWasSeenSince) {
  ScannedPath drive;
  drive.move(kTold.part(0.5));
  const auto of_landmark = drive.path.addNode();
  drive.move(kTold.part(0.5));
  drive.scan(kScanStep);
  const auto node = *drive.path.tail().node;
  EXPECT_NE(node, of_landmark);
  EXPECT_EQ(drive.chords(node), 1u);
  EXPECT_EQ(chainOf(drive.path)[node].chords[0].other, drive.reference);
  EXPECT_EQ(chainOf(drive.path)[node].before, of_landmark);
  drive.expectRobot(kScanStep, 1e-3);
  EXPECT_LT(drive.path.robot().covariance.diagonal().cwiseSqrt().maxCoeff(), 2.0 * kScanSigma);
}

TEST(ScanPath, SharesANodeOfItsOwnStamp) {
  ScannedPath drive;
  drive.move(kTold);
  const auto of_landmark = drive.path.addNode();
  drive.scan(kScanStep);
  EXPECT_EQ(drive.path.tail().node, of_landmark);
  EXPECT_EQ(drive.chords(of_landmark), 1u);
  drive.expectRobot(kScanStep, 1e-3);
}

/// The errors of many scans that are matched with one submap do not add up.
TEST(ScanPath, StaysAsSureFromNodeToNode) {
  ScannedPath drive;
  Pose2 truth;
  for (int i = 0; i < 40; ++i) {
    drive.move(kTold);
    drive.path.addNode();
    drive.scan(truth = truth * kScanStep);
  }
  drive.expectRobot(truth, 2e-3);
  EXPECT_LT(drive.path.robot().covariance.diagonal().cwiseSqrt().maxCoeff(), 2.0 * kScanSigma);
}

TEST(ScanPath, IsToldByTheScanAloneWhereOdometryHasSlipped) {
  for (const bool is_shared : {false, true}) {
    ScannedPath drive;
    drive.move(Pose2(0.5, 0.2, 0.3));
    drive.path.addNode();
    if (!is_shared) drive.move(Pose2(0.01, 0.0, 0.0));
    drive.scan(kScanStep);
    drive.expectRobot(kScanStep, 1e-3);
  }
}

TEST(ScanPath, LeavesOdometryWhereAScanDeterminesNothing) {
  ScannedPath drive;
  drive.move(kTold);
  const auto of_landmark = drive.path.addNode();
  drive.scan(kScanStep, false);
  EXPECT_EQ(drive.chords(of_landmark), 0u);
  drive.expectRobot(kTold, 1e-6);
}

/// Without odometry a landmark's node is where the last scan was.
TEST(ScanPath, NeedsNoOdometry) {
  ScannedPath drive;
  drive.scan(kScanStep);
  const auto of_landmark = drive.path.addNode();
  drive.scan(kScanStep * kScanStep);
  EXPECT_EQ(drive.chords(of_landmark), 0u);
  drive.expectRobot(kScanStep * kScanStep, 1e-4);
}

TEST(ScanPath, DrawsAScanAtTheNodeThatItHas) {
  ScannedPath drive;
  drive.move(kTold);
  const auto of_landmark = drive.path.addNode();
  drive.scan(kScanStep);
  EXPECT_EQ(drive.scans.insert(ScannedPath::seen(kScanStep), covarianceOf(kScanSigma), true),
            of_landmark);
  drive.move(kTold);
  drive.path.addNode();
  drive.scan(kScanStep * kScanStep);
  EXPECT_EQ(chainOf(drive.path)[*drive.path.tail().node].chords[0].other, of_landmark);
}

TEST(ScanPath, GoesOnWhereItsNodesAreRemoved) {
  for (const bool is_reference : {true, false}) {
    ScannedPath drive;
    drive.move(kTold);
    drive.scan(kScanStep);
    drive.reference =
        drive.scans.insert(ScannedPath::seen(kScanStep), covarianceOf(kScanSigma), true);
    Pose2 truth = kScanStep;
    for (int i = 0; i < 4; ++i) {
      drive.move(kTold);
      drive.path.addNode();
      drive.scan(truth = truth * kScanStep);
      if (i != 1) continue;
      const auto removed = is_reference ? drive.reference : *drive.path.tail().node;
      drive.move(kTold);
      drive.path.addNode();
      drive.scans.forget(removed);
      chainOf(drive.path).remove(removed);
      drive.scan(truth = truth * kScanStep);
    }
    drive.expectRobot(truth, 0.1);  // what odometry alone tells now is a little off
    EXPECT_EQ(drive.chords(*drive.path.tail().node), 1u);
  }
}

}  // namespace
}  // namespace slam::graph_slam
