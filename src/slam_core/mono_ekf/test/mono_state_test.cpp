// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/mono_state.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>

#include "slam_core/geometry/test/numeric_jacobian.hpp"
#include "slam_core/mono_ekf/consensus.hpp"
#include "slam_core/mono_ekf/feature_seeds.hpp"
#include "slam_core/mono_ekf/invariant_step.hpp"
#include "slam_core/mono_ekf/test/point_cloud_filter.hpp"

namespace slam::mono_ekf {
namespace {

using test::PointCloudDrive;
using test::PointCloudFilter;

const auto kDifference = [](const auto& a, const auto& b) { return (a - b).eval(); };

/// A state of features of both kinds.
MonoState someState() {
  PointCloudFilter filter(3);
  for (int i = 0; i < 12; ++i) filter.step();
  return filter.state();
}

const Feature& firstOf(const MonoState& state, bool is_point) {
  for (const auto& feature : state.features())
    if (feature.is_point == is_point) return feature;
  throw std::logic_error("the state has no such feature");
}

TEST(PredictedPixel, HasTheJacobiansOfNumericDerivatives) {
  const auto state = someState();
  const auto camera = test::forwardCamera();
  for (const bool is_point : {false, true}) {
    const auto& feature = firstOf(state, is_point);
    const Eigen::VectorXd coordinates = coordinatesOf(state, feature);
    const Eigen::Vector3d pose = state.robot().pose.vector() + Eigen::Vector3d(0.1, 0.05, 0.02);
    const auto prediction = predictedPixel(camera, Pose2::fromVector(pose), feature, coordinates);
    ASSERT_TRUE(prediction);
    const auto of_pose = test::numericJacobian(
        [&](const Eigen::VectorXd& x) {
          return predictedPixel(camera, Pose2::fromVector(x.head<3>()), feature, coordinates)
              ->pixel;
        },
        pose, kDifference);
    const auto of_feature = test::numericJacobian(
        [&](const Eigen::VectorXd& y) {
          return predictedPixel(camera, Pose2::fromVector(pose), feature, y)->pixel;
        },
        coordinates, kDifference);
    EXPECT_LT((prediction->J_pose - of_pose).norm(), 1e-4 * of_pose.norm()) << is_point;
    EXPECT_LT((prediction->J_feature - of_feature).norm(), 1e-4 * of_feature.norm()) << is_point;
  }
}

TEST(RaySeed, HasTheJacobiansOfNumericDerivatives) {
  const auto camera = test::forwardCamera();
  const Eigen::Vector3d pose(0.3, -0.4, 0.8);
  const Eigen::Vector2d pixel(150.0, 310.0);
  const auto seed = raySeed(pixel, camera, Pose2::fromVector(pose), 0.4);
  ASSERT_TRUE(seed);
  const auto of_pose = test::numericJacobian(
      [&](const Eigen::VectorXd& x) {
        return raySeed(pixel, camera, Pose2::fromVector(x.head<3>()), 0.4)->coordinates;
      },
      pose, kDifference);
  const auto of_pixel = test::numericJacobian(
      [&](const Eigen::VectorXd& z) {
        return raySeed(z.head<2>(), camera, Pose2::fromVector(pose), 0.4)->coordinates;
      },
      pixel, kDifference);
  EXPECT_LT((seed->J_pose - of_pose).norm(), 1e-5);
  EXPECT_LT((seed->J_pixel - of_pixel).norm(), 1e-5);
}

TEST(MonoState, UpdatesAsTheTextbookDoesWithInvariantErrors) {
  auto state = someState();
  const auto camera = test::forwardCamera();
  std::vector<Measurement> measurements;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(0, state.mean().size());
  Eigen::VectorXd nu;
  for (const auto& feature : state.features()) {
    const auto prediction =
        predictedPixel(camera, state.robot().pose, feature, coordinatesOf(state, feature));
    if (!prediction || measurements.size() == 6) continue;
    const Eigen::Vector2d residual(0.3 * static_cast<double>(measurements.size()), -0.5);
    measurements.push_back({feature.offset, *prediction, residual});
    H.conservativeResizeLike(Eigen::MatrixXd::Zero(H.rows() + 2, H.cols()));
    H.block<2, 3>(H.rows() - 2, 0) = prediction->J_pose;
    H.block(H.rows() - 2, feature.offset, 2, feature.size()) = prediction->J_feature;
    nu.conservativeResize(H.rows());
    nu.tail<2>() = residual;
  }
  const Eigen::MatrixXd P = state.covariance();
  const Eigen::MatrixXd S =
      H * P * H.transpose() + 0.49 * Eigen::MatrixXd::Identity(H.rows(), H.rows());
  const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
  std::vector<int> offsets;
  for (const auto& each : measurements) offsets.push_back(each.offset);
  const ScaleError scale(state, offsets);
  const Eigen::VectorXd step = K * nu;
  const Eigen::VectorXd mean = stepped(state, step, scale.of(step));
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(mean.size(), mean.size());
  const Eigen::RowVectorXd of_scale = scale.rowsOf(identity);
  Eigen::MatrixXd J_moved = identity;
  J_moved.block<2, 1>(0, 2) += turnedLeft(mean.head<2>() - state.mean().head<2>());
  J_moved.topRows<2>() += (mean.head<2>() - state.mean().head<2>()) * of_scale;
  for (const auto& feature : state.features()) {
    const int at = feature.offset, size = feature.size();
    const Eigen::VectorXd moved = mean.segment(at, size) - state.mean().segment(at, size);
    J_moved.block(at, 2, size, 1) += addedByHeading(moved);
    J_moved.middleRows(at, size) += addedByScale(feature, moved) * of_scale;
  }
  const Eigen::MatrixXd covariance = J_moved * (P - K * S * K.transpose()) * J_moved.transpose();
  EXPECT_NEAR(state.update(measurements, 0.7).nis, nu.dot(S.inverse() * nu), 1e-6);
  EXPECT_LT((state.mean() - mean).norm(), 1e-8);
  EXPECT_LT((state.covariance() - covariance).norm(), 1e-8);
}

/// Features that are taken for others call for such a correction, for which the linearisation does
/// not hold.
TEST(MonoState, IsNotMovedFartherThanItsCovarianceAllows) {
  auto state = someState();
  const auto before = state;
  const auto& feature = state.features().front();
  const auto prediction = predictedPixel(test::forwardCamera(), state.robot().pose, feature,
                                         coordinatesOf(state, feature));
  ASSERT_TRUE(prediction);
  for (const double residual : {1e4, 1e300, std::nan("")}) {
    const Measurement far = {feature.offset, *prediction, Eigen::Vector2d(residual, 0.0)};
    EXPECT_FALSE(state.update({far}, 0.7).is_credible) << residual;
    EXPECT_EQ(state.mean(), before.mean());
    EXPECT_EQ(state.covariance(), before.covariance());
  }
}

TEST(MonoState, KeepsTheGaussianOfTheOthersWhenAFeatureIsRemoved) {
  auto state = someState();
  const auto before = state;
  std::vector<bool> kept(state.features().size(), true);
  kept[1] = kept[4] = false;
  state.keep(kept);
  ASSERT_EQ(state.features().size(), before.features().size() - 2);
  std::size_t i = 0;
  for (const auto& old : before.features()) {
    if (!kept[static_cast<std::size_t>(&old - before.features().data())]) continue;
    const auto& feature = state.features()[i++];
    EXPECT_EQ(feature.id, old.id);
    EXPECT_EQ(coordinatesOf(state, feature), coordinatesOf(before, old));
    EXPECT_EQ(state.covariance().block(0, feature.offset, 3, feature.size()),
              before.covariance().block(0, old.offset, 3, old.size()));
  }
}

TEST(MonoState, TakesOutTheCorrelationsOfARobotThatIsPlacedElsewhere) {
  auto state = someState();
  const Eigen::Matrix3d P = 0.04 * Eigen::Matrix3d::Identity();
  state.place({Pose2(1.0, 2.0, 0.5), P});
  EXPECT_EQ(state.robot().pose.vector(), Eigen::Vector3d(1.0, 2.0, 0.5));
  EXPECT_EQ(state.robot().covariance, P);
  EXPECT_EQ(state.covariance().topRightCorner(3, state.mean().size() - 3).norm(), 0.0);
}

TEST(MonoState, LearnsTheDepthOfPointsAndTheScaleFromOdometry) {
  PointCloudFilter filter(5);
  for (int i = 0; i < PointCloudDrive::kLap; ++i) filter.step();
  int points = 0;
  for (const auto& feature : filter.state().features()) {
    if (!feature.is_point) continue;
    ++points;
    EXPECT_LT((coordinatesOf(filter.state(), feature) - filter.truthOf(feature)).norm(), 0.5);
  }
  EXPECT_GT(points, 100);
}

TEST(MonoState, StaysSymmetricAndPositiveDefinite) {
  PointCloudFilter filter(6);
  for (int i = 0; i < 60; ++i) {
    filter.step();
    const auto& P = filter.state().covariance();
    ASSERT_TRUE(P.allFinite() && filter.state().mean().allFinite());
    ASSERT_LT((P - P.transpose()).norm(), 1e-12 * P.norm());
    if (i % 10 == 0) {
      const auto I = Eigen::MatrixXd::Identity(P.rows(), P.cols());
      ASSERT_EQ(Eigen::LLT<Eigen::MatrixXd>(P + 1e-9 * I).info(), Eigen::Success) << i;
    }
  }
}

TEST(Consensus, LeavesOutMatchesThatAreWrong) {
  PointCloudFilter filter(7);
  for (int i = 0; i < 30; ++i) filter.step();
  auto& state = filter.state();
  std::vector<Match> matches;
  for (std::size_t i = 0; i < state.features().size() && matches.size() < 30; ++i) {
    const auto& feature = state.features()[i];
    const auto prediction = predictedPixel(filter.drive().camera(), state.robot().pose, feature,
                                           coordinatesOf(state, feature));
    const bool is_sure =
        prediction && predictedCovariance(state, feature.offset, *prediction).trace() < 9.0;
    if (is_sure) matches.push_back({i, prediction->pixel});
  }
  ASSERT_GE(matches.size(), 10U);
  for (std::size_t i = 0; i < matches.size(); i += 4) matches[i].pixel += Eigen::Vector2d(15, 9);
  const auto consensus = consensusOf(state, matches, filter.drive().camera(), 1.0);
  for (std::size_t i = 0; i < matches.size(); ++i) EXPECT_EQ(consensus.agrees[i], i % 4 != 0) << i;
}

TEST(Consensus, OfNoMatchesIsNone) {
  PointCloudFilter filter(7);
  const auto consensus = consensusOf(filter.state(), {}, filter.drive().camera(), 1.0);
  EXPECT_TRUE(consensus.agrees.empty());
  EXPECT_EQ(filter.state().update(consensus.measurements, 1.0).nis, 0.0);
}

}  // namespace
}  // namespace slam::mono_ekf
