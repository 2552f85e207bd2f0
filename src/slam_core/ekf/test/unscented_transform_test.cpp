// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/unscented_transform.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam::ekf {
namespace {

using Matrix26 = Eigen::Matrix<double, 2, 6>;

constexpr int kSamples = 40000;

Eigen::Vector3d gaussian3(RandomStream& random) {
  const double x = random.gaussian(), y = random.gaussian();
  return {x, y, random.gaussian()};
}

Matrix26 jacobianOf(const Innovation& h) {
  Matrix26 H;
  H << h.H_robot, h.H_heading, h.H_landmark;
  return H;
}

/// A robot that looks at a landmark, with every linearisation.
class UnscentedObservation : public testing::TestWithParam<std::string> {
 protected:
  /// @param range of the landmark [m], which lies `behind` (bearing pi) or ahead
  void lookAt(double range, bool behind = false) {
    const auto m = robot.transform({behind ? -range : range, 0.0});
    landmark = {m, m, m};
    z.range = range;
    z.bearing = behind ? M_PI : 0.0;
    z.covariance = Eigen::Vector2d(1e-4, 1e-5).asDiagonal();
  }
  /// Errors of robot and reference that are the same at first, and of the landmark.
  static ObservedCovariance covariance(double position, double heading, double of_landmark) {
    Eigen::Matrix<double, 6, 5> roots = Eigen::Matrix<double, 6, 5>::Zero();
    roots(0, 0) = roots(1, 1) = position;
    roots(2, 2) = roots(3, 2) = heading;
    roots(4, 3) = roots(5, 4) = of_landmark;
    return roots * roots.transpose();
  }
  Innovation extended() const {
    return linearization->innovation(model, robot, robot, sensor, landmark, z);
  }
  Innovation unscented(const ObservedCovariance& P) const {
    auto innovation = extended();
    UnscentedTransform().observe({model, robot, sensor, landmark, z}, P, innovation);
    return innovation;
  }

  const std::unique_ptr<Linearization> linearization = makeLinearization(GetParam());
  RangeBearingModel model;
  const Pose2 robot{3.0, -2.0, 0.7}, sensor;
  LandmarkPoint landmark;
  LandmarkObservation z;
};

TEST_P(UnscentedObservation, IsTheExtendedOneWhereErrorsAreSmall) {
  lookAt(4.0);
  const auto small = unscented(covariance(1e-4, 1e-4, 1e-4)), plain = extended();
  EXPECT_LT((jacobianOf(small) - jacobianOf(plain)).norm(), 1e-6);
  EXPECT_LT((small.nu - plain.nu).norm(), 1e-7);
  EXPECT_LT((small.R - plain.R).norm(), 1e-12);
}

TEST_P(UnscentedObservation, IsTheExtendedOneWhereNothingIsInDoubt) {
  lookAt(4.0);
  const auto certain = unscented(ObservedCovariance::Zero()), plain = extended();
  EXPECT_LT((jacobianOf(certain) - jacobianOf(plain)).norm(), 1e-6);
  EXPECT_LT((certain.R - plain.R).norm(), 1e-12);
}

TEST_P(UnscentedObservation, SeesNothingWhereTheLinearisationDoesNot) {
  lookAt(2.0);
  landmark.start += Eigen::Vector2d(0.1, -0.2);  // where estimates have moved since
  landmark.first += Eigen::Vector2d(-0.3, 0.1);
  const Eigen::MatrixXd nothing = jacobianOf(extended()).fullPivLu().kernel();
  ASSERT_EQ(nothing.cols(), 4);
  EXPECT_LT((jacobianOf(unscented(covariance(0.5, 0.2, 0.5))) * nothing).norm(), 1e-12);
}

TEST_P(UnscentedObservation, HasTheMeanOfManySamplesAndNearlyTheirCovariance) {
  lookAt(1.0);
  const double sigma = 0.25;  // of the landmark alone: the model is all that is curved
  RandomStream random{5, 0};
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = z.covariance;
  for (int i = 0; i < kSamples; ++i) {
    const double x = random.gaussian();
    const Eigen::Vector2d m = landmark.now + sigma * Eigen::Vector2d(x, random.gaussian());
    const auto d = model.innovation(model.predict(robot, sensor, m), {1.0, 0.0});
    mean += d / kSamples;
    squares += d * d.transpose() / kSamples;
  }
  const auto P = covariance(0.0, 0.0, sigma);
  const auto h = unscented(P);
  const Matrix26 H = jacobianOf(h);
  const Eigen::Matrix2d of_samples = squares - mean * mean.transpose();
  EXPECT_NEAR(h.nu.x(), -mean.x(), 0.1 * mean.x());
  EXPECT_LT((H * P * H.transpose() + h.R - of_samples).norm(), 0.12 * of_samples.norm());
}

TEST_P(UnscentedObservation, AveragesBearingsOnTheCircle) {
  lookAt(2.0, true);
  const auto h = unscented(covariance(0.1, 0.1, 0.3));
  EXPECT_LT(std::abs(h.nu.y()), 1e-3);
  EXPECT_LT(h.R(1, 1), 0.01);
}

TEST_P(UnscentedObservation, StaysFiniteWhereTheLandmarkMayBeOnTopOfTheSensor) {
  lookAt(0.5);
  const auto h = unscented(covariance(3.0, 1.0, 3.0));
  EXPECT_TRUE(jacobianOf(h).allFinite() && h.nu.allFinite());
  EXPECT_EQ(h.R.llt().info(), Eigen::Success);
}

INSTANTIATE_TEST_SUITE_P(All, UnscentedObservation, testing::ValuesIn(linearizationNames()),
                         [](const auto& name) { return name.param; });

/// A robot that moves while its heading is in doubt, with every linearisation.
class UnscentedMotion : public testing::TestWithParam<std::string> {
 protected:
  Pose2 sample(RandomStream& random, const Eigen::Matrix3d& L) const {
    return linearization->moved(robot.pose, L * gaussian3(random));
  }

