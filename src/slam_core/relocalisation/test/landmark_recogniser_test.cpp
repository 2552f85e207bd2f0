// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/landmark_recogniser.hpp"

#include <gtest/gtest.h>

#include "slam_core/relocalisation/test/some_landmarks.hpp"

namespace slam::relocalisation {
namespace {

using Verdict = Recognition::Verdict;

/// A robot that stands in a hall and sees what its camera has in view, ten times a second.
class StandingRobot {
 public:
  StandingRobot(const Pose2& truth, std::uint64_t seed) : truth_(truth), random_(seed, 2) {}

  LandmarkObservationArray look(const LandmarkMap& tags) {
    LandmarkObservationArray array;
    array.stamp = stamp += std::chrono::milliseconds(100);
    for (const auto& tag : tags) {
      const Eigen::Vector2d p = truth_.inverse().transform(tag.position);
      LandmarkObservation z;
      z.id = tag.id;
      z.range = p.norm() * (1.0 + 0.01 * random_.gaussian());
      z.bearing = std::atan2(p.y(), p.x()) + 0.01 * random_.gaussian();
      z.covariance << std::pow(0.01 * p.norm(), 2), 0.0, 0.0, 1e-4;
      if (std::abs(z.bearing) < 0.6 && z.range < 6.0) array.observations.push_back(z);
    }
    return array;
  }

  void move(const Pose2& step) { truth_ = truth_ * step; }

  Stamp stamp = stampFromNanoseconds(1000000000000);

 private:
  Pose2 truth_;
  RandomStream random_;
};

class LandmarkRecogniserTest : public testing::Test {
 protected:
  /// Looks for some seconds. @return the last verdict on something new
  Recognition lookFor(double time, const LandmarkMap& around) {
    Recognition last;
    for (int i = 0; i < 10.0 * time; ++i) {
      recogniser.see(robot.look(around));
      if (const auto found = recogniser.find(robot.stamp)) last = *found;
      if (last.verdict == Verdict::kConfirmed) break;
    }
    return last;
  }

  /// Drives for 1.8 s. @return whether a place was confirmed
  bool isFoundWhileDriving(const Pose2& step, const Pose2& odometry) {
    Motion motion;
    motion.increment = odometry;
    motion.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
    for (int i = 0; i < 18; ++i) {
      robot.move(step);
      recogniser.move(motion);
      recogniser.see(robot.look(tags));
      const auto found = recogniser.find(robot.stamp);
      if (found && found->verdict == Verdict::kConfirmed) return true;
    }
    return false;
  }

