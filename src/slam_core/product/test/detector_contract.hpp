// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <vector>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/product/test/driven_component.hpp"

// Every detector that takes in a laser's scans keeps this contract. A program that includes this
// file tests the detectors that are linked into it:
//   INSTANTIATE_DETECTOR_CONTRACT(Mine, (std::vector<RoleVariant>{{"mine", "mine"}}));

/// @param variants a vector of RoleVariant
#define INSTANTIATE_DETECTOR_CONTRACT(name, variants) \
  INSTANTIATE_TEST_SUITE_P(name, DetectorContract, testing::ValuesIn(variants), roleVariantName)

namespace slam::test {

class DetectorContract : public testing::TestWithParam<RoleVariant> {
 protected:
  using Driven = DrivenComponent<LandmarkDetector>;
  using Arrays = std::vector<LandmarkObservationArray>;

  static Arrays arraysOf(Driven& detector, std::uint64_t seed, int steps) {
    Arrays arrays;
    detector.run(seed, steps, [&] {
      if (detector->observations()) arrays.push_back(*detector->observations());
    });
    return arrays;
  }
  static void expectSameBits(const Arrays& a, const Arrays& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].stamp, b[i].stamp);
      ASSERT_EQ(a[i].observations.size(), b[i].observations.size());
      for (std::size_t j = 0; j < a[i].observations.size(); ++j) {
        EXPECT_EQ(a[i].observations[j].vector(), b[i].observations[j].vector());
        EXPECT_EQ(a[i].observations[j].covariance, b[i].observations[j].covariance);
      }
    }
  }
};

TEST_P(DetectorContract, MakesObservations) {
  Driven detector(GetParam());
  const auto& outputs = detector.inputs().ports().outputs();
  ASSERT_EQ(outputs.size(), 1U);
  EXPECT_EQ(outputs.front().name, "observations");
  EXPECT_EQ(outputs.front().kind, kindOf<LandmarkObservationArray>());
}

TEST_P(DetectorContract, GivesAnArrayForEachInput) {
  Driven detector(GetParam());
  const auto arrays = arraysOf(detector, 1, 50);
  ASSERT_EQ(arrays.size(), 50U);
  for (std::size_t i = 1; i < arrays.size(); ++i) {
    ASSERT_EQ(arrays[i].sequence, arrays[i - 1].sequence + 1);
    ASSERT_LT(arrays[i - 1].stamp, arrays[i].stamp);
  }
}

TEST_P(DetectorContract, SeesWhatABackEndCanUse) {
  Driven detector(GetParam());
  std::size_t seen = 0;
  for (const auto& array : arraysOf(detector, 1, 145)) {
    EXPECT_EQ(array.sensor_pose.vector(), RoomDrive::sensorPose().vector());
    seen += array.observations.size();
    for (const auto& observation : array.observations) ASSERT_EQ(faultOf(observation), "");
    EXPECT_TRUE(std::is_sorted(array.observations.begin(), array.observations.end(),
                               [](const auto& a, const auto& b) { return a.id < b.id; }));
  }
  EXPECT_GT(seen, 0U);
}

TEST_P(DetectorContract, GivesTheSameBitsForTheSameInput) {
  Driven first(GetParam()), second(GetParam());
  expectSameBits(arraysOf(first, 3, 60), arraysOf(second, 3, 60));
}

TEST_P(DetectorContract, IsFreshAfterResetAndAfterConfigure) {
  RestartedComponents<LandmarkDetector> detectors(GetParam());
  const auto expected = arraysOf(detectors.fresh, 3, 40);
  expectSameBits(expected, arraysOf(detectors.reset, 3, 40));
  expectSameBits(expected, arraysOf(detectors.configured, 3, 40));
}

}  // namespace slam::test
