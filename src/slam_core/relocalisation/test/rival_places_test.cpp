// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/rival_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/association/constellation_search.hpp"
#include "slam_core/common/random.hpp"

namespace slam::relocalisation {
namespace {

constexpr double kTile = 2.0;  ///< the edge of a tile, each of which has the same spots [m]
const Eigen::Matrix2d kExact = 1e-6 * Eigen::Matrix2d::Identity();

/// A ceiling of tiles along the x axis.
LandmarkMap tiles(int count) {
  RandomStream random(3, 0);
  Eigen::Vector2d spots[5];
  for (auto& spot : spots)
    spot = Eigen::Vector2d(kTile * random.uniform(), kTile * random.uniform());
  LandmarkMap map;
  for (int tile = 0; tile < count; ++tile)
    for (const auto& spot : spots)
      map.push_back(
          {static_cast<LandmarkId>(map.size()), spot + Eigen::Vector2d(kTile * tile, 0.0), kExact});
  return map;
}

class RivalPlacesTest : public testing::Test {
 protected:
  void SetUp() override {
    LandmarkObservationArray all_round;
    for (int i = 0; i < 240; ++i) {
      LandmarkObservation z;
      z.range = kReach;
      z.bearing = 2.0 * M_PI * i / 240 - M_PI;
      all_round.observations.push_back(z);
    }
    reach.see(all_round);
  }
  /// Lets a robot look for its place that is really at `truth`, under an endless ceiling.
  void look(const LandmarkMap& map) {
    std::vector<association::LocalLandmark> around;
    for (const auto& spot : world) {
      const Eigen::Vector2d p = truth.inverse().transform(spot.position);
      if (p.norm() < kReach) around.push_back({kUnknownId, p, 1e-4 * Eigen::Matrix2d::Identity()});
    }
    const association::ConstellationSearch search(map, 0.05);
    places = search.placesOf(around, reach);
    std::vector<Pose2> likely;
    for (const auto& place : places)
      if (place.log_odds >= 2.0 * std::log(1000.0)) likely.push_back(place.robot.pose);
    rivals.add(likely, repeats);
    rivals.check(search.evidence(), around, reach);
  }
  void drive(double way) {
    Motion motion;
    motion.increment = Pose2(way, 0.0, 0.0);
    rivals.move(motion);
    truth = truth * motion.increment;
  }

  static constexpr double kReach = 2.5;  // [m]
  LandmarkMap world = tiles(40);
  Pose2 truth{4.0, 1.0, 0.0};
  association::SensorReach reach;
  std::vector<association::Place> places;
  RivalPlaces rivals;
  std::vector<Pose2> repeats;
};

TEST_F(RivalPlacesTest, AreNoneWhereAPlaceIsUnique) {
  world = tiles(1);
  truth = {1.0, 1.0, 0.0};
  look(world);
  ASSERT_FALSE(places.empty());
  EXPECT_FALSE(rivals.hasOtherThan(places[0].robot.pose));
  EXPECT_TRUE(rivals.hasOtherThan(Pose2(40.0, 0.0, 0.0)));
}

/// The robot is beyond the map. There, only the last one of the places is left on the map in the
/// end, and explains all that is seen.
TEST_F(RivalPlacesTest, RemainWhereTheyLeaveTheMap) {
  const auto map = tiles(6);
  truth = {24.0, 1.0, 0.0};
  look(map);
  ASSERT_GE(places.size(), 2u);
  for (int i = 0; i < 30; ++i) {
    drive(0.2);
    look(map);
    if (!places.empty()) {
      EXPECT_TRUE(rivals.hasOtherThan(places[0].robot.pose)) << i;
    }
  }
}

/// The robot drives at the edge of the map, or beyond it: what it sees there is in no place.
TEST_F(RivalPlacesTest, CountWhereTheyExplainAPartOfWhatIsSeen) {
  for (const auto& spot : tiles(40))
    world.push_back({spot.id + 1000, spot.position + Eigen::Vector2d(0.0, kTile), kExact});
  truth = {4.0, 2.0, 0.0};
  look(tiles(6));
  ASSERT_FALSE(places.empty());
  const auto seen = std::count_if(world.begin(), world.end(), [&](const auto& spot) {
    return (spot.position - truth.position()).norm() < kReach;
  });
  EXPECT_LT(places[0].matches, 0.8 * static_cast<double>(seen));
  EXPECT_TRUE(rivals.hasOtherThan(places[0].robot.pose));
}

/// Two tiles are alike, and what comes after them is not.
TEST_F(RivalPlacesTest, AreGoneWhereTheMapContradictsThem) {
  RandomStream random(5, 0);
  world = tiles(1);
  for (const auto& spot : tiles(1))
    world.push_back({spot.id + 100, spot.position + Eigen::Vector2d(20.0, 0.0), kExact});
  for (int i = 0; i < 12; ++i)
    for (const double begin : {3.5, 23.5})
      world.push_back({200 + i, {begin + 5.0 * random.uniform(), 2.0 * random.uniform()}, kExact});
  truth = {1.0, 1.0, 0.0};
  look(world);
  ASSERT_GE(places.size(), 2u);
  EXPECT_TRUE(rivals.hasOtherThan(places[0].robot.pose));
  drive(5.0);
  look(world);
  ASSERT_FALSE(places.empty());
  EXPECT_LT((places[0].robot.pose.position() - truth.position()).norm(), 0.1);
  EXPECT_FALSE(rivals.hasOtherThan(places[0].robot.pose));
}

/// The map has one tile of this look, but repeats itself elsewhere.
TEST_F(RivalPlacesTest, MayLieBeyondTheMap) {
  world = tiles(1);
  truth = {1.0, 1.0, 0.0};
  repeats = {Pose2(30.0, 0.0, 0.0), Pose2(-30.0, 0.0, 0.0)};
  look(world);
  ASSERT_FALSE(places.empty());
  EXPECT_TRUE(rivals.hasOtherThan(places[0].robot.pose));
}

TEST_F(RivalPlacesTest, AreForgotten) {
  look(tiles(6));
  rivals.forget();
  EXPECT_FALSE(rivals.hasOtherThan(Pose2(40.0, 0.0, 0.0)));
}

}  // namespace
}  // namespace slam::relocalisation
