// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/calibrated_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "slam_core/common/archive_reader.hpp"
#include "slam_core/common/archive_writer.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"
#include "slam_core/graph/factor_archive.hpp"

namespace slam::graph {
namespace {

Eigen::Matrix3d weight() { return (Eigen::Matrix3d() << 10, 2, -1, 0, 5, 3, 0, 0, 20).finished(); }

CalibrationVector parametersOf(double factor) {
  CalibrationVector c;
  c << 0.3, -0.1, 0.05, 0.2, -0.15, 0.2, 0.1, 0.0;
  return factor * c;
}

WheelMotion motionAt(const CalibrationVector& c, const Pose2& measured) {
  CalibrationJacobian<3> J;
  const Pose2 increment = calibrated(measured, c, &J);
  return {increment, J.leftCols<3>(), c.head<3>()};
}

CalibratedSighting::At sensorAt(const CalibrationVector& c) {
  return {c(kSensorYaw), {c(kSensorX), c(kSensorY)}, c(kRangeScale)};
}

/// Two poses, a point, parameters, and one factor of each kind, none of them satisfied.
struct World {
  explicit World(const CalibrationVector& c) {
    put(Pose2(1, 2, 0.7));
    put(Pose2(1.5, 2.2, 0.9));
    put(Eigen::Vector2d(4, 1));
    put(Eigen::Vector2d(c(kWheelScale), c(kWheelBase)));
    put(Eigen::Vector2d(c(kWheelDrift), c(kSensorYaw)));
    put(Eigen::Vector2d(c(kSensorX), c(kSensorY)));
    put(Eigen::Vector2d(c(kRangeScale), 0.0));
    const auto then = parametersOf(0.7);
    const RangeBearing seen(1, 2, Pose2(0.2, 0.1, 0.3), {2.5, -1.5},
                            weight().topLeftCorner<2, 2>());
    const Eigen::MatrixXd W = Eigen::MatrixXd::Random(8, 8);
    factors = {
        std::make_shared<CalibratedBetween>(0, 1, std::vector<Key>{3, 4},
                                            motionAt(then, Pose2(0.4, 0.02, 0.15)), weight()),
        std::make_shared<CalibratedSighting>(1, 2, std::vector<Key>{4, 5, 6}, seen, sensorAt(then)),
        std::make_shared<CalibratedSighting>(1, 2, std::vector<Key>{4, 5}, seen, sensorAt(then)),
        std::make_shared<ParameterPrior>(std::vector<Key>{3, 4, 5, 6}, then, W)};
  }
  template <class Value>
  void put(const Value& value) {
    variables.put(static_cast<Key>(variables.size()), value);
  }
  LinearFactor linearized(const Factor& factor, const Eigen::VectorXd& delta) const {
    Eigen::Index row = 0;
    std::vector<Pose2> at;
    for (const Key key : factor.keys()) {
      at.push_back(variables.corrected(key, delta.segment(row, variables.rows(key))));
      row += variables.rows(key);
    }
    return factor.linearized(at);
  }
  std::vector<Pose2> at(const Factor& factor) const {
    std::vector<Pose2> at;
    for (const Key key : factor.keys()) at.push_back(variables.pose(key));
    return at;
  }

  Variables variables;
  std::vector<std::shared_ptr<const Factor>> factors;
};

Eigen::Index columnsOf(const World& world, const Factor& factor) {
  Eigen::Index columns = 0;
  for (const Key key : factor.keys()) columns += world.variables.rows(key);
  return columns;
}

TEST(CalibratedFactors, HaveTheJacobiansOfTheirResiduals) {
  const World world(parametersOf(1.0));
  for (const auto& factor : world.factors) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(columnsOf(world, *factor));
    const auto linear = world.linearized(*factor, none);
    const auto J = test::numericJacobian(
        [&](const Eigen::VectorXd& delta) -> Eigen::VectorXd {
          return world.linearized(*factor, delta).r;
        },
        none,
        [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) -> Eigen::VectorXd {
          return a - b;
        });
    ASSERT_EQ(J.cols(), linear.J.cols());
    EXPECT_TRUE(J.isApprox(linear.J, 1e-6)) << J << "\n\n" << linear.J;
  }
}

/// A factor that was built with other parameters says the same, as far as a motion is linear.
TEST(CalibratedFactors, SayTheSameWithWhateverParametersTheyWereBuilt) {
  const auto truth = parametersOf(1.0);
  const Pose2 measured(0.05, 0.002, 0.03), mount(0.2, 0.1, 0.3);
  World world(truth);
  const auto residual = [&](const CalibrationVector& then) -> Eigen::VectorXd {
    const Eigen::DiagonalMatrix<double, 3> growth(WheelMotion().growth(then.head<3>()));
    const Eigen::Matrix3d P =
        growth * Eigen::Vector3d(1e-4, 2e-4, 1e-4).asDiagonal().toDenseMatrix() * growth;
    const CalibratedBetween between(0, 1, {3, 4}, motionAt(then, measured), weightOfCovariance(P));
    LandmarkObservation z;
    z.range = 2.9;
    z.bearing = -1.1;
    z.covariance << 0.01, 0.001, 0.001, 0.002;
    z = calibrated(z, then);
    const CalibratedSighting sighting(
        1, 2, {4, 5, 6},
        RangeBearing(1, 2, calibrated(mount, Eigen::Vector3d::Zero(), then), z.vector(),
                     weightOfCovariance(z.covariance)),
        sensorAt(then));
    Eigen::VectorXd both(5);
    both << between.linearized(world.at(between)).r, sighting.linearized(world.at(sighting)).r;
    return both;
  };
  const auto right = residual(truth), other = residual(CalibrationVector::Zero());
  EXPECT_LT((right - other).tail<2>().norm(), 1e-9);
  EXPECT_LT((right - other).head<3>().norm(), 0.01 * right.head<3>().norm());
}

TEST(CalibratedFactors, AreFactorsWithoutParametersWhereTheseAreKnown) {
  const World world(parametersOf(1.0));
  const auto& between = dynamic_cast<const CalibratedBetween&>(*world.factors[0]);
  const auto plain = between.with(world.at(between));
  EXPECT_TRUE(
      plain.linearized(world.at(plain)).r.isApprox(between.linearized(world.at(between)).r, 1e-12));
  const auto& sighting = dynamic_cast<const CalibratedSighting&>(*world.factors[1]);
  const auto seen = sighting.with(world.at(sighting));
  EXPECT_TRUE(
      seen.linearized(world.at(seen)).r.isApprox(sighting.linearized(world.at(sighting)).r, 1e-12));
}

TEST(CalibratedFactors, ComeBackFromAnArchiveAsTheyWere) {
  const World world(parametersOf(1.0));
  for (auto factor : world.factors) {
    ArchiveWriter writer;
    persistFactor(writer, factor);
    const auto bytes = writer.take();
    ArchiveReader reader(bytes);
    std::shared_ptr<const Factor> read;
    persistFactor(reader, read);
    EXPECT_EQ(read->keys(), factor->keys());
    const auto before = factor->linearized(world.at(*factor));
    const auto after = read->linearized(world.at(*read));
    EXPECT_EQ(before.r, after.r);
    EXPECT_EQ(before.J, after.J);
  }
}

}  // namespace
}  // namespace slam::graph
