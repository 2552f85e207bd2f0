// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/particle_map.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "slam_core/particle_filter/landmarks/landmark_index.hpp"
#include "slam_core/particle_filter/particles/mixture.hpp"

namespace slam::particle_filter {
namespace {

LandmarkEstimate landmark(std::uint32_t number, double x = 0.0) {
  LandmarkEstimate estimate({x, 0.0}, 0.01 * Eigen::Matrix2d::Identity());
  estimate.number = number;
  return estimate;
}

TEST(ParticleMap, FindsALandmarkByItsNumberWhereverItsSlotIs) {
  ParticleMap::Memory memory;
  const std::vector<std::vector<std::uint32_t>> maps = {
      {}, {0}, {3}, {0, 1, 2, 3}, {0, 1, 4, 5, 9}, {2, 3, 5, 7, 11, 13, 17}};
  for (const auto& numbers : maps) {
    ParticleMap map(memory);
    for (const auto number : numbers) map.push_back(landmark(number));
    for (std::uint32_t number = 0; number < 20; ++number) {
      const auto found = std::find(numbers.begin(), numbers.end(), number);
      const auto slot = slotOf(number, map);
      const auto* const estimate = find(number, map);
      ASSERT_EQ(slot.has_value(), found != numbers.end()) << number;
      ASSERT_EQ(estimate != nullptr, found != numbers.end()) << number;
      if (!slot) continue;
      EXPECT_EQ(*slot, static_cast<std::size_t>(found - numbers.begin()));
      EXPECT_EQ(estimate, &map[*slot]);
    }
  }
}

TEST(ParticleMap, ALandmarkThatSomeParticlesLackIsTheMixtureOfTheOthers) {
  ParticleSet particles(4, 1);
  particles[0].map.push_back(landmark(0, 7.0), 0);
  particles[1].map.push_back(landmark(1, 1.0), 0);
  particles[3].map.push_back(landmark(0, 7.0), 0);
  particles[3].map.push_back(landmark(1, 2.0), 0);
  const auto mixture = mixtureOf(particles, 1, 5);
  EXPECT_EQ(mixture.id, 5);
  EXPECT_NEAR(mixture.position.x(), 1.5, 1e-12);
  EXPECT_NEAR(mixture.covariance(0, 0), 0.01 + 0.25, 1e-12);
  EXPECT_NEAR(mixture.covariance(1, 1), 0.01, 1e-12);
}

TEST(LandmarkIndexTest, ALandmarkWithoutAnIdOfItsOwnGetsAFreeOne) {
  LandmarkIndex index;
  for (const LandmarkId id : {LandmarkId{7}, kUnknownId, LandmarkId{7}, LandmarkId{3}})
    index.append(id);
  EXPECT_EQ(index.id(0), 7);
  EXPECT_EQ(index.id(1), 8);
  EXPECT_EQ(index.id(2), 9);
  EXPECT_EQ(index.id(3), 3);
  EXPECT_EQ(index.numbersById(), (std::vector<std::size_t>{3, 0, 1, 2}));
}

}  // namespace
}  // namespace slam::particle_filter
