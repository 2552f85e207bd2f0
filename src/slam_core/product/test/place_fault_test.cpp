// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/place_fault.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/fault_world.hpp"

namespace slam {
namespace {

using test::oneSays;

PoseEstimate good() { return {Pose2(1.0, 2.0, 3.0), 0.01 * Eigen::Matrix3d::Identity()}; }

/// Two landmarks, known from one place.
MapState goodMap() {
  MapState map{good(), {}, {}};
  for (const LandmarkId id : {4, 9}) {
    Landmark landmark;
    landmark.id = id;
    landmark.position = Eigen::Vector2d(double(id), 0.5);
    landmark.covariance = 0.04 * Eigen::Matrix2d::Identity();
    map.landmarks.push_back(landmark);
  }
  map.joint_covariance = 0.04 * Eigen::MatrixXd::Identity(7, 7);
  return map;
}

std::vector<std::string> saidOf(const std::function<void(MapState&)>& spoil) {
  auto map = goodMap();
  spoil(map);
  return {faultOf(map)};
}

TEST(PlaceFault, IsNoneOfAGoodPoseOrMap) {
  EXPECT_EQ(faultOf(good()), "");
  EXPECT_EQ(faultOf(PoseEstimate{}), "") << "known exactly";
  EXPECT_EQ(faultOf(goodMap()), "");
  EXPECT_EQ(faultOf(MapState{}), "");
}

TEST(PlaceFault, OfAPoseIsTold) {
  const auto said = [](const Pose2& pose, const Eigen::Matrix3d& P) {
    return std::vector<std::string>{faultOf(PoseEstimate{pose, P})};
  };
  const Eigen::Matrix3d P = good().covariance;
  EXPECT_TRUE(oneSays(said(Pose2(0.0, std::nan(""), 0.0), P), {"the pose", "not a number"}));
  for (const double far : {1e9, 1e100, -1e300})
    EXPECT_TRUE(oneSays(said(Pose2(0.0, far, 0.0), P), {"the pose", "100000 km", "origin"}));
  Eigen::Matrix3d crooked = P, negative = P;
  crooked(0, 1) = 0.5;
  negative(2, 2) = -1e-3;
  EXPECT_TRUE(oneSays(said(Pose2(), crooked), {"covariance", "not positive definite"}));
  EXPECT_TRUE(oneSays(said(Pose2(), negative), {"covariance", "not positive definite"}));
}

TEST(PlaceFault, OfALandmarkNamesIt) {
  const auto of = [](const std::function<void(Landmark&)>& spoil) {
    return saidOf([&](MapState& map) { spoil(map.landmarks[1]); });
  };
  EXPECT_TRUE(oneSays(of([](auto& l) { l.position.x() = 1e100; }), {"landmark 9", "100000 km"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.position.y() = INFINITY; }), {"landmark 9", "number"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.direction = std::nan(""); }), {"landmark 9", "number"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.covariance(0, 0) = -1.0; }), {"landmark 9", "positive"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.covariance *= 1e30; }), {"landmark 9", "not known to"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.id = 4; }), {"landmark 4", "twice"}));
  EXPECT_TRUE(oneSays(of([](auto& l) { l.id = 3; }), {"landmark 3", "out of order"}));
}

TEST(PlaceFault, OfTheRestOfAMapNamesThePart) {
  EXPECT_TRUE(oneSays(saidOf([](auto& map) { map.joint_covariance.resize(5, 7); }),
                      {"joint covariance", "not as large"}));
  EXPECT_TRUE(oneSays(saidOf([](auto& map) { map.joint_covariance(6, 0) = 1.0; }),
                      {"joint covariance", "positive"}));
  const auto with = [](const OccupancyGrid& grid) {
    return saidOf([&](MapState& map) { map.grid = grid; });
  };
  EXPECT_TRUE(oneSays(with({0.1, {0.0, 0.0}, 2, 2, {0, 0, 0}}), {"the grid", "cells"}));
  EXPECT_TRUE(oneSays(with({std::nan(""), {0.0, 0.0}, 1, 1, {0}}), {"the grid's resolution"}));
  EXPECT_TRUE(oneSays(with({0.1, {0.0, 1e100}, 1, 1, {0}}), {"the grid's origin", "100000 km"}));
}

class PlaceDoor : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings({}, {}, {"backend=" + GetParam()});
    product.configure(settings);
    for (auto& input : world.begin()) input(product);
    drive(20);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i)
      for (const auto& message : world.next()) {
        std::visit([this](const auto& value) { product.set(value); }, message);
        ASSERT_NE(product.execute().level, Status::Level::kError);
      }
    ASSERT_LT(
        (product.estimator().backend().pose().pose.position() - world.truth().position()).norm(),
        1.0);
  }

  test::FaultWorld world{1, false, true};
  MetaCoordinator product;
};

TEST_P(PlaceDoor, RefusesAPoseThatIsNowhereAndTheDriveGoesOn) {
  for (const double x : {1e100, 1e300, std::nan("")}) {
    auto place = good();
    place.pose = Pose2(x, 0.0, 0.0);
    const auto status = product.estimator().set(place);
    EXPECT_EQ(status.level, Status::Level::kError);
    EXPECT_TRUE(oneSays({status.message}, {"the pose", "it is left out"}));
    drive(5);
  }
}

TEST_P(PlaceDoor, RefusesAMapWithALandmarkThatIsNowhereAndTheDriveGoesOn) {
  auto map = product.estimator().capabilities().find<MapKeeper>()->state();
  ASSERT_FALSE(map.landmarks.empty());
  map.landmarks.front().position.x() = 1e100;
  const auto status = product.set(map);
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_TRUE(oneSays({status.message}, {"landmark", "100000 km", "all stays as it is"}));
  drive(20);
}

INSTANTIATE_TEST_SUITE_P(Backends, PlaceDoor, testing::Values("ekf", "pf", "graph", "seif"),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace slam
