// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/descriptor_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::association {
namespace {

Descriptor vectorOf(int elements, double value, double sigma) {
  const auto one = descriptorOf(value, sigma);
  return {Descriptor::Vector::Constant(elements, one.values(0)),
          Descriptor::Vector::Constant(elements, one.sigmas(0))};
}

TEST(DescriptorFit, PassesTheRightOnesAsOftenAsItSays) {
  constexpr int kTrials = 20000;
  constexpr double kProbability = 0.95;
  RandomStream random(1, 0);
  for (const int elements : {1, 2, 3, 8}) {
    int passed = 0;
    for (int i = 0; i < kTrials; ++i) {
      auto seen = vectorOf(elements, 0.0, 0.3), landmark = vectorOf(elements, 0.0, 0.4);
      for (int k = 0; k < elements; ++k) {
        seen.values(k) = static_cast<float>(0.3 * random.gaussian());
        landmark.values(k) = static_cast<float>(0.4 * random.gaussian());
      }
      passed += fitOf(seen, landmark, kProbability).passes;
    }
    EXPECT_NEAR(passed / double(kTrials), kProbability, 0.008) << elements << " elements";
  }
}

TEST(DescriptorFit, CostsMoreTheWorseItFitsAndNothingWhereNothingIsKnown) {
  const auto seen = descriptorOf(0.2, 0.01);
  EXPECT_LT(fitOf(seen, descriptorOf(0.21, 0.01), 0.999).cost,
            fitOf(seen, descriptorOf(0.23, 0.01), 0.999).cost);
  EXPECT_FALSE(fitOf(seen, descriptorOf(0.3, 0.01), 0.999).passes);
  for (const auto& other : {Descriptor(), vectorOf(2, 7.0, 0.01)}) {
    EXPECT_TRUE(fitOf(seen, other, 0.999).passes);
    EXPECT_EQ(fitOf(seen, other, 0.999).cost, 0.0);
    EXPECT_EQ(fitOf(other, seen, 0.999).cost, 0.0);
  }
}

TEST(DescriptorMap, AveragesWhatIsSeenAndSaysHowWell) {
  DescriptorMap map;
  map.see(3, descriptorOf(0.2, 0.02));
  map.see(3, descriptorOf(0.4, 0.02));
  EXPECT_NEAR(map.of(3).values(0), 0.3, 1e-6);
  EXPECT_NEAR(map.of(3).sigmas(0), 0.02 / std::sqrt(2.0), 1e-6);
  map.see(3, Descriptor());
  map.see(3, vectorOf(2, 0.0, 1e-3));
  EXPECT_EQ(map.of(3).size(), 1) << "one of another length is none of them";
  EXPECT_NEAR(map.of(3).values(0), 0.3, 1e-6);
  EXPECT_TRUE(map.of(4).isEmpty());
}

TEST(DescriptorMap, NeverBelievesThatAllErrorsAreIndependent) {
  DescriptorMap map;
  for (int i = 0; i < 1000; ++i) map.see(3, descriptorOf(0.2, 0.02));
  EXPECT_GT(map.of(3).sigmas(0), 0.3 * 0.02);
  map.see(3, descriptorOf(0.2, 1.0));
  EXPECT_LT(map.of(3).sigmas(0), 0.02) << "a vague one takes nothing away";
}

TEST(DescriptorMap, ComesBackWithAMapAndForgets) {
  LandmarkMap map(2);
  map[0].id = 3;
  map[1].id = 5;
  auto again = map;
  map[1].descriptor = descriptorOf(0.2, 0.02);
  DescriptorMap descriptors(map);
  descriptors.describe(again);
  EXPECT_TRUE(again[0].descriptor.isEmpty());
  EXPECT_EQ(again[1].descriptor.values, map[1].descriptor.values);
  descriptors.forget(5);
  EXPECT_TRUE(descriptors.of(5).isEmpty());
}

}  // namespace
}  // namespace slam::association
