// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/map_drift.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace slam::scan_matching {
namespace {

using Points = std::vector<Eigen::Vector2d>;

const Eigen::Matrix3d kFirst = 1e-6 * Eigen::Matrix3d::Identity();
const Eigen::Matrix3d kMatched = 1e-5 * Eigen::Matrix3d::Identity();
const Eigen::Matrix3d kInformation = 1e6 * Eigen::Matrix3d::Identity();

/// A match that determines the pose as a whole.
Match matched() {
  Match match;
  match.information = kMatched.inverse();
  return match;
}

/// A scan whose beams end at these points of the map.
grid_map::ScanPoints scanOf(const Points& points, const Pose2& pose) {
  grid_map::ScanPoints scan;
  scan.cells_per_metre = 20.0;
  for (const auto& point : points)
    scan.beams.push_back({scan.cells_per_metre * pose.inverse().transform(point), 1, 0.0});
  return scan;
}

/// A robot that drives into the unknown, and sees one post three metres ahead of it after the
/// other. It is matched with those that it has drawn before.
class Drive {
 public:
  Drive() { drift.restart({Pose2(), kFirst}); }

  void draw(const Points& points, const Pose2& pose) { drift.add(scanOf(points, pose), pose); }
  /// @param points that determine the pose as a whole
  void match(const Points& points, const Pose2& pose) {
    std::vector<FittedEnd> ends;
    for (const auto& point : points) ends.push_back({point, kInformation});
    drift.follow({pose, kMatched}, matched(), ends);
  }
  void goTo(double metres) {
    for (; x_ <= metres; x_ += 0.5) {
      const Pose2 pose(x_, 0.0, 0.0);
      if (x_ > 0.0) match(postsAhead(), pose);
      drift.add(scanOf({{x_ + 3.0, 0.0}}, pose), pose);
    }
  }
  Eigen::Matrix3d at(double x) const { return drift.covarianceAt({x, 0.0, 0.0}); }

  MapDrift drift{0.01, 0.002};

 private:
  Points postsAhead() const {
    Points posts;
    for (double x = std::max(3.0, x_); x < x_ + 3.0; x += 0.5) posts.emplace_back(x, 0.0);
    return posts;
  }