  const std::unique_ptr<Linearization> linearization = makeLinearization(GetParam());
  const PoseEstimate robot{{20.0, 10.0, 0.4}, Eigen::Vector3d(0.01, 0.02, 0.04).asDiagonal()};
  const Pose2 increment{1.5, 0.2, 0.3};
  const Eigen::Matrix3d Q = Eigen::Vector3d(4e-4, 1e-4, 9e-4).asDiagonal();
  const UnscentedTransform unscented;
};

TEST_P(UnscentedMotion, HasTheMomentsOfManySamples) {
  const auto moved = unscented.predict(*linearization, robot, increment, Q);
  const Eigen::Matrix3d L = robot.covariance.llt().matrixL(), N = Q.llt().matrixL();
  RandomStream random{9, 0};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const auto before = sample(random, L);
    const auto noise = Pose2::fromVector(increment.vector() + N * gaussian3(random));
    const auto e = linearization->correctionTo(moved.robot, before * noise);
    mean += e / kSamples;
    squares += e * e.transpose() / kSamples;
  }
  const Eigen::Matrix3d P =
      moved.error.F * robot.covariance * moved.error.F.transpose() + moved.error.Q;
  EXPECT_LT(mean.norm(), 0.01);
  EXPECT_LT((P - squares).norm(), 0.04 * P.norm());
}

TEST_P(UnscentedMotion, IsTheExtendedOneWhereErrorsAreSmall) {
  const PoseEstimate certain{robot.pose, 1e-8 * robot.covariance};
  const auto moved = unscented.predict(*linearization, certain, increment, 1e-8 * Q);
  const auto plain = TaylorTransform().predict(*linearization, certain, increment, 1e-8 * Q);
  EXPECT_LT((moved.robot.vector() - plain.robot.vector()).norm(), 1e-8);
  EXPECT_LT((moved.error.F - plain.error.F).norm(), 1e-8);
  EXPECT_LT((moved.error.Q - plain.error.Q).norm(), 1e-15);
  EXPECT_EQ(moved.G, plain.G);
}

TEST_P(UnscentedMotion, IsTheExtendedOneWhereTheHeadingMayBeAnything) {
  PoseEstimate lost = robot;
  lost.covariance(2, 2) = 4.0;
  const auto moved = unscented.predict(*linearization, lost, increment, Q);
  const auto plain = TaylorTransform().predict(*linearization, lost, increment, Q);
  EXPECT_EQ(moved.robot.vector(), plain.robot.vector());
  EXPECT_EQ(moved.error.Q, plain.error.Q);
}

TEST_P(UnscentedMotion, StaysPutWithACovarianceThatIsSingular) {
  const PoseEstimate exact{robot.pose, Eigen::Matrix3d::Zero()};
  const auto moved = unscented.predict(*linearization, exact, {}, Eigen::Matrix3d::Zero());
  EXPECT_LT((moved.robot.vector() - robot.pose.vector()).norm(), 1e-12);
  EXPECT_LT(moved.error.Q.norm(), 1e-12);
}

TEST_P(UnscentedMotion, ReportsTheMeanSquaredErrorOfManySamples) {
  const Eigen::Matrix3d L = robot.covariance.llt().matrixL();
  RandomStream random{3, 0};
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    Eigen::Vector3d e = L * gaussian3(random);
    e.head<2>() = linearization->moved(robot.pose, e).position() - robot.pose.position();
    squares += e * e.transpose() / kSamples;
  }
  const auto reported = unscented.meanSquaredError(*linearization, robot);
  EXPECT_LT((reported - squares).norm(), 0.03 * squares.norm());
}

TEST_P(UnscentedMotion, FindsTheCorrectionThatWasApplied) {
  const Eigen::Vector3d dx(0.3, -0.5, 0.8);
  const auto moved = linearization->moved(robot.pose, dx);
  EXPECT_LT((linearization->correctionTo(robot.pose, moved) - dx).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, UnscentedMotion, testing::ValuesIn(linearizationNames()),
                         [](const auto& name) { return name.param; });

TEST(GaussianTransform, OfTheExtendedFilterReportsItsOwnCovariance) {
  const PoseEstimate robot{{1.0, 2.0, 3.0}, Eigen::Vector3d(1.0, 2.0, 0.5).asDiagonal()};
  EXPECT_EQ(TaylorTransform().meanSquaredError(*makeLinearization("right_invariant"), robot),
            robot.covariance);
}

}  // namespace
}  // namespace slam::ekf
