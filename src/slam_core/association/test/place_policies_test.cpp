// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/test/placed_landmarks.hpp"
#include "slam_core/common/random.hpp"

namespace slam::association {
namespace {

using Kind = Decision::Kind;
using test::observationOf;
using test::PlacedLandmarks;

/// What both policies must do.
class PlacePolicyTest : public testing::TestWithParam<const char*> {
 protected:
  const std::vector<Decision>& decide(bool map_is_fixed = false) {
    auto policy = makePolicy(GetParam(), {0.9999, places});
    EXPECT_TRUE(policy->usesPlaces());
    policy->decide(array, PlacedLandmarks(landmarks, array, P), map_is_fixed, decisions);
    return decisions;
  }
  void see(const Eigen::Vector2d& place, const Pose2& robot = Pose2()) {
    array.observations.push_back(observationOf(place, robot));
  }
  /// Observation i is of landmark i. @return the number of those that are taken for others
  int wrongOnes() const {
    int wrong = 0;
    for (std::size_t i = 0; i < decisions.size(); ++i)
      wrong += decisions[i].kind == Kind::kLandmark && decisions[i].landmark != i;
    return wrong;
  }
  int count(Kind kind) const {
    int count = 0;
    for (const auto& decision : decisions) count += decision.kind == kind;
    return count;
  }

  PlaceConfig places;
  std::vector<Eigen::Vector2d> landmarks;
  LandmarkObservationArray array;
  Eigen::Matrix3d P = Eigen::Vector3d(1e-3, 1e-3, 1e-4).asDiagonal();
  std::vector<Decision> decisions;
};

INSTANTIATE_TEST_SUITE_P(Of, PlacePolicyTest, testing::Values("nearest", "jcbb", "descriptor"),
                         [](const auto& policy) { return std::string(policy.param); });

TEST_P(PlacePolicyTest, TakesAnObservationForTheLandmarkWhereItLies) {
  landmarks = {{3, 1}, {4, -2}, {2, 2}};
  for (const auto i : {2, 0, 1}) see(landmarks[static_cast<std::size_t>(i)]);
  decide();
  EXPECT_EQ(count(Kind::kLandmark), 3);
  EXPECT_EQ(decisions[0].landmark, 2u);
  EXPECT_EQ(decisions[1].landmark, 0u);
  EXPECT_EQ(decisions[2].landmark, 1u);
}

TEST_P(PlacePolicyTest, DoesNotLookAtIds) {
  landmarks = {{3, 1}, {4, -2}};
  for (const auto& place : landmarks) see(place);
  const auto without = decide();
  array.observations[0].id = array.observations[1].id = 7;
  const auto& with = decide();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(with[i].kind, Kind::kLandmark);
    EXPECT_EQ(with[i].landmark, without[i].landmark);
  }
}

TEST_P(PlacePolicyTest, WhatIsFarFromTheMapIsNewUnlessTheMapIsFixed) {
  landmarks = {{3, 1}};
  see({10, 5});
  EXPECT_EQ(decide()[0].kind, Kind::kNew);
  EXPECT_EQ(decide(true)[0].kind, Kind::kNotInMap);
}

TEST_P(PlacePolicyTest, InAnEmptyMapAllIsNewOrNotInIt) {
  see({3, 1});
  see({1, 3});
  decide();
  EXPECT_EQ(count(Kind::kNew), 2);
  decide(true);
  EXPECT_EQ(count(Kind::kNotInMap), 2);
}

/// The gate's radius is 0.25 m here, and the ring 1.5 times that.
TEST_P(PlacePolicyTest, BeginsNothingInTheRingAroundALandmark) {
  landmarks = {{3, 0}};
  P.setZero();
  see({3.0 + 0.05 * 4.29 * 1.2, 0});
  EXPECT_EQ(decide()[0].kind, Kind::kAmbiguous);
  array.observations.clear();
  see({3.0 + 0.05 * 4.29 * 1.6, 0});
  EXPECT_EQ(decide()[0].kind, Kind::kNew);
}

TEST_P(PlacePolicyTest, LeavesOutWhatMayBeOfTwoLandmarks) {
  landmarks = {{3, 0}, {3.02, 0}};  // nearer to one another than a sigma
  see({3.01, 0});
  EXPECT_EQ(decide()[0].kind, Kind::kAmbiguous);
}

TEST_P(PlacePolicyTest, LeavesOutTwoThatMayBeOfOneLandmark) {
  landmarks = {{3, 0}};
  see({3.02, 0});
  see({2.98, 0});
  decide();
  EXPECT_EQ(count(Kind::kLandmark), 0);
  EXPECT_EQ(count(Kind::kAmbiguous), 2);
}

TEST_P(PlacePolicyTest, ClutterBesideALandmarkDoesNotTakeItsPlace) {
  landmarks = {{3, 0}};
  see({3.005, 0});
  see({3.16, 0.02});
  decide();
  EXPECT_EQ(decisions[0].kind, Kind::kLandmark);
  EXPECT_EQ(decisions[1].kind, Kind::kAmbiguous);
}

/// The two halves of the map look alike, and the pose does not tell them apart.
TEST_P(PlacePolicyTest, ChoosesNoneOfTwoIdenticalHalves) {
  P = Eigen::Vector3d(4.0, 1e-4, 1e-6).asDiagonal();
  for (const double x : {-1.0, 1.0})
    for (const double y : {2.0, 3.0, 4.5}) landmarks.push_back({x, y});
  for (const double y : {2.0, 3.0, 4.5}) see({0.0, y});
  decide();
  EXPECT_EQ(count(Kind::kLandmark), 0);
  EXPECT_EQ(count(Kind::kNew), 0);
}

TEST_P(PlacePolicyTest, SurvivesNumbersThatAreNone) {
  landmarks = {{3, 0}, {0, 3}};
  for (const auto& place : landmarks) see(place);
  array.observations[0].range = std::numeric_limits<double>::quiet_NaN();
  array.observations[0].covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
  decide();
  EXPECT_EQ(decisions[0].kind, Kind::kAmbiguous) << "nothing is begun with it";
  EXPECT_EQ(decisions[1].kind, Kind::kLandmark);
}

/// 500 at once, of which a tenth are of landmarks.
TEST_P(PlacePolicyTest, FindsTheLandmarksAmongTenTimesAsMuchClutter) {
  RandomStream random(3, 0);
  for (int i = 0; i < 50; ++i) {
    const double angle = 2.0 * M_PI * i / 50, range = 5.0 + i % 5;
    landmarks.emplace_back(range * std::cos(angle), range * std::sin(angle));
    see(landmarks.back());
  }
  for (int i = 0; i < 450; ++i) see({30.0 * random.gaussian(), 30.0 * random.gaussian()});
  decide();
  ASSERT_EQ(decisions.size(), 500u);
  EXPECT_GE(count(Kind::kLandmark), 40);
  EXPECT_LE(wrongOnes(), 2);
}

TEST_P(PlacePolicyTest, SaysTheSameAgain) {
  for (int i = 0; i < 40; ++i) landmarks.emplace_back(1.0 + 0.3 * i, 0.5 * (i % 7));
  for (const auto& place : landmarks) see(place, Pose2(0.05, 0.05, 0.01));
  const auto first = decide();
  const auto& second = decide();
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].kind, second[i].kind);
    EXPECT_EQ(first[i].landmark, second[i].landmark);
  }
}