  double x_ = 0.0;
};

TEST(MapDrift, GrowsWithTheWayIntoTheUnknown) {
  Drive drive;
  EXPECT_TRUE(drive.at(0.0).isApprox(kFirst));
  drive.goTo(100.0);
  const auto P = drive.at(100.0);
  // 0.01 m and 0.002 rad after a metre, with the root of the way
  EXPECT_NEAR(std::sqrt(P(0, 0)), 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(P(2, 2)), 0.02, 0.002);
  // across, the heading's error adds up: sigma d sqrt(d / 3)
  EXPECT_NEAR(std::sqrt(P(1, 1)), 0.002 * 100.0 * std::sqrt(100.0 / 3.0), 0.12);
}

TEST(MapDrift, IsAsSureAsBeforeWhereTheRobotSeesAgainWhatItDrewEarly) {
  Drive drive;
  drive.goTo(50.0);
  const Pose2 start(1.0, 0.0, 0.0);
  drive.match({{3.0, 0.0}}, start);
  EXPECT_LT(drive.at(1.0)(0, 0), 1.5e-4);
}

TEST(MapDrift, IsNoSurerNearWhatItDrewEarlyWithoutSeeingItThere) {
  Drive drive;
  drive.goTo(50.0);
  const auto before = drive.at(50.0);
  const Pose2 start(1.0, 0.0, 0.0);            // by its estimate
  drive.draw({{3.4, 0.0}}, {50.0, 0.0, 0.0});  // the wall there a second time, since it has drifted
  drive.match({{3.4, 0.0}}, start);
  EXPECT_GT(drive.at(1.0)(0, 0), 0.8 * before(0, 0));
}

TEST(MapDrift, IsSureInTheDirectionsThatTheSurfacesTell) {
  Drive drive;
  drive.goTo(50.0);
  const Pose2 pose(50.0, 0.0, 0.0);
  const auto before = drive.at(50.0);
  const Eigen::Matrix3d across = Eigen::Vector3d(0.0, 1e6, 1e6).asDiagonal();
  const Eigen::Matrix3d along = Eigen::Vector3d(1e6, 0.0, 0.0).asDiagonal();
  // an old wall, and a new one at its end
  drive.drift.follow({pose, kMatched}, matched(), {{{3.0, 0.0}, across}, {{53.0, 0.0}, along}});
  const auto after = drive.at(50.0);
  EXPECT_GT(after(0, 0), 0.8 * before(0, 0));
  EXPECT_LT(after(1, 1), 0.5 * before(1, 1));
}

TEST(MapDrift, GrowsWhereNothingIsMatched) {
  Drive drive;
  drive.goTo(5.0);
  for (double x = 6.0; x <= 30.0; x += 1.0)
    drive.drift.follow({{x, 0.0, 0.0}, kMatched}, Match(), {});
  EXPECT_NEAR(std::sqrt(drive.at(30.0)(0, 0)), 0.01 * std::sqrt(30.0), 0.01);
}

TEST(MapDrift, WhatIsDrawnFromAVagueRobotIsNoSurer) {
  Drive drive;
  drive.goTo(5.0);
  const Pose2 pose(30.0, 0.0, 0.0);
  drive.drift.follow({pose, kMatched}, Match(), {});
  drive.drift.anchor(Eigen::Matrix3d::Identity());
  drive.draw({{33.0, 0.0}}, pose);
  EXPECT_GE(drive.at(30.0)(0, 0), 1.0);
  drive.match({{3.0, 0.0}}, {1.0, 0.0, 0.0});
  EXPECT_LT(drive.at(1.0)(0, 0), 0.01) << "it sees what it drew before";
  drive.match({{33.0, 0.0}}, pose);
  EXPECT_GE(drive.at(30.0)(0, 0), 1.0) << "it sees what it drew then";
}

TEST(MapDrift, IsNotThatOfTheWayWhereTheRobotIsFoundAmongOlderSurfaces) {
  Drive drive;
  drive.goTo(50.0);
  Match found;
  found.is_among_older = true;
  found.information = 200.0 * Eigen::Matrix3d::Identity();  // as much as the robot knew before
  const PoseEstimate robot{{1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity() / 400.0};
  drive.drift.follow(robot, found, {{{3.0, 0.0}, found.information}});
  EXPECT_LT(drive.at(1.0)(0, 0), 1e-3) << "robot.covariance holds what the way has added";
}

TEST(MapDrift, ALoadedMapIsTheReference) {
  Drive drive;
  drive.drift.restartInLoadedMap({3.0, 4.0, 1.0});
  for (double x = 4.0; x < 60.0; x += 1.0) drive.match({{x + 3.0, 4.0}}, {x, 4.0, 0.0});
  EXPECT_LT(drive.drift.covarianceAt({59.0, 4.0, 0.0})(0, 0), 1e-4);
}

TEST(MapDrift, IsSurerThanARobotThatIsVagueAndVaguerThanTheParts) {
  MapDrift drift(0.01, 0.002);
  const auto robot = [](double sigma) {
    return PoseEstimate{Pose2(), sigma * sigma * Eigen::Matrix3d::Identity()};
  };
  drift.restart(robot(0.01));
  EXPECT_TRUE(drift.isSurerThan(robot(0.3)));
  EXPECT_FALSE(drift.isSurerThan(robot(0.05))) << "it is not vague";
  drift.restart(robot(1.0));
  EXPECT_FALSE(drift.isSurerThan(robot(0.3))) << "the parts are vaguer";
}

}  // namespace
}  // namespace slam::scan_matching
