// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/delayed_decisions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::graph_slam {
namespace {

/// A robot that drives along two landmarks, 0.35 m apart and 5 m away, among others of which it
/// sees some. What is seen has no error, the way has little.
class DelayedDecisionsTest : public testing::Test {
 protected:
  static constexpr double kStep = 0.2;

  DelayedDecisionsTest() : path_({0.05, 0.05}, {Pose2(), 1e-6 * Eigen::Matrix3d::Identity()}) {
    GraphConfig config;
    config.association = "jcbb";
    associator_ = Associator(config.ofAssociation());
    associator_.restart({});
    delayed_ = DelayedDecisions(config);
  }

  LandmarkObservation seen(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d in_robot = truth_.inverse().transform(place);
    LandmarkObservation z;
    z.range = in_robot.norm();
    z.bearing = std::atan2(in_robot.y(), in_robot.x());
    z.covariance = Eigen::Vector2d(1e-4, 1e-4).asDiagonal();
    return z;
  }

  void append(const Eigen::Vector2d& place) {
    landmarks_.append(kUnknownId, place, seen(place), Pose2());
  }

  /// @param sigma of the motion's position [m] and heading [rad]
  void move(double sigma) {
    Motion motion;
    motion.increment = Pose2(kStep, 0.0, 0.0);
    motion.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
    path_.predict(motion);
    associator_.move(motion);
    truth_ = truth_ * motion.increment;
    stamp_ += std::chrono::seconds(1);
  }

  /// A step as the back-end makes it, without new landmarks.
  std::vector<RevisedAssociation> see(const std::vector<Eigen::Vector2d>& places,
                                      LandmarkId own_id = 7) {
    LandmarkObservationArray array;
    array.stamp = stamp_;
    for (const auto& place : places) {
      array.observations.push_back(seen(place));
      array.observations.back().id = own_id;
    }
    UpdateStatistics statistics;
    const auto association = associator_.associate(array, landmarks_, statistics, counters_);
    landmarks_.observe(association.matches, Pose2());
    delayed_.keep(array, association, landmarks_);
    auto told = delayed_.revise(associator_.descriptors(), landmarks_, counters_);
    path_.optimize(3);
    return told;
  }

  PathGraph path_;
  LandmarkGraph landmarks_{path_};
  Associator associator_;
  DelayedDecisions delayed_{GraphConfig()};
  Counters counters_;
  Pose2 truth_;
  Stamp stamp_ = stampFromNanoseconds(1000000000000);
  const Eigen::Vector2d left_{2.0, 5.0}, right_{2.35, 5.0};
  const std::vector<Eigen::Vector2d> others_ = {{4, 2}, {4, -2}, {7, 3}, {7, -3}};
};

TEST_F(DelayedDecisionsTest, DecidesWhenTheWayIsKnownBetter) {
  for (const auto& place : {left_, right_}) append(place);
  for (const auto& place : others_) append(place);
  path_.optimize(3);
  move(0.2);
  EXPECT_TRUE(see({left_}, 42).empty());
  ASSERT_EQ(counters_["ambiguous"], 1u) << "the robot may be 0.35 m to the side";
  const auto before = sightingsOf(landmarks_).count(0);
  std::vector<RevisedAssociation> told;
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(told.empty()) << "not before ten nodes have followed";
    move(0.002);
    told = see(others_);
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].observation.own_id, 42);
  EXPECT_EQ(told[0].observation.landmark, landmarks_.ids()[0]);
  EXPECT_EQ(told[0].observation.taken_for, TakenFor::kLandmark);
  EXPECT_EQ(told[0].stamp, stampFromNanoseconds(1001000000000));
  EXPECT_EQ(counters_["decided_later"], 1u);
  EXPECT_EQ(sightingsOf(landmarks_).count(0), before + 1);
}

TEST_F(DelayedDecisionsTest, TakesBackWhatDoesNotFitTheGraphAnyMore) {
  append(left_);
  for (const auto& place : others_) append(place);
  path_.optimize(3);
  for (int i = 0; i < 4; ++i) {
    move(0.002);
    see({left_});
  }
  move(0.2);
  see({right_});  // which is not in the map, and fits as the robot may be anywhere
  ASSERT_EQ(counters_["gated"] + counters_["ambiguous"], 0u);
  const auto sightings = sightingsOf(landmarks_).count(0);
  std::vector<RevisedAssociation> told;
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(told.empty());
    move(0.002);
    told = see(others_);
  }
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told[0].observation.taken_for, TakenFor::kTakenBack);
  EXPECT_EQ(told[0].stamp, stampFromNanoseconds(1005000000000));
  EXPECT_EQ(counters_["taken_back"], 1u);
  EXPECT_EQ(sightingsOf(landmarks_).count(0), sightings - 1);
  EXPECT_LT((landmarks_.point(0) - left_).norm(), 0.01) << "as if it had never been paired";
}

TEST_F(DelayedDecisionsTest, ForgetsWhatWaitedAtANodeThatIsRemoved) {
  for (const auto& place : {left_, right_}) append(place);
  for (const auto& place : others_) append(place);
  path_.optimize(3);
  move(0.2);
  see({left_});
  ASSERT_EQ(counters_["ambiguous"], 1u);
  delayed_.forget(*lastNodeOf(landmarks_));
  for (int i = 0; i < 40; ++i) {
    move(0.002);
    EXPECT_TRUE(see(others_).empty());
  }
}

}  // namespace
}  // namespace slam::graph_slam
