// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/knowledge_bound.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

namespace slam::particle_filter {
namespace {

template <class Matrix>
double smallestEigenvalue(const Matrix& matrix) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(matrix, Eigen::EigenvaluesOnly).eigenvalues().x();
}

Eigen::Matrix3d someCovariance() {
  Eigen::Matrix3d P;
  P << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.01;
  return P;
}

/// The error of the fused pose has K and the weights of the intersection; whatever the correlation
/// of pose and landmark, the covariance told is no smaller than that of the error.
TEST(Intersection, TellsNoMoreThanIsKnownUnderAnyCorrelation) {
  const Eigen::Matrix3d P = someCovariance();
  Eigen::Matrix<double, 2, 3> H;
  H << 1.0, 0.0, -0.5, 0.0, 1.0, 2.0;
  const Eigen::Matrix2d other = Eigen::Vector2d(0.05, 0.02).asDiagonal();
  const Eigen::Matrix2d R = Eigen::Vector2d(1e-3, 2e-3).asDiagonal();
  const Eigen::Matrix3d fused = intersected<3>(P, H, other, R);
  EXPECT_LT(fused.determinant(), P.determinant()) << "something is learned";
  const Eigen::Matrix3d of_pose = P.llt().matrixL();
  const Eigen::Matrix2d of_other = other.llt().matrixL();
  RandomStream random(3, 0);
  for (int i = 0; i < 200; ++i) {
    Eigen::Matrix<double, 3, 2> C;  // a contraction: any correlation there can be
    for (Eigen::Index k = 0; k < C.size(); ++k) C.data()[k] = 2.0 * random.uniform() - 1.0;
    const double norm = std::sqrt((C.transpose() * C).trace());
    C /= std::max(1.0, norm);
    const Eigen::Matrix<double, 3, 2> cross = of_pose * C * of_other.transpose();
    for (double weight = 0.05; weight < 1.0; weight += 0.05) {
      // the linear estimate that the weight stands for, where it gives what was told
      const Eigen::Matrix2d noise = other / (1.0 - weight) + R;
      const Eigen::Matrix3d told =
          (weight * P.inverse() + H.transpose() * noise.inverse() * H).inverse();
      const Eigen::Matrix<double, 3, 2> K = told * H.transpose() * noise.inverse();
      const Eigen::Matrix3d I_KH = Eigen::Matrix3d::Identity() - K * H;
      const Eigen::Matrix3d mixed = I_KH * cross * K.transpose();
      const Eigen::Matrix3d error =
          I_KH * P * I_KH.transpose() + K * (other + R) * K.transpose() + mixed + mixed.transpose();
      EXPECT_GT(smallestEigenvalue<Eigen::Matrix3d>(told - error), -1e-12);
      EXPECT_GE(told.determinant(), fused.determinant() * 0.999) << "the best of all weights";
    }
  }
}

TEST(Intersection, LearnsNothingTwiceFromTheSameLandmark) {
  KnowledgeBound bound;
  bound.restart(someCovariance());
  const Eigen::Matrix2d landmark = 0.01 * Eigen::Matrix2d::Identity();
  bound.load({{7, {2.0, 1.0}, landmark}}, 1.0);
  LandmarkObservation z;
  z.covariance = 1e-6 * Eigen::Matrix2d::Identity();
  for (int i = 0; i < 1000; ++i)
    bound.observe(RangeBearingModel(), Pose2(), Pose2(), {2.0, 1.0}, 0, z, true);
  const Eigen::Matrix2d position = bound.pose().topLeftCorner<2, 2>();
  EXPECT_GT(smallestEigenvalue<Eigen::Matrix2d>(position), 0.009);
  const Eigen::Matrix2d small = 1e-6 * Eigen::Matrix2d::Identity();
  EXPECT_TRUE(bound.told(small, 0).isApprox(landmark)) << "the map is fixed";
}

TEST(Forgetting, IsTheShareOfThePairsThatDescendFromTheSameParticle) {
  const Eigen::Matrix3d told = 0.01 * someCovariance();
  KnowledgeBound bound;
  bound.restart(someCovariance());
  EXPECT_TRUE(bound.told(told).isApprox(told)) << "nothing yet";
  bound.genealogy().resample({0, 1, 2, 3});
  EXPECT_TRUE(bound.told(told).isApprox(told));
  bound.genealogy().resample({0, 0, 2, 3});  // one pair of six
  EXPECT_TRUE(bound.told(told).isApprox(5.0 / 6.0 * told + someCovariance() / 6.0));
  bound.genealogy().resample({1, 1, 1, 1});
  EXPECT_TRUE(bound.told(told).isApprox(someCovariance(), 1e-4)) << "all of it";
}

TEST(Forgetting, IncludesParticlesThatWeighNothing) {
  const Eigen::Matrix3d bound = Eigen::Matrix3d::Identity(), spread = 0.01 * bound;
  KnowledgeBound knowledge;
  knowledge.restart(bound);
  knowledge.genealogy().weigh(100.0, 100);
  EXPECT_TRUE(knowledge.told(spread).isApprox(spread)) << "all weigh the same";
  knowledge.genealogy().weigh(1.0, 100);
  EXPECT_TRUE(knowledge.told(spread).isApprox(bound)) << "one has all the weight";
  knowledge.genealogy().weigh(1.0, 1);
  EXPECT_TRUE(knowledge.told(spread).isApprox(bound)) << "there is only one";
}

TEST(AtLeast, IsNowhereBelowEither) {
  const Eigen::Matrix3d a = someCovariance();
  const Eigen::Matrix3d b = Eigen::Vector3d(0.09, 0.04, 1e-4).asDiagonal();
  const Eigen::Matrix3d both = atLeast<3>(a, b);
  EXPECT_GT(smallestEigenvalue<Eigen::Matrix3d>(both - a), -1e-12);
  EXPECT_GT(smallestEigenvalue<Eigen::Matrix3d>(both - b), -1e-12);
  EXPECT_TRUE((atLeast<3>(a, 1e-6 * a)).isApprox(a, 1e-9));
  EXPECT_TRUE((atLeast<3>(1e-6 * a, a)).isApprox(a, 1e-9));
}

/// Of 10 drives of two laps: 3 expected of a filter that knows exactly how well it knows.
template <class Start>
double meanNees(const PfConfig& config, const Start& start) {
  constexpr int kDrives = 10, kSteps = 250;
  double sum = 0.0;
  for (int drive = 0; drive < kDrives; ++drive) {
    FastSlam filter;
    filter.configure(config);
    test::SimulatedWorld world(static_cast<std::uint64_t>(100 + drive));
    start(filter, world, drive);
    for (int i = 0; i < kSteps; ++i) {
      const auto step = world.next();
      give(step.motion, filter);
      give(step.observations, filter);
      filter.execute();
      const auto pose = filter.pose();
      sum += test::nees(step.truth, pose.pose, pose.covariance) / (kDrives * kSteps);
    }
  }
  return sum;
}

TEST(FastSlamConsistency, IsNotMoreCertainThanItShouldBe) {
  PfConfig few;
  few.particles = 30;  // which forget soon
  for (const auto& config : {PfConfig(), few}) {
    const double nees = meanNees(config, [](auto&...) {});
    EXPECT_LT(nees, 4.0);
    EXPECT_GT(nees, 0.5) << "nor does it know nothing";
  }
}

TEST(FastSlamConsistency, DoesNotLearnAnewAtEachStepHowFarALoadedMapIsOff) {
  PfConfig config;
  config.mode = BackendMode::kLocalization;
  const auto load = [](FastSlam& filter, const test::SimulatedWorld& world, int drive) {
    constexpr double kSigma = 0.1;
    RandomStream random(77, static_cast<std::uint64_t>(drive));
    MapState map;
    for (const auto& [id, place] : world.landmarks()) {
      const Eigen::Vector2d error(random.gaussian(), random.gaussian());
      map.landmarks.push_back(
          {id, place + kSigma * error, kSigma * kSigma * Eigen::Matrix2d::Identity()});
    }
    map.robot.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    const auto size = static_cast<Eigen::Index>(3 + 2 * map.landmarks.size());
    map.joint_covariance = kSigma * kSigma * Eigen::MatrixXd::Identity(size, size);
    as<MapKeeper>(filter).set(map);
    filter.execute();
  };
  const double nees = meanNees(config, load);
  EXPECT_LT(nees, 3.0);
  EXPECT_GT(nees, 0.1);
}

}  // namespace
}  // namespace slam::particle_filter
