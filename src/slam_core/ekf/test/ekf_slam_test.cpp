// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_slam.hpp"

#include <gtest/gtest.h>

#include "slam_core/association/gate.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/ekf/test/reference_ekf.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::ekf {
namespace {

using test::ReferenceEkf;
using test::SimulatedWorld;

LandmarkObservation observation(LandmarkId id, double range, double bearing) {
  LandmarkObservation z;
  z.id = id;
  z.range = range;
  z.bearing = bearing;
  z.covariance = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
  return z;
}

LandmarkObservationArray arrayOf(std::vector<LandmarkObservation> observations) {
  LandmarkObservationArray array;
  array.observations = std::move(observations);
  return array;
}

Motion ahead(double way) {
  Motion motion;
  motion.increment = Pose2(way, 0, 0);
  motion.covariance = Eigen::Vector3d(1e-3, 1e-4, 1e-3).asDiagonal();
  return motion;
}

class EkfUpdate : public testing::Test {
 protected:
  void SetUp() override { ekf.configure(EkfConfig()); }
  UpdateStatistics see(std::vector<LandmarkObservation> observations) {
    ekf.set(arrayOf(std::move(observations)));
    EXPECT_TRUE(ekf.execute().isOk());
    return as<LandmarkMapper>(ekf).statistics();
  }
  void drive(double way) {
    ekf.set(ahead(way));
    ekf.execute();
  }

