// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/observation_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/random.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"
#include "slam_core/models/line_model.hpp"

namespace slam {
namespace {

/// A landmark that a sensor sees at this range and bearing.
struct PointCase {
  RangeBearingModel model;
  static Eigen::Vector2d landmarkAt(const Pose2& T_map_sensor, double range, double bearing) {
    return T_map_sensor.transform({range * std::cos(bearing), range * std::sin(bearing)});
  }
};
struct LineCase {
  const Eigen::Vector2d anchor{3.0, -2.0};
  LineModel model{anchor};
  Eigen::Vector2d landmarkAt(const Pose2& T_map_sensor, double range, double bearing) const {
    const double direction = wrapAngle(T_map_sensor.theta() + bearing);
    const Eigen::Vector2d n(std::cos(direction), std::sin(direction));
    return {n.dot(T_map_sensor.position() + range * n - anchor), direction};
  }
};

/// What every observation model promises.
template <class Case>
class ObservationModelContract : public testing::Test {
 protected:
  /// Calls check(robot, sensor, landmark) for random ones; every other sensor sits at the centre.
  template <class Check>
  void forRandomCases(Check&& check) const {
    RandomStream random(1, 0);
    for (int i = 0; i < 300; ++i) {
      const Pose2 robot(3 * random.gaussian(), 3 * random.gaussian(), 3 * random.gaussian());
      const Pose2 sensor = i % 2 == 0 ? Pose2()
                                      : Pose2(0.5 * random.gaussian(), 0.5 * random.gaussian(),
                                              3 * random.gaussian());
      const double range = 0.3 + 5 * random.uniform(), angle = 2 * M_PI * random.uniform();
      check(robot, sensor, case_.landmarkAt(robot * sensor, range, angle));
    }
  }
  Case case_;
  const ObservationModel& model_ = case_.model;
};

using Models = testing::Types<PointCase, LineCase>;
TYPED_TEST_SUITE(ObservationModelContract, Models);

TYPED_TEST(ObservationModelContract, PredictsWithTheNumericJacobians) {
  const auto& model = this->model_;
  const auto minus = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return model.innovation(a, b);
  };
  this->forRandomCases([&](const Pose2& robot, const Pose2& sensor, const Eigen::Vector2d& m) {
    ObservationModel::Jacobian23 J_robot;
    Eigen::Matrix2d J_m;
    model.predict(robot, sensor, m, &J_robot, &J_m);
    const auto of_robot = [&](const Eigen::Vector3d& v) {
      return model.predict(Pose2::fromVector(v), sensor, m);
    };
    const auto of_m = [&](const Eigen::Vector2d& v) { return model.predict(robot, sensor, v); };
    ASSERT_LT((J_robot - test::numericJacobian(of_robot, robot.vector(), minus)).norm(), 1e-7);
    ASSERT_LT((J_m - test::numericJacobian(of_m, m, minus)).norm(), 1e-7);
  });
}

TYPED_TEST(ObservationModelContract, InvertsWithTheNumericJacobians) {
  const auto& model = this->model_;
  const auto minus = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return Eigen::Vector2d(a - b);
  };
  this->forRandomCases([&](const Pose2& robot, const Pose2& sensor, const Eigen::Vector2d& m) {
    const auto z = model.predict(robot, sensor, m);
    ObservationModel::Jacobian23 J_robot;
    Eigen::Matrix2d J_z;
    model.invert(robot, sensor, z, &J_robot, &J_z);
    const auto of_robot = [&](const Eigen::Vector3d& v) {
      return model.invert(Pose2::fromVector(v), sensor, z);
    };
    const auto of_z = [&](const Eigen::Vector2d& v) { return model.invert(robot, sensor, v); };
    ASSERT_LT((J_robot - test::numericJacobian(of_robot, robot.vector(), minus)).norm(), 1e-7);
    ASSERT_LT((J_z - test::numericJacobian(of_z, z, minus)).norm(), 1e-7);
  });
}

TYPED_TEST(ObservationModelContract, InvertUndoesPredict) {
  this->forRandomCases([&](const Pose2& robot, const Pose2& sensor, const Eigen::Vector2d& m) {
    const auto z = this->model_.predict(robot, sensor, m);
    ASSERT_LT((this->model_.invert(robot, sensor, z) - m).norm(), 1e-12);
    ASSERT_FALSE(this->model_.isSingular(z));
  });
}

TYPED_TEST(ObservationModelContract, IsSingularOnTopOfTheSensor) {
  const Pose2 robot(1, 2, 0.5), sensor(0.3, 0.1, 0.2);
  const auto m = this->case_.landmarkAt(robot * sensor, 0.0, 0.3);
  EXPECT_TRUE(this->model_.isSingular(this->model_.predict(robot, sensor, m)));
}

TEST(RangeBearingModel, IsEquation53WithTheSensorAtTheCentre) {
  const auto z = RangeBearingModel().predict(Pose2(1, 2, 0.25), Pose2(), {4, 6});
  EXPECT_NEAR(z.x(), 5.0, 1e-15);
  EXPECT_NEAR(z.y(), std::atan2(4.0, 3.0) - 0.25, 1e-15);
}

TEST(RangeBearingModel, IsEquation54WithTheSensorOffTheCentre) {
  // the thesis's sensor: a position, no rotation
  const double x = 1, y = -2, theta = 0.7, x_sens = 0.4, y_sens = -0.1, r = 3, phi = 0.5;
  const Eigen::Vector2d expected(
      x + std::cos(theta) * x_sens - std::sin(theta) * y_sens + r * std::cos(theta + phi),
      y + std::sin(theta) * x_sens + std::cos(theta) * y_sens + r * std::sin(theta + phi));
  const auto m = RangeBearingModel().invert(Pose2(x, y, theta), Pose2(x_sens, y_sens, 0), {r, phi});
  EXPECT_LT((m - expected).norm(), 1e-14);
}

TEST(RangeBearingModel, MeasuresTheBearingFromARotatedSensor) {
  const Pose2 looks_left(0, 0, M_PI / 2);
  const auto z = RangeBearingModel().predict(Pose2(), looks_left, {0, 2});
  EXPECT_NEAR(z.x(), 2.0, 1e-15);
  EXPECT_NEAR(z.y(), 0.0, 1e-15);
}

TEST(RangeBearingModel, WrapsBearingsBehindTheSensor) {
  const RangeBearingModel model;
  const auto nu = model.innovation({2, M_PI - 0.01}, {1.5, -M_PI + 0.02});
  EXPECT_NEAR(nu.x(), 0.5, 1e-15);
  EXPECT_NEAR(nu.y(), -0.03, 1e-12);
  const auto z = model.predict(Pose2(0, 0, 3), Pose2(), {-1, -1});
  EXPECT_EQ(z.y(), wrapAngle(z.y()));
}

}  // namespace
}  // namespace slam
