// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/experience_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::rat {
namespace {

using Arrival = ExperienceMap::Arrival;

PoseCellState state(std::int64_t view, const CellPlace& place, int second = 0) {
  PoseCellState state;
  state.stamp = Stamp(std::chrono::seconds(second));
  state.place = place;
  state.view = view;
  state.edge = 24;
  state.headings = 36;
  return state;
}

/// A square of 40 m, its views numbered; odometry measures lengths and turns too large.
class SquareDrive {
 public:
  explicit SquareDrive(ExperienceMap& map, double turn_error = 0.0, double scale = 1.0)
      : map_(map), turn_error_(turn_error), scale_(scale) {}

  Arrival next() {
    const int i = count_++ % 40;
    const Pose2 step(1.0, 0.0, i % 10 == 9 ? M_PI / 2 : 0.0);
    truth_ = truth_ * step;
    map_.move(Pose2(scale_ * step.x(), 0.0, step.theta() * (1.0 + turn_error_)));
    const CellPlace place{std::fmod(truth_.x() * 4.0 + 240.0, 24.0),
                          std::fmod(truth_.y() * 4.0 + 240.0, 24.0),
                          std::fmod(truth_.theta() * 36 / (2 * M_PI) + 36.0, 36.0)};
    const auto arrival = map_.arrive(state(i, place, count_));
    map_.relax();
    return arrival;
  }
  const Pose2& truth() const { return truth_; }

 private:
  ExperienceMap& map_;
  double turn_error_, scale_;
  int count_ = 0;
  Pose2 truth_;
};

TEST(ExperienceMap, HasAnExperienceForEachPlaceAndALoopWhereItCloses) {
  ExperienceMap map{ExperienceConfig()};
  SquareDrive drive(map);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(drive.next(), Arrival::kNew) << i;
  EXPECT_EQ(drive.next(), Arrival::kLoop);
  for (int i = 0; i < 39; ++i) EXPECT_EQ(drive.next(), Arrival::kKnown) << i;
  EXPECT_EQ(map.experiences().size(), 40U);
  EXPECT_EQ(map.links().size(), 40U);
  EXPECT_LT((map.pose().position() - drive.truth().position()).norm(), 1e-6);
}

TEST(ExperienceMap, ClosesUpWhatOdometryHasLeftOpen) {
  ExperienceConfig config;
  config.relaxations = 100;
  ExperienceMap map{config};
  SquareDrive drive(map, 0.1, 1.03);
  for (int i = 0; i < 40; ++i) drive.next();
  const double open = (map.pose().position() - drive.truth().position()).norm();
  EXPECT_GT(open, 3.0);
  for (int i = 0; i < 80; ++i) drive.next();
  const auto& experiences = map.experiences();
  const double gap =
      (experiences.front().pose.position() - experiences.back().pose.position()).norm();
  EXPECT_NEAR(gap, 1.0, 0.4) << "first and last are neighbours";
  for (const auto& link : map.links()) {
    const auto led = experiences[link.from].pose * link.way;
    EXPECT_LT((led.position() - experiences[link.to].pose.position()).norm(), 0.4);
  }
}

TEST(ExperienceMap, TellsPlacesApartThatLookAlike) {
  ExperienceMap map{ExperienceConfig()};
  EXPECT_EQ(map.arrive(state(7, {0, 0, 0})), Arrival::kNew);
  map.move(Pose2(2.0, 0.0, 0.0));
  EXPECT_EQ(map.arrive(state(7, {8, 0, 0})), Arrival::kNew) << "the same view, another place";
  map.move(Pose2(2.0, 0.0, 0.0));
  EXPECT_EQ(map.arrive(state(7, {16, 0, 0})), Arrival::kNew);
  EXPECT_EQ(map.arrive(state(7, {23.9, 0, 35.8})), Arrival::kLoop) << "around the torus";
  EXPECT_EQ(*map.current(), 0U);
}

TEST(ExperienceMap, StaysWhereItIsWithoutAView) {
  ExperienceMap map{ExperienceConfig()};
  EXPECT_EQ(map.arrive(state(kNoView, {0, 0, 0})), Arrival::kNowhere);
  EXPECT_FALSE(map.current().has_value());
  map.arrive(state(1, {0, 0, 0}));
  map.move(Pose2(1.0, 0.0, 0.3));
  EXPECT_EQ(map.arrive(state(kNoView, {4, 0, 2})), Arrival::kNowhere);
  EXPECT_LT((map.pose().vector() - Eigen::Vector3d(1.0, 0.0, 0.3)).norm(), 1e-12);
}

TEST(ExperienceMap, DoesNotLinkWhereTheRobotWasCarried) {
  ExperienceMap map{ExperienceConfig()};
  map.arrive(state(1, {0, 0, 0}));
  map.placeAt(Pose2(5.0, 5.0, 1.0));
  EXPECT_EQ(map.arrive(state(2, {8, 8, 8})), Arrival::kNew);
  EXPECT_TRUE(map.links().empty());
  EXPECT_EQ(map.experiences()[1].pose.vector(), Eigen::Vector3d(5.0, 5.0, 1.0));
}

TEST(ExperienceMap, StaysWhereSomebodyPlacesItThoughItKnowsTheView) {
  ExperienceMap map{ExperienceConfig()};
  map.arrive(state(1, {0, 0, 0}));
  map.placeAt(Pose2(5.0, 5.0, 1.0));
  EXPECT_EQ(map.arrive(state(1, {0, 0, 0})), Arrival::kNew);
  EXPECT_EQ(map.arrive(state(1, {0, 0, 0})), Arrival::kStayed);
  EXPECT_TRUE(map.links().empty());
  EXPECT_EQ(map.pose().vector(), Eigen::Vector3d(5.0, 5.0, 1.0));
}

TEST(ExperienceMap, DoesNotGrowBeyondItsLimit) {
  ExperienceConfig config;
  config.most_experiences = 1;
  ExperienceMap map{config};
  map.arrive(state(1, {0, 0, 0}));
  map.move(Pose2(1.0, 0.0, 0.0));
  EXPECT_EQ(map.arrive(state(2, {4, 0, 0})), Arrival::kNowhere);
  EXPECT_EQ(map.experiences().size(), 1U);
  EXPECT_LT((map.pose().position() - Eigen::Vector2d(1.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(map.arrive(state(1, {0, 0, 0})), Arrival::kStayed);
}

}  // namespace
}  // namespace slam::rat