/// A row of landmarks 0.4 m apart, seen from 0.3 m beside the prediction: each on its own is more
/// likely of its neighbour, but the end of the row tells.
class ShiftedRowTest : public testing::Test {
 protected:
  ShiftedRowTest() {
    for (int i = 0; i < 6; ++i) landmarks.emplace_back(3.0, -1.0 + 0.4 * i);
    landmarks.emplace_back(1.0, 4.0);
    for (const auto& place : landmarks)
      array.observations.push_back(observationOf(place, Pose2(0.0, 0.3, 0.0)));
  }
  int paired(const char* name, bool correctly) {
    std::vector<Decision> decisions;
    makePolicy(name, {0.9999, {}})
        ->decide(array, PlacedLandmarks(landmarks, array, P), false, decisions);
    int count = 0;
    for (std::size_t i = 0; i < decisions.size(); ++i)
      if (decisions[i].kind == Kind::kLandmark) count += (decisions[i].landmark == i) == correctly;
    return count;
  }

  std::vector<Eigen::Vector2d> landmarks;
  LandmarkObservationArray array;
  Eigen::Matrix3d P = Eigen::Vector3d(0.01, 0.04, 1e-6).asDiagonal();
};

TEST_F(ShiftedRowTest, TheJointTestPairsAllOfThem) {
  EXPECT_EQ(paired("jcbb", true), 7);
  EXPECT_EQ(paired("jcbb", false), 0);
}

TEST_F(ShiftedRowTest, OneByOneTheyCannotBeTold) { EXPECT_LT(paired("nearest", true), 4); }

TEST(Jcbb, WithTooFewNodesPairsOnlyWhatIsClear) {
  PlaceConfig few;
  few.nodes = 3;
  std::vector<Eigen::Vector2d> landmarks = {{3, 0}, {3.05, 0}, {0, 3}, {-3, 0}, {0, -3}};
  LandmarkObservationArray array;
  for (const auto& place : landmarks) array.observations.push_back(observationOf(place));
  std::vector<Decision> decisions;
  makePolicy("jcbb", {0.9999, few})
      ->decide(array, PlacedLandmarks(landmarks, array, 1e-4 * Eigen::Matrix3d::Identity()), false,
               decisions);
  int paired = 0;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (decisions[i].kind != Kind::kLandmark) continue;
    EXPECT_EQ(decisions[i].landmark, i);
    ++paired;
  }
  EXPECT_GE(paired, 1);
  EXPECT_LE(paired, 3);
}

}  // namespace
}  // namespace slam::association
