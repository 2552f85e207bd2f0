// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/invariant_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/mono_ekf/inverse_depth.hpp"
#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

TEST(InvariantStep, IsOneOfThePositionInTheFirstOrder) {
  const Eigen::Vector2d position(3.0, -2.0), step(1e-4, 2e-4);
  EXPECT_LT((stepped(position, step, MapStep{1e-4, 2e-4}) - position - step).norm(), 1e-7);
}

TEST(InvariantStep, TurnsAMapAboutAPlace) {
  const Eigen::Vector2d place(1.0, 2.0), position(4.0, 6.0);
  const double alpha = 0.5 * M_PI;
  // the error of a map that began at `place` with a wrong heading
  const Eigen::Vector2d step = alpha * turnedLeft(position - place);
  EXPECT_LT((stepped(position, step, MapStep{alpha, 0.0}) - Eigen::Vector2d(-3.0, 5.0)).norm(),
            1e-12);
  EXPECT_LT((stepped(place, {0.0, 0.0}, MapStep{alpha, 0.0}) - place).norm(), 1e-12);
}

TEST(InvariantStep, EnlargesAMapAboutAPlace) {
  const Eigen::Vector2d place(1.0, 2.0), position(4.0, 6.0);
  const double s = std::log(2.0);
  EXPECT_LT((stepped(position, s * (position - place), MapStep{0.0, s}) -
             (place + 2.0 * (position - place)))
                .norm(),
            1e-12);
  Feature feature;
  InverseDepth y(4.0, 6.0, 0.3, 0.1, 0.8), step(s * 3.0, s * 4.0, 0.0, 0.0, -s * 0.8);
  const InverseDepth larger(7.0, 10.0, 0.3, 0.1, 0.4);
  EXPECT_LT((stepped(feature, y, step, MapStep{0.0, s}) - larger).norm(), 1e-12);
}

TEST(InvariantStep, LeadsFromOnePlaceToAnother) {
  const Eigen::Vector2d from(3.0, -2.0), step(0.7, -0.4);
  Feature feature;
  const InverseDepth y(3.0, -2.0, 0.5, 0.1, 0.6), y_step(0.7, -0.4, 0.1, -0.2, 0.3);
  for (const MapStep& map :
       {MapStep{0.0, 0.0}, MapStep{1e-9, -1e-9}, MapStep{-0.8, 0.5}, MapStep{2.0, -1.0}}) {
    EXPECT_LT((stepBetween(from, stepped(from, step, map), map) - step).norm(), 1e-9);
    EXPECT_LT((stepBetween(feature, y, stepped(feature, y, y_step, map), map) - y_step).norm(),
              1e-9);
  }
}

/// This is the information that the state has on its scale: on a map that grows about the camera.
double informationOnScale(test::PointCloudFilter& filter) {
  const auto& state = filter.state();
  const Eigen::Vector3d centre = filter.drive().camera().centre(state.robot().pose);
  Eigen::VectorXd growth = Eigen::VectorXd::Zero(state.mean().size());
  for (const auto& feature : state.features()) {
    const auto y = coordinatesOf(state, feature);
    const int at = feature.offset;
    growth.segment<2>(at) = y.head<2>() - centre.head<2>();
    growth(at + feature.size() - 1) = feature.is_point ? y(2) - centre.z() : -y(4);
  }
  return growth.dot(state.covariance().ldlt().solve(growth));
}

/// No image shows how large the map is.
TEST(MonoState, GetsNoSurerOfTheScaleByWhatItSees) {
  test::PointCloudFilter filter(1);
  for (int i = 0; i < 20; ++i) {
    filter.step();
    filter.stepInTheDark();
    const double before = informationOnScale(filter);
    filter.measure(filter.drive().look());
    EXPECT_NEAR(informationOnScale(filter) / before, 1.0, 0.01) << i;
  }
}

/// No image shows where the map as a whole points to.
TEST(MonoState, GetsNoSurerOfItsFirstHeading) {
  constexpr double kSigma = 0.1;
  test::PointCloudFilter filter(1);
  filter.state().place({Pose2(), Eigen::Vector3d(1e-6, 1e-6, kSigma * kSigma).asDiagonal()});
  for (int i = 0; i < test::PointCloudDrive::kLap / 2; ++i) {
    filter.step();
    ASSERT_GT(std::sqrt(filter.state().robot().covariance(2, 2)), 0.999 * kSigma) << i;
  }
}

}  // namespace
}  // namespace slam::mono_ekf
