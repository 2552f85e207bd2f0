// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/landmark_meeting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::graph_slam {
namespace {

constexpr double kSigma = 0.03;

/// Landmarks all over a hall, as two maps have them that differ by a motion and by noise.
std::vector<SharedLandmark> sharedLandmarks(int count, const Pose2& first_second,
                                            RandomStream& random) {
  std::vector<SharedLandmark> shared;
  const auto noise = [&]() -> Eigen::Vector2d {
    return kSigma * Eigen::Vector2d{random.gaussian(), random.gaussian()};
  };
  for (int i = 0; i < count; ++i) {
    SharedLandmark landmark;
    landmark.first = landmark.second = static_cast<std::size_t>(i);
    const Eigen::Vector2d place{10.0 * random.uniform(), 6.0 * random.uniform()};
    landmark.in_first = place + noise();
    landmark.in_second = first_second.inverse().transform(place) + noise();
    landmark.first_covariance = landmark.second_covariance =
        kSigma * kSigma * Eigen::Matrix2d::Identity();
    shared.push_back(landmark);
  }
  return shared;
}

TEST(LandmarkMeeting, FindsTheMotionBetweenTwoMaps) {
  const Pose2 truth(3.0, -7.0, 2.5);
  RandomStream random(1, 0);
  for (const int count : {3, 5, 12, 300}) {
    auto shared = sharedLandmarks(count, truth, random);
    const auto meeting = meetingOf(shared);
    ASSERT_TRUE(meeting) << count;
    const Pose2 error = truth.between(meeting->first_second);
    EXPECT_LT(error.position().norm(), 0.15) << count;
    EXPECT_LT(std::abs(error.theta()), 0.03) << count;
    EXPECT_GE(meeting->agreeing.size(), static_cast<std::size_t>(0.95 * count));
  }
}

TEST(LandmarkMeeting, LeavesOutLandmarksThatWereMoved) {
  const Pose2 truth(3.0, -7.0, 2.5);
  RandomStream random(2, 0);
  auto shared = sharedLandmarks(10, truth, random);
  for (const std::size_t moved : {0, 4, 7}) shared[moved].in_second.x() += 1.5;
  const auto meeting = meetingOf(shared);
  ASSERT_TRUE(meeting);
  EXPECT_LT(truth.between(meeting->first_second).position().norm(), 0.15);
  EXPECT_EQ(meeting->agreeing.size(), 7U);
}

TEST(LandmarkMeeting, IsNoneWhereIdsMeanOtherLandmarks) {
  RandomStream random(3, 0);
  for (int i = 0; i < 50; ++i) {
    auto shared = sharedLandmarks(12, Pose2(), random);
    for (auto& landmark : shared)
      landmark.in_second = {10.0 * random.uniform(), 6.0 * random.uniform()};
    EXPECT_FALSE(meetingOf(shared)) << i;
  }
}

TEST(LandmarkMeeting, IsNoneWithFewerThanThreeOrAllAtOnePlace) {
  RandomStream random(4, 0);
  EXPECT_FALSE(meetingOf({}));
  EXPECT_FALSE(meetingOf(sharedLandmarks(2, Pose2(), random)));
  auto shared = sharedLandmarks(4, Pose2(), random);
  for (auto& landmark : shared) {
    landmark.in_first *= 0.05;
    landmark.in_second *= 0.05;
  }
  EXPECT_FALSE(meetingOf(shared));
}

TEST(EvenlyChosen, TakesAllWhereThereAreNoMore) {
  EXPECT_EQ(evenlyChosen(5, 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(evenlyChosen(3, 9), (std::vector<std::size_t>{0, 3, 6}));
  EXPECT_TRUE(evenlyChosen(3, 0).empty());
}

}  // namespace
}  // namespace slam::graph_slam