  EkfSlam ekf;
};

TEST_F(EkfUpdate, EqualsTheTextbookWithFullMatrices) {
  EkfConfig config;
  config.linearization = "textbook";
  config.iterations = 1;
  config.neighbourhood = 5;
  config.gate_probability = 1 - 1e-15;
  config.initial_sigma_position = 0.01;
  config.initial_sigma_heading = 0.02;
  ekf.configure(config);
  ReferenceEkf reference(Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal());
  SimulatedWorld world(3);
  for (int i = 0; i < 200; ++i) {
    const auto step = world.next();
    ekf.set(step.motion);
    ekf.set(step.observations);
    ASSERT_TRUE(ekf.execute().isOk());
    ASSERT_EQ(as<LandmarkMapper>(ekf).statistics().gated, 0);
    reference.predict(step.motion);
    reference.update(step.observations);
    const Pose2 expected = Pose2::fromVector(reference.x.head<3>());
    ASSERT_LT(expected.between(ekf.pose().pose).vector().norm(), 1e-9) << "step " << i;
    ASSERT_TRUE(as<LandmarkMapper>(ekf).statistics().used == 0 ||
                std::abs(as<LandmarkMapper>(ekf).statistics().nis - reference.nis) < 1e-6);
  }
  const auto state = as<MapKeeper>(ekf).state();
  ASSERT_EQ(state.landmarks.size(), world.landmarks().size());
  Eigen::VectorXi rows(reference.x.size());
  rows.head<3>() << 0, 1, 2;
  for (std::size_t i = 0; i < state.landmarks.size(); ++i) {
    const auto row = reference.row.at(state.landmarks[i].id);
    EXPECT_LT((state.landmarks[i].position - reference.x.segment<2>(row)).norm(), 1e-9);
    rows.segment<2>(3 + 2 * Eigen::Index(i)) << int(row), int(row) + 1;
  }
  const Eigen::MatrixXd P = reference.P(rows, rows);
  EXPECT_LT((state.joint_covariance - P).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(EkfUpdate, AddsUpMotionsAsIfTheyWereOneStepEach) {
  EkfSlam together;
  together.configure(EkfConfig());
  for (const double way : {0.5, 0.2, 1.0}) {
    auto motion = ahead(way);
    motion.increment = Pose2(way, 0.1, 0.3);
    ekf.set(motion);
    ekf.execute();
    together.set(motion);
  }
  together.execute();
  EXPECT_LT((together.pose().pose.vector() - ekf.pose().pose.vector()).norm(), 1e-12);
  EXPECT_TRUE(together.pose().covariance.isApprox(ekf.pose().covariance, 1e-9));
}

TEST_F(EkfUpdate, ShrinksCovarianceWhenALandmarkIsSeenAgain) {
  EXPECT_EQ(see({observation(1, 2, 0.1)}).added, 1);
  const auto first = as<LandmarkMapper>(ekf).landmarks()[0].covariance;
  drive(0.5);
  const auto robot = ekf.pose().covariance;
  const auto statistics = see({observation(1, 1.51, 0.13)});
  EXPECT_EQ(statistics.used, 1);
  EXPECT_EQ(statistics.added, 0);
  EXPECT_EQ(statistics.nis_dof, 2);
  EXPECT_LT(as<LandmarkMapper>(ekf).landmarks()[0].covariance.trace(), 0.9 * first.trace());
  EXPECT_LT(ekf.pose().covariance.trace(), robot.trace());
}

TEST_F(EkfUpdate, GrowsCovarianceWithMotionAndNothingSeen) {
  see({observation(1, 2, 0.1)});
  const auto robot = ekf.pose().covariance;
  const auto landmark = as<LandmarkMapper>(ekf).landmarks()[0].covariance;
  drive(0.5);
  EXPECT_GT(ekf.pose().covariance.trace(), robot.trace());
  EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks()[0].covariance, landmark);
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().landmarks, 1);
}

TEST_F(EkfUpdate, GatesAndCountsAnOutlier) {
  see({observation(1, 2, 0.1), observation(2, 3, -0.5)});
  const auto pose = ekf.pose().pose;
  const auto statistics = see({observation(1, 4, 0.1), observation(2, 3.01, -0.5)});
  EXPECT_EQ(statistics.gated, 1);
  EXPECT_EQ(statistics.used, 1);
  EXPECT_EQ(ekf.counters()["gated"], 1u);
  EXPECT_LT((ekf.pose().pose.vector() - pose.vector()).norm(), 0.01);
}

TEST_F(EkfUpdate, SaysThatThePoseMayBeLostWhenNothingFitsTheMap) {
  see({observation(1, 2, 0.1), observation(2, 3, -0.5), observation(3, 2, 1)});
  LandmarkObservationArray array;
  array.observations = {observation(1, 4, 0.1), observation(2, 5, -0.5), observation(3, 2, 1)};
  ekf.set(array);
  EXPECT_TRUE(ekf.execute().isOk()) << "one of them fits";
  array.observations[2] = observation(3, 4, 1);
  ekf.set(array);
  EXPECT_TRUE(test::oneSays({ekf.execute().message}, {"no observation fits", "may be lost"}));
}

TEST_F(EkfUpdate, GatesAtTheQuantileOfItsProbability) {
  // a landmark with a covariance of zero, a robot without: the gate is on R alone
  for (const double sigmas : {2.14, 2.16}) {  // sqrt(chi2 quantile of 0.9 with 2 dof) = 2.1460
    EkfConfig config;
    config.gate_probability = 0.9;
    config.initial_sigma_position = config.initial_sigma_heading = 1e-9;
    ekf.configure(config);
    MapState map;
    map.robot.covariance = 1e-18 * Eigen::Matrix3d::Identity();
    map.landmarks = {{1, {2, 0}, 1e-18 * Eigen::Matrix2d::Identity()}};
    as<MapKeeper>(ekf).set(map);
    EXPECT_EQ(see({observation(1, 2 + sigmas * 0.1, 0)}).gated, sigmas < 2.146 ? 0 : 1);
  }
}

TEST_F(EkfUpdate, AnOutlierIsLessLikelyTheSharperItsSensorIsSaidToBe) {
  double last = 0.0;
  for (const double sigma : {0.1, 0.05, 0.02, 0.01, 0.001}) {
    ekf.configure(EkfConfig());
    auto first = observation(1, 2.0, 0.1), outlier = observation(1, 4.0, 0.1);
    first.covariance = outlier.covariance = sigma * sigma * Eigen::Matrix2d::Identity();
    see({first});
    const auto statistics = see({outlier});
    ASSERT_EQ(statistics.gated, 1);
    ASSERT_TRUE(last == 0.0 || statistics.log_likelihood < last - 1.0) << sigma;
    last = statistics.log_likelihood;
  }
}

TEST(OutlierLogLikelihood, IsADensityTogetherWithTheNormalOneInsideTheGate) {
  Eigen::Matrix2d S;
  S << 0.04, 0.01, 0.01, 0.09;
  for (const double probability : {0.3, 0.5, 0.9, 0.9999}) {
    const double gate = -2.0 * std::log(1.0 - probability), root = std::sqrt(S.determinant());
    const double at_gate = -0.5 * gate - std::log(2.0 * M_PI * root);
    EXPECT_NEAR(association::outlierLogLikelihood(gate, gate, S), at_gate, 1e-12);
    // An ellipse of squared distance d has the area pi d root.
    double outside = 0.0;
    constexpr double kStep = 1e-3;  // of log d
    for (double log_d = std::log(gate) + 0.5 * kStep; log_d < 60.0; log_d += kStep)
      outside += std::exp(association::outlierLogLikelihood(gate, std::exp(log_d), S) + log_d) *
                 M_PI * root;
    EXPECT_NEAR(outside * kStep, 1.0 - probability, 1e-5 * (1.0 - probability));
  }
}

TEST_F(EkfUpdate, LeavesOutObservationsWithoutIdAndCountsThem) {
  const auto statistics =
      see({observation(kUnknownId, 1, 0), observation(kUnknownId, 2, 0), observation(3, 2, 1)});
  EXPECT_EQ(statistics.unknown, 2);
  EXPECT_EQ(statistics.added, 1);
  EXPECT_EQ(ekf.counters()["unknown_id"], 2u);
  EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks().size(), 1u);
}