  const Pose2 truth{2.0, 3.0, 0.5};
  StandingRobot robot{truth, 1};
  LandmarkRecogniser recogniser;
  const Eigen::Matrix2d exact = 1e-6 * Eigen::Matrix2d::Identity();
  /// Two of them are in view, 1 m apart.
  const LandmarkMap tags = {{1, truth.transform({3.0, 0.5}), exact},
                            {2, truth.transform({3.0, -0.5}), exact},
                            {3, truth.transform({-6.0, 4.0}), exact},
                            {4, truth.transform({-6.0, -4.0}), exact}};
};

TEST_F(LandmarkRecogniserTest, ConfirmsAPlaceByTwoMarkersWithinTwoSeconds) {
  recogniser.begin(tags);
  recogniser.see(robot.look(tags));
  EXPECT_NE(recogniser.find(robot.stamp)->verdict, Verdict::kConfirmed);
  const auto found = lookFor(1.9, tags);
  ASSERT_EQ(found.verdict, Verdict::kConfirmed);
  EXPECT_LT((found.robot.pose.position() - truth.position()).norm(), 0.15);
  EXPECT_LT(std::abs(found.robot.pose.theta() - truth.theta()), 0.05);
}

TEST_F(LandmarkRecogniserTest, ConfirmsAPlaceWhereOdometryLeads) {
  recogniser.begin(tags);
  const Pose2 ahead(0.1, 0.0, 0.0);
  EXPECT_TRUE(isFoundWhileDriving(ahead, ahead));
}

TEST_F(LandmarkRecogniserTest, ConfirmsNoPlaceWhereACameraWasTurnedByHand) {
  recogniser.begin(tags);
  const Pose2 as_seen(0.1 * std::cos(0.5), -0.1 * std::sin(0.5), 0.0);
  EXPECT_FALSE(isFoundWhileDriving(as_seen, Pose2(0.1, 0.0, 0.0)));
}

TEST_F(LandmarkRecogniserTest, IsNotSatisfiedWithOneMarker) {
  recogniser.begin(tags);
  const LandmarkMap one = {tags[0]};
  EXPECT_EQ(lookFor(5.0, one).verdict, Verdict::kNothing);
}

/// The second marker has the id of another one that hangs far away.
TEST_F(LandmarkRecogniserTest, IsNotMisledByASecondMarkerOfOneId) {
  recogniser.begin(tags);
  auto seen = tags;
  seen[1].id = 3;
  seen[2].position += Eigen::Vector2d(100.0, 0.0);
  EXPECT_EQ(lookFor(5.0, seen).verdict, Verdict::kNothing);
}

TEST_F(LandmarkRecogniserTest, TellsThatTwoPlacesAreAlike) {
  LandmarkRecogniser without_ids({}, LocalLandmarks::Ids::kIgnored);
  recogniser = std::move(without_ids);
  RandomStream random(1, 7);
  LandmarkMap map;
  for (int i = 0; i < 8; ++i)
    map.push_back(
        {i, truth.transform({1.5 + 3.0 * random.uniform(), 2.0 * random.uniform() - 1.0}), exact});
  const auto room = map;
  for (auto landmark : room) {
    landmark.id += 100;
    landmark.position.x() += 50.0;
    map.push_back(landmark);
  }
  recogniser.begin(map);
  EXPECT_EQ(lookFor(3.0, room).verdict, Verdict::kAmbiguous);
  recogniser.begin(room);
  EXPECT_EQ(lookFor(3.0, room).verdict, Verdict::kConfirmed);
}

/// A robot drives under a ceiling of tiles that are alike, of which only the first ones are in the
/// map. It began beyond them.
TEST_F(LandmarkRecogniserTest, IsNowhereUnderTilesThatAreAlike) {
  constexpr double kTile = 2.0;  // [m]
  LandmarkRecogniser without_ids({}, LocalLandmarks::Ids::kIgnored);
  recogniser = std::move(without_ids);
  RandomStream random(1, 8);
  LandmarkMap tile, map, ceiling;
  for (int i = 0; i < 4; ++i)
    tile.push_back({i, {kTile * random.uniform(), 4.0 * random.uniform() - 2.0}, exact});
  for (int i = 0; i < 30; ++i)
    for (auto spot : tile) {
      spot.id += 10 * i;
      spot.position.x() += kTile * i;
      ceiling.push_back(spot);
      if (i < 6) map.push_back(spot);
    }
  recogniser.begin(map);
  int ambiguous = 0;
  for (int step = 0; step < 150; ++step) {  // 15 m
    const Pose2 place(24.0 + 0.1 * step, 0.0, 0.0);
    StandingRobot there(place, 10 + step);
    auto array = there.look(ceiling);
    Motion motion;
    motion.increment = Pose2(0.1, 0.0, 0.0);
    motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    recogniser.move(motion);
    recogniser.see(array);
    const auto found = recogniser.find(robot.stamp += std::chrono::milliseconds(100));
    ASSERT_TRUE(found);
    ASSERT_NE(found->verdict, Verdict::kConfirmed) << "after " << 0.1 * step << " m";
    ambiguous += found->verdict == Verdict::kAmbiguous;
  }
  EXPECT_GT(ambiguous, 20);
}

TEST_F(LandmarkRecogniserTest, SaysNothingUntilSomethingNewIsSeen) {
  recogniser.begin(tags);
  recogniser.see(robot.look(tags));
  EXPECT_TRUE(recogniser.find(robot.stamp));
  EXPECT_FALSE(recogniser.find(robot.stamp));
  recogniser.see(robot.look({}));
  EXPECT_FALSE(recogniser.find(robot.stamp));
}

/// What the robot sees stands in the map once, but other parts of the map look alike.
TEST(LandmarkRecogniser, ConfirmsNoPlaceOfAMapThatRepeatsItself) {
  RandomStream random(3, 0);
  const auto add = [&](LandmarkMap& map, const Eigen::Vector2d& place) {
    const auto id = static_cast<LandmarkId>(map.size());
    map.push_back({id, place, 1e-6 * Eigen::Matrix2d::Identity()});
  };
  LandmarkMap once;
  for (int i = 0; i < 12; ++i)
    add(once, {2.0 + 3.0 * random.uniform(), 3.0 * random.uniform() - 1.5});
  for (int i = 0; i < 12; ++i) add(once, {4.0 * random.uniform(), -20.0 + 4.0 * random.uniform()});
  LandmarkMap twice = once;
  for (std::size_t i = 12; i < once.size(); ++i)
    add(twice, once[i].position + Eigen::Vector2d(9.0, 0.0));
  for (const auto* map : {&once, &twice}) {
    StandingRobot robot(Pose2(), 1);
    LandmarkRecogniser recogniser({}, LocalLandmarks::Ids::kIgnored);
    recogniser.begin(*map);
    Recognition last;
    for (int i = 0; i < 30; ++i) {
      recogniser.see(robot.look(*map));
      if (const auto found = recogniser.find(robot.stamp)) last = *found;
    }
    EXPECT_EQ(last.verdict, map == &once ? Verdict::kConfirmed : Verdict::kAmbiguous);
  }
}

}  // namespace
}  // namespace slam::relocalisation
