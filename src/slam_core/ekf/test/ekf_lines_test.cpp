// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/ekf/test/ekf_variants.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/line_model.hpp"

namespace slam::ekf {
namespace {

/// A room of 10 m x 8 m whose walls a robot sees that drives around in it, from the map's origin
/// on; with three posts.
class RoomOfWalls {
 public:
  explicit RoomOfWalls(std::uint64_t seed, bool has_posts = false)
      : has_posts_(has_posts), random_(seed, 0) {}

  struct Step {
    Motion motion;
    LandmarkObservationArray observations;
  };
  Step next() {
    const Eigen::Vector3d sigma(0.01, 0.01, 0.01);
    const Pose2 increment(0.25, 0.0, 0.125);
    truth_ = truth_ * increment;
    Step step;
    step.motion.increment = Pose2::fromVector(increment.vector() + sigma.cwiseProduct(gaussians()));
    step.motion.covariance = sigma.cwiseAbs2().asDiagonal();
    reckoned_ = reckoned_ * step.motion.increment;
    step.observations.sensor_pose = Pose2(0.1, 0.05, 0.2);
    for (std::size_t i = 0; i < walls_.size(); ++i)
      see(walls_[i], static_cast<LandmarkId>(i), step);
    for (std::size_t i = 0; has_posts_ && i < posts_.size(); ++i)
      see(posts_[i], static_cast<LandmarkId>(10 + i), step);
    return step;
  }
  const Pose2& truth() const { return truth_; }
  const Pose2& reckoned() const { return reckoned_; }

  struct Wall {
    Eigen::Vector2d middle;
    double direction, half;
  };
  const std::vector<Wall>& walls() const { return walls_; }

 private:
  Eigen::Vector3d gaussians() {
    return {random_.gaussian(), random_.gaussian(), random_.gaussian()};
  }
  LandmarkObservation observed(const Eigen::Vector2d& z, LandmarkId id) {
    const Eigen::Vector2d sigma(0.02, 0.01);
    LandmarkObservation observation;
    observation.id = id;
    observation.range = z.x() + sigma.x() * random_.gaussian();
    observation.bearing = wrapAngle(z.y() + sigma.y() * random_.gaussian());
    observation.covariance = sigma.cwiseAbs2().asDiagonal();
    return observation;
  }
  void see(const Wall& wall, LandmarkId id, Step& step) {
    const LineModel model(wall.middle);
    const auto& sensor = step.observations.sensor_pose;
    auto z = observed(model.predict(truth_, sensor, {0.0, wall.direction}), id);
    const Eigen::Vector2d along(-std::sin(wall.direction), std::cos(wall.direction));
    const double foot = along.dot((truth_ * sensor).position() - wall.middle);
    z.kind = LandmarkKind::kLine;
    z.extent = {-wall.half - foot, wall.half - foot};
    step.observations.observations.push_back(z);
  }
  void see(const Eigen::Vector2d& post, LandmarkId id, Step& step) {
    const RangeBearingModel model;
    step.observations.observations.push_back(
        observed(model.predict(truth_, step.observations.sensor_pose, post), id));
  }