TEST_F(EkfUpdate, TakesTheFirstOfTwoObservationsOfOneId) {
  const auto statistics = see({observation(3, 2, 0), observation(3, 5, 1)});
  EXPECT_EQ(statistics.added, 1);
  EXPECT_EQ(ekf.counters()["duplicate"], 1u);
  EXPECT_LT((as<LandmarkMapper>(ekf).landmarks()[0].position - Eigen::Vector2d(2, 0)).norm(), 1e-9);
}

TEST_F(EkfUpdate, LeavesOutALandmarkItStandsOn) {
  see({observation(1, 2, 0)});
  drive(2.0);
  const auto statistics = see({observation(1, 0.3, 1)});
  EXPECT_EQ(statistics.gated, 1);
  EXPECT_TRUE(ekf.pose().pose.isFinite());
}

TEST_F(EkfUpdate, RefusesALandmarkThatWouldNotLieAtAFinitePlace) {
  auto z = observation(77, 1e200, 0.1);
  ekf.set(arrayOf({observation(1, 2, 0.1), z}));
  const auto status = ekf.execute();
  EXPECT_TRUE(test::oneSays({status.message}, {"landmark 77", "not finite", "left out"}));
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().added, 1);
  EXPECT_EQ(ekf.counters()["not_finite"], 1u);
  EXPECT_TRUE(as<MapKeeper>(ekf).state().joint_covariance.allFinite());
}

TEST_F(EkfUpdate, RefusesACorrectionThatIsNotFinite) {
  MapState map;
  map.robot.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  map.landmarks = {{1, {2, 0}, 1e306 * Eigen::Matrix2d::Identity()}};
  as<MapKeeper>(ekf).set(map);
  auto z = observation(1, 1e160, 3.0);
  ekf.set(arrayOf({z}));
  ekf.execute();
  EXPECT_TRUE(ekf.pose().pose.isFinite());
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks()[0].position.allFinite());
  EXPECT_TRUE(ekf.pose().covariance.allFinite());
}

TEST_F(EkfUpdate, TellsLandmarksSortedById) {
  see({observation(30, 2, 0), observation(7, 3, 1), observation(12, 1, -1)});
  const auto map = as<LandmarkMapper>(ekf).landmarks();
  EXPECT_EQ(map[0].id, 7);
  EXPECT_EQ(map[1].id, 12);
  EXPECT_EQ(map[2].id, 30);
  const auto P = as<MapKeeper>(ekf).state().joint_covariance;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = 3 + 2 * Eigen::Index(i);
    EXPECT_EQ(Eigen::Matrix2d(P.block<2, 2>(row, row)), map[i].covariance);
  }
}

}  // namespace
}  // namespace slam::ekf
