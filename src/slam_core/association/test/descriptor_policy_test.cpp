// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/test/placed_landmarks.hpp"

namespace slam::association {
namespace {

using Kind = Decision::Kind;
using test::observationOf;
using test::PlacedLandmarks;

/// Landmarks of which place and descriptor are known.
class DescriptorPolicyTest : public testing::Test {
 protected:
  const std::vector<Decision>& decide(const std::string& name) {
    makePolicy(name, {0.9999, {}})
        ->decide(array, PlacedLandmarks(landmarks, array, P, descriptors), false, decisions);
    return decisions;
  }
  void see(const Eigen::Vector2d& place, const Descriptor& descriptor) {
    array.observations.push_back(observationOf(place));
    array.observations.back().descriptor = descriptor;
  }
  const Descriptor thin = descriptorOf(0.1, 0.01), thick = descriptorOf(0.3, 0.01);
  std::vector<Eigen::Vector2d> landmarks = {{4.0, 0.05}, {4.0, -0.05}};
  std::vector<Descriptor> descriptors = {thin, thick};
  LandmarkObservationArray array;
  /// Both landmarks are within the gate of what the robot sees.
  Eigen::Matrix3d P = Eigen::Vector3d(1e-3, 1e-3, 1e-4).asDiagonal();
  std::vector<Decision> decisions;
};

TEST_F(DescriptorPolicyTest, TellsNeighboursApartThatPlaceDoesNot) {
  see({4.0, 0.0}, thick);
  EXPECT_EQ(decide("jcbb")[0].kind, Kind::kAmbiguous);
  ASSERT_EQ(decide("descriptor")[0].kind, Kind::kLandmark);
  EXPECT_EQ(decisions[0].landmark, 1u);
}

TEST_F(DescriptorPolicyTest, TakesNoLandmarkWhoseDescriptorDoesNotFit) {
  landmarks = {{4.0, 0.5}, {4.0, -0.5}};
  see(landmarks[0], descriptorOf(0.2, 0.01));
  EXPECT_EQ(decide("jcbb")[0].kind, Kind::kLandmark);
  EXPECT_EQ(decide("descriptor")[0].kind, Kind::kNew);
}

TEST_F(DescriptorPolicyTest, PrefersTheOneThatFitsBetter) {
  descriptors = {descriptorOf(0.20, 0.01), descriptorOf(0.24, 0.01)};
  see({4.0, 0.0}, descriptorOf(0.24, 0.01));
  ASSERT_EQ(decide("descriptor")[0].kind, Kind::kLandmark) << "both pass, one fits";
  EXPECT_EQ(decisions[0].landmark, 1u);
}

TEST_F(DescriptorPolicyTest, GoesByPlaceAloneWhereOneOfThemHasNone) {
  see({4.0, 0.0}, {});
  EXPECT_EQ(decide("descriptor")[0].kind, Kind::kAmbiguous);
  P *= 1e-3;
  descriptors.clear();
  array.observations.clear();
  see(landmarks[0], thick);
  see(landmarks[1], thin);
  decide("descriptor");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(decisions[i].kind, Kind::kLandmark);
    EXPECT_EQ(decisions[i].landmark, i);
  }
}

}  // namespace
}  // namespace slam::association