  std::vector<Wall> walls_ = {
      {{5, 2}, 0.0, 4.0}, {{0, 6}, M_PI / 2, 5.0}, {{-5, 2}, M_PI, 4.0}, {{0, -2}, -M_PI / 2, 5.0}};
  std::vector<Eigen::Vector2d> posts_ = {{4, 5}, {-4, 4}, {-3, -1}};
  bool has_posts_;
  RandomStream random_;
  Pose2 truth_, reckoned_;
};

void drive(RoomOfWalls& room, EkfSlam& ekf, int steps) {
  for (int i = 0; i < steps; ++i) {
    const auto step = room.next();
    ekf.set(step.motion);
    ekf.set(step.observations);
    const auto status = ekf.execute();
    EXPECT_TRUE(status.isOk()) << status.message;
  }
}

EkfSlam configured(const EkfConfig& config) {
  EkfSlam ekf;
  ekf.configure(config);
  return ekf;
}

EkfConfig byPlace(const std::string& association = "jcbb") {
  EkfConfig config;
  config.association = association;
  return config;
}

double neesOf(const PoseEstimate& estimate, const Pose2& truth) {
  Eigen::Vector3d error = estimate.pose.vector() - truth.vector();
  error.z() = wrapAngle(error.z());
  return error.dot(estimate.covariance.inverse() * error);
}

/// Each wall once and where it is.
void expectWalls(const RoomOfWalls& room, const LandmarkMap& map) {
  for (const auto& wall : room.walls()) {
    const Eigen::Vector2d n(std::cos(wall.direction), std::sin(wall.direction));
    int found = 0;
    for (const auto& landmark : map) {
      const double turn = wrapAngle(landmark.direction - wall.direction);
      if (!landmark.isLine() || std::abs(turn) > 0.1) continue;
      ++found;
      EXPECT_NEAR(n.dot(landmark.position - wall.middle), 0.0, 0.1);
      EXPECT_NEAR(landmark.extent.end - landmark.extent.begin, 2.0 * wall.half, 0.5);
    }
    EXPECT_EQ(found, 1);
  }
}

TEST(EkfLines, WallsHoldTheRobotWhereItIs) {
  RoomOfWalls room(1);
  auto ekf = configured(EkfConfig());
  drive(room, ekf, 400);
  EXPECT_GT((room.reckoned().position() - room.truth().position()).norm(), 0.3);
  EXPECT_LT((ekf.pose().pose.position() - room.truth().position()).norm(), 0.05);
  EXPECT_LT(neesOf(ekf.pose(), room.truth()), 16.0);
  EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks().size(), 4u);
  expectWalls(room, as<LandmarkMapper>(ekf).landmarks());
}

class EkfLinesWith : public testing::TestWithParam<test::EkfVariant> {};

TEST_P(EkfLinesWith, IsAsWrongAsItSays) {
  const auto config = test::configOf(GetParam());
  double sum = 0.0;
  constexpr int kDrives = 40;
  for (int seed = 0; seed < kDrives; ++seed) {
    RoomOfWalls room(static_cast<std::uint64_t>(seed));
    auto ekf = configured(config);
    drive(room, ekf, 200);
    sum += neesOf(ekf.pose(), room.truth());
  }
  EXPECT_LT(sum / kDrives, 4.2);
  EXPECT_GT(sum / kDrives, 2.0);
}

INSTANTIATE_TEST_SUITE_P(All, EkfLinesWith, test::allVariants(),
                         [](const auto& variant) { return test::nameOf(variant.param); });

TEST(EkfLines, ANeighbourhoodOfTwoLandmarksTellsNearlyTheSame) {
  RoomOfWalls room(2), same_room(2);
  EkfConfig dense;
  dense.update = UpdateExtent::kDense;
  auto all = configured(dense);
  EkfConfig small;
  small.neighbourhood = 2;
  auto few = configured(small);
  drive(room, all, 200);
  drive(same_room, few, 200);
  EXPECT_LT((all.pose().pose.vector() - few.pose().pose.vector()).norm(), 1e-3);
}

TEST(EkfLines, AreToldApartByPlace) {
  for (const std::string association : {"jcbb", "nearest"}) {
    RoomOfWalls room(3), same_room(3);
    auto by_ids = configured(EkfConfig()), by_place = configured(byPlace(association));
    drive(room, by_ids, 300);
    drive(same_room, by_place, 300);
    EXPECT_EQ(as<LandmarkMapper>(by_place).landmarks().size(), 4u) << association;
    expectWalls(same_room, as<LandmarkMapper>(by_place).landmarks());
    EXPECT_LT((by_place.pose().pose.position() - by_ids.pose().pose.position()).norm(), 0.03);
  }
}

TEST(EkfLines, PointsAndLinesAreMappedTogether) {
  RoomOfWalls room(4, true);
  auto ekf = configured(byPlace());
  drive(room, ekf, 300);
  const auto map = as<LandmarkMapper>(ekf).landmarks();
  EXPECT_EQ(map.size(), 7u);
  EXPECT_EQ(pointsOf(map).size(), 3u);
  expectWalls(room, map);
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().used, 7);
  EXPECT_LT(neesOf(ekf.pose(), room.truth()), 16.0);
}

TEST(EkfLines, ALandmarkOfAnotherKindThanSeenIsGated) {
  RoomOfWalls room(5, true);
  auto ekf = configured(EkfConfig());
  drive(room, ekf, 20);
  auto step = room.next();
  auto& z = step.observations.observations;
  std::swap(z.front().id, z.back().id);
  ekf.set(step.motion);
  ekf.set(step.observations);
  ekf.execute();
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().gated, 2);
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().used, 5);
}

TEST(EkfLines, AMapOfThemIsLoadedAndKept) {
  RoomOfWalls room(6, true);
  auto first = configured(byPlace());
  drive(room, first, 200);
  const auto saved = as<MapKeeper>(first).state();
  auto config = byPlace();
  config.mode = BackendMode::kLocalization;
  auto second = configured(config);
  as<MapKeeper>(second).set(saved);
  drive(room, second, 100);
  EXPECT_LT((second.pose().pose.position() - room.truth().position()).norm(), 0.1);
  EXPECT_EQ(as<LandmarkMapper>(second).statistics().used, 7);
  const auto map = as<LandmarkMapper>(second).landmarks();
  ASSERT_EQ(map.size(), saved.landmarks.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    EXPECT_EQ(map[i].kind, saved.landmarks[i].kind);
    EXPECT_LT((map[i].position - saved.landmarks[i].position).norm(), 1e-12);
    EXPECT_EQ(map[i].direction, saved.landmarks[i].direction);
    EXPECT_EQ(map[i].extent.end, saved.landmarks[i].extent.end);
  }
}

TEST(EkfLines, TheBackOfAWallIsAnother) {
  auto ekf = configured(byPlace());
  LandmarkObservationArray array;
  LandmarkObservation z;
  z.kind = LandmarkKind::kLine;
  z.range = 1.0;
  z.covariance = Eigen::Vector2d(1e-4, 1e-4).asDiagonal();
  z.extent = {-2.0, 2.0};
  Motion stay, beyond;
  stay.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  beyond.covariance = stay.covariance;
  beyond.increment = Pose2(2.0, 0.0, 0.0);
  const auto see = [&](const Motion& motion, double bearing) {
    z.bearing = bearing;
    array.observations = {z};
    ekf.set(motion);
    ekf.set(array);
    ekf.execute();
    return as<LandmarkMapper>(ekf).landmarks().size();
  };
  for (int i = 0; i < 5; ++i) see(stay, 0.0);
  EXPECT_EQ(see(stay, 0.0), 1u);
  see(beyond, M_PI);
  for (int i = 0; i < 5; ++i) see(stay, M_PI);
  EXPECT_EQ(see(stay, M_PI), 2u);
}

}  // namespace
}  // namespace slam::ekf
