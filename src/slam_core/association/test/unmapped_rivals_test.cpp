// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/unmapped_rivals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/test/placed_landmarks.hpp"

namespace slam::association {
namespace {

using Kind = Decision::Kind;
using Places = std::vector<Eigen::Vector2d>;

/// Under a ceiling with some two spots in a square metre. The robot stands at the origin and sees
/// all of them.
class UnmappedRivalsTest : public testing::Test {
 protected:
  /// @param mapped how many of the spots are in the map, the first ones
  /// @return how many are taken for landmarks of the map
  long taken(std::size_t mapped, double sigma) {
    LandmarkObservationArray array;
    for (const auto& spot : spots) array.observations.push_back(test::observationOf(spot));
    if (has_descriptors)
      for (std::size_t i = 0; i < spots.size(); ++i)
        array.observations[i].descriptor = descriptorOf(static_cast<double>(i), 0.05);
    const Places map(spots.begin(), spots.begin() + static_cast<std::ptrdiff_t>(mapped));
    const Eigen::Matrix3d P =
        Eigen::Vector3d(sigma * sigma, sigma * sigma, 0.25 * sigma * sigma).asDiagonal();
    std::vector<Descriptor> descriptors;
    if (has_descriptors)
      for (std::size_t i = 0; i < mapped; ++i)
        descriptors.push_back(array.observations[i].descriptor);
    auto policy = makePolicy("descriptor");
    std::vector<Decision> decisions;
    policy->decide(array, test::PlacedLandmarks(map, array, P, descriptors), false, decisions);
    return std::count_if(decisions.begin(), decisions.end(),
                         [](const Decision& decision) { return decision.kind == Kind::kLandmark; });
  }

  Places spots = {{1.2, 0.1},   {0.7, 0.9},   {-0.2, 1.3}, {-1.1, 0.6},
                  {-0.9, -0.5}, {-0.1, -1.2}, {0.8, -0.8}, {0.3, 0.4}};
  bool has_descriptors = false;
};

TEST_F(UnmappedRivalsTest, OneLandmarkTellsNothingWhereThePoseIsUncertain) {
  EXPECT_EQ(taken(1, 0.3), 0);
}

TEST_F(UnmappedRivalsTest, OneLandmarkIsEnoughWhereThePoseIsKnown) { EXPECT_EQ(taken(1, 0.02), 1); }

TEST_F(UnmappedRivalsTest, OneLandmarkIsEnoughWhereNothingElseLooksAlike) {
  has_descriptors = true;
  EXPECT_EQ(taken(1, 0.1), 1);
  has_descriptors = false;
  EXPECT_EQ(taken(1, 0.1), 0);
}

TEST_F(UnmappedRivalsTest, TwoLandmarksMayConfirmOneAnotherByChance) {
  EXPECT_EQ(taken(2, 0.3), 0);
}

TEST_F(UnmappedRivalsTest, FewObservationsCannotConfirmOneAnother) {
  spots.resize(5);
  EXPECT_EQ(taken(1, 0.3), 1) << "as without this test";
}

TEST_F(UnmappedRivalsTest, TheSectorOfASensorThatLooksBackIsSmall) {
  for (auto& spot : spots) spot = {-3.0 + 0.1 * spot.x(), 0.2 * spot.y()};
  EXPECT_EQ(taken(1, 0.1), 0) << "they are dense, and not all around";
}

TEST_F(UnmappedRivalsTest, LandmarksThatConfirmOneAnotherAreTaken) {
  EXPECT_EQ(taken(6, 0.3), 6);
  EXPECT_EQ(taken(8, 0.3), 8);
}

}  // namespace
}  // namespace slam::association
