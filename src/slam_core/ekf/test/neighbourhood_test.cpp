// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <numeric>
#include <set>

#include "slam_core/common/random.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/ekf/panel_triangle.hpp"
#include "slam_core/ekf/test/ekf_variants.hpp"

namespace slam::ekf {
namespace {

/// A robot that wanders through a wide random world and sees only what is near.
class WideWorld {
 public:
  WideWorld(std::uint64_t seed, int landmarks) : random_(seed, 0) {
    for (int i = 0; i < landmarks; ++i)
      landmarks_.emplace_back(30 * random_.uniform() - 15, 30 * random_.uniform() - 15);
  }
  Motion drive() {
    const Eigen::Vector3d sigma(0.02, 0.02, 0.01);
    const double turn = (truth_.position().norm() > 10 ? 0.4 : 0.1 * random_.gaussian());
    const Pose2 step(0.5, 0, turn);
    Motion motion;
    motion.increment = step;
    motion.covariance = sigma.cwiseAbs2().asDiagonal();
    const Eigen::Vector3d noise(random_.gaussian(), random_.gaussian(), random_.gaussian());
    truth_ = truth_ * Pose2::fromVector(step.vector() + sigma.cwiseProduct(noise));
    return motion;
  }
  LandmarkObservationArray look() {
    LandmarkObservationArray array;
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      const auto seen = truth_.inverse().transform(landmarks_[i]);
      if (seen.norm() > 5 || seen.norm() < 0.3) continue;
      LandmarkObservation z;
      z.id = LandmarkId((7 * i) % landmarks_.size());
      z.range = seen.norm() + 0.05 * random_.gaussian();
      z.bearing = std::atan2(seen.y(), seen.x()) + 0.01 * random_.gaussian();
      z.covariance = Eigen::Vector2d(25e-4, 1e-4).asDiagonal();
      array.observations.push_back(z);
    }
    return array;
  }

 private:
  RandomStream random_;
  std::vector<Eigen::Vector2d> landmarks_;
  Pose2 truth_;
};

EkfConfig configOf(const test::EkfVariant& variant, UpdateExtent update, int neighbourhood) {
  auto config = test::configOf(variant);
  config.update = update;
  config.neighbourhood = neighbourhood;
  return config;
}

void expectSame(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, const std::string& what) {
  ASSERT_EQ(a.rows(), b.rows());
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9 * b.cwiseAbs().maxCoeff()) << what;
}

/// Relative to the diagonal: the small covariances among large ones must be right as well.
void expectSameState(const MapState& a, const MapState& b) {
  EXPECT_LT((a.robot.pose.vector() - b.robot.pose.vector()).norm(), 1e-9);
  ASSERT_EQ(a.landmarks.size(), b.landmarks.size());
  for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
    EXPECT_EQ(a.landmarks[i].id, b.landmarks[i].id);
    EXPECT_LT((a.landmarks[i].position - b.landmarks[i].position).norm(), 1e-9);
  }
  const Eigen::VectorXd scale = b.joint_covariance.diagonal().cwiseSqrt().cwiseInverse();
  expectSame(scale.asDiagonal() * a.joint_covariance * scale.asDiagonal(),
             scale.asDiagonal() * b.joint_covariance * scale.asDiagonal(), "covariance");
}

class Compression : public testing::TestWithParam<std::tuple<test::EkfVariant, int>> {
 protected:
  void SetUp() override {
    const auto [variant, neighbourhood] = GetParam();
    compressed.configure(configOf(variant, UpdateExtent::kCompressed, neighbourhood));
    dense.configure(configOf(variant, UpdateExtent::kDense, neighbourhood));
  }
  void step(WideWorld& world) {
    const auto motion = world.drive();
    const auto array = world.look();
    for (auto* ekf : {&compressed, &dense}) {
      ekf->set(motion);
      ekf->set(array);
      ASSERT_NE(ekf->execute().level, Status::Level::kError);
    }
    ASSERT_EQ(as<LandmarkMapper>(compressed).statistics().used,
              as<LandmarkMapper>(dense).statistics().used);
    ASSERT_NEAR(as<LandmarkMapper>(compressed).statistics().nis,
                as<LandmarkMapper>(dense).statistics().nis, 1e-6);
  }
  EkfSlam compressed, dense;
};

TEST_P(Compression, EqualsTheDenseFilterAtEveryLookAtTheWholeMap) {
  WideWorld world(std::uint64_t(std::get<1>(GetParam())), 60);
  for (int i = 1; i <= 240; ++i) {
    step(world);
    if (HasFatalFailure()) return;
    if (i % 40 == 0)
      expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
  }
  EXPECT_GT(as<LandmarkMapper>(compressed).landmarks().size(), 20u);
}

TEST_P(Compression, EqualsTheDenseFilterWhereTwoSensorsSeeAtTheSameTime) {
  WideWorld world(6, 60);
  std::set<LandmarkId> known;
  for (int i = 0; i < 240; ++i) {
    const auto motion = world.drive();
    std::array<LandmarkObservationArray, 2> arrays;  // one sensor sees what nobody has seen so far
    for (const auto& z : world.look().observations)
      arrays[known.insert(z.id).second ? 0 : 1].observations.push_back(z);
    for (auto* ekf : {&compressed, &dense}) {
      ekf->set(motion);
      for (const auto& array : arrays) {  // without motion before the second one
        ekf->set(array);
        ASSERT_NE(ekf->execute().level, Status::Level::kError);
      }
    }
  }
  expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
}

TEST_P(Compression, TellsTheMarginalsOfTheWholeMapWithoutBringingItUpToDate) {
  WideWorld world(9, 60);
  for (int i = 1; i <= 120; ++i) {
    step(world);
    if (i % 10 != 0) continue;
    const auto map = as<LandmarkMapper>(compressed).landmarks();
    const auto state = as<MapKeeper>(compressed).state();
    for (std::size_t k = 0; k < map.size(); ++k) {
      const auto row = 3 + 2 * Eigen::Index(k);
      const Eigen::Matrix2d P = state.joint_covariance.block<2, 2>(row, row);
      ASSERT_LT((map[k].covariance - P).norm(), 1e-9 * P.norm());
      ASSERT_LT((map[k].position - state.landmarks[k].position).norm(), 1e-12);
    }
  }
}

TEST_P(Compression, GoesOnWithTheSameBitsWhoeverLooks) {
  WideWorld world(5, 60);
  EkfSlam undisturbed;
  const auto [variant, neighbourhood] = GetParam();
  undisturbed.configure(configOf(variant, UpdateExtent::kCompressed, neighbourhood));
  for (int i = 1; i <= 100; ++i) {
    const auto motion = world.drive();
    const auto array = world.look();
    for (auto* ekf : {&compressed, &undisturbed}) {
      ekf->set(motion);
      ekf->set(array);
      ekf->execute();
    }
    as<LandmarkMapper>(compressed).landmarks();
    as<MapKeeper>(compressed).state();
    ASSERT_EQ(compressed.pose().pose.vector(), undisturbed.pose().pose.vector()) << i;
    ASSERT_EQ(compressed.pose().covariance, undisturbed.pose().covariance) << i;
  }
  EXPECT_EQ(as<MapKeeper>(compressed).state().joint_covariance,
            as<MapKeeper>(undisturbed).state().joint_covariance);
}

TEST_P(Compression, TakesALoadedMapAndANewPoseInTheMiddleOfAStretch) {
  WideWorld world(11, 60);
  for (int i = 0; i < 60; ++i) step(world);
  const auto map = as<MapKeeper>(dense).state();
  for (int i = 0; i < 7; ++i) step(world);
  for (auto* ekf : {&compressed, &dense}) as<MapKeeper>(*ekf).set(map);
  for (int i = 0; i < 3; ++i) step(world);
  const PoseEstimate there{compressed.pose().pose, Eigen::Vector3d(0.5, 0.5, 0.1).asDiagonal()};
  for (auto* ekf : {&compressed, &dense}) ekf->set(there);
  for (int i = 0; i < 40; ++i) step(world);
  expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
}

/// The first reading of some landmarks, and single ones later on, are far off.
TEST_P(Compression, BeginsWronglySeenLandmarksAnewAsTheDenseFilterDoes) {
  WideWorld world(21, 60);
  RandomStream random(5, 0);
  std::set<LandmarkId> met;
  for (int i = 1; i <= 240; ++i) {
    const auto motion = world.drive();
    auto array = world.look();
    for (auto& z : array.observations)
      if (random.uniform() < (met.insert(z.id).second ? 0.3 : 0.02)) z.range += 10.0;
    for (auto* ekf : {&compressed, &dense}) {
      ekf->set(motion);
      ekf->set(array);
      ekf->execute();
    }
    ASSERT_EQ(compressed.counters()["begun_anew"], dense.counters()["begun_anew"]);
    if (i % 40 == 0)
      expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
  }
  EXPECT_GT(dense.counters()["begun_anew"], 0u);
}

TEST_P(Compression, LocalisesAsTheDenseFilterWhereARobotStandsAndLooksTwice) {
  WideWorld world(13, 60);
  for (int i = 0; i < 150; ++i) step(world);
  const auto map = as<MapKeeper>(dense).state();
  const auto [variant, neighbourhood] = GetParam();
  auto config = configOf(variant, UpdateExtent::kCompressed, neighbourhood);
  config.mode = BackendMode::kLocalization;
  compressed.configure(config);
  config.update = UpdateExtent::kDense;
  dense.configure(config);
  for (auto* ekf : {&compressed, &dense}) as<MapKeeper>(*ekf).set(map);
  auto half = world.look();  // then more comes into view
  ASSERT_GT(half.observations.size(), 3u);
  half.observations.resize(half.observations.size() / 2);
  for (const auto& array : {half, world.look()}) {
    for (auto* ekf : {&compressed, &dense}) {
      ekf->set(array);
      ekf->execute();
    }
    EXPECT_GT(as<LandmarkMapper>(dense).statistics().used, 0);
    expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
  }
  for (int i = 0; i < 40; ++i) step(world);
  expectSameState(as<MapKeeper>(compressed).state(), as<MapKeeper>(dense).state());
}

INSTANTIATE_TEST_SUITE_P(All, Compression,
                         testing::Combine(test::allVariants(), testing::Values(1, 8, 25)),
                         [](const auto& of) {
                           return test::nameOf(std::get<0>(of.param)) + "_" +
                                  std::to_string(std::get<1>(of.param));
                         });

TEST(Neighbourhood, BeginsWithLandmarksThatAreNotCorrelated) {
  Eigen::Matrix2d of_first, of_second;
  of_first << 2, 0.5, 0.5, 3;
  of_second << 4, -1, -1, 5;
  const Eigen::Matrix3d robot = Eigen::Vector3d(1, 2, 3).asDiagonal();
  Eigen::MatrixXd joint = Eigen::MatrixXd::Zero(7, 7);
  joint.topLeftCorner<3, 3>() = robot;
  joint.block<2, 2>(3, 3) = of_first;
  joint.block<2, 2>(5, 5) = of_second;
  const Neighbourhood sparse(robot, {of_first, of_second}), full(joint);
  for (Eigen::Index row = 0; row < 7; ++row)
    for (Eigen::Index column = 0; column < 7; ++column)
      EXPECT_EQ(sparse.prior(row, column), full.prior(row, column));
  EXPECT_EQ(sparse.landmarks(), 2);
}

TEST(Neighbourhood, ReplacesALandmarkAsTheWholeMatrixWould) {
  const int landmarks = 12, replaced = 5;
  const Eigen::Index size = 3 + 2 * landmarks, row = 3 + 2 * replaced;
  RandomStream random(4, 0);
  const auto gaussian = [&](Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.gaussian(); }).eval();
  };
  const Eigen::MatrixXd A = gaussian(size, 40);
  const Eigen::MatrixXd P = A * A.transpose() / 40;
  const Eigen::Matrix<double, 2, 3> J = gaussian(2, 3);
  const Eigen::Matrix2d R = Eigen::Vector2d(0.3, 0.2).asDiagonal();
  Neighbourhood neighbourhood(P);
  neighbourhood.replace(replaced, J, R);
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(size, size);  // of the errors, old to new
  T.middleRows<2>(row).setZero();
  T.block<2, 3>(row, 0) = J;
  Eigen::MatrixXd expected = T * P * T.transpose();
  expected.block<2, 2>(row, row) += R;
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      ASSERT_NEAR(neighbourhood.prior(i, j), expected(i, j), 1e-12) << i << ", " << j;
}

TEST(Neighbourhood, BoundsTheMarginalsFromAbove) {
  constexpr int kLandmarks = 8;
  constexpr Eigen::Index kSize = 3 + 2 * kLandmarks;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomStream random(seed, 0);
    const auto gaussian = [&](Eigen::Index rows, Eigen::Index columns) {
      return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.gaussian(); }).eval();
    };
    const Eigen::MatrixXd A = gaussian(kSize, 40);
    Neighbourhood neighbourhood(A * A.transpose() / 40);
    for (const Eigen::Index taken : {6, 2}) neighbourhood.take(taken);
    const auto& P = neighbourhood.covariance();
    Eigen::MatrixXd prior(P.size(), P.size());
    for (Eigen::Index row = 0; row < P.size(); ++row)
      for (Eigen::Index column = 0; column < P.size(); ++column)
        prior(row, column) = P(row, column);
    const Eigen::MatrixXd H = gaussian(2, P.size());
    const Eigen::MatrixXd S = H * prior * H.transpose() + Eigen::Matrix2d::Identity();
    const Eigen::MatrixXd L = S.llt().matrixL();
    const Eigen::MatrixXd W = L.triangularView<Eigen::Lower>().solve(H * prior).transpose();
    neighbourhood.update(W, Eigen::VectorXd::Zero(P.size()));
    const Eigen::Matrix2Xd c = gaussian(2, kLandmarks);
    const auto marginals = neighbourhood.marginals(c);
    const auto bounds = neighbourhood.varianceBounds(c);
    for (std::size_t i = 0; i < marginals.size(); ++i) {
      const Eigen::Vector2d bound = bounds.col(static_cast<Eigen::Index>(i));
      ASSERT_TRUE((marginals[i].diagonal().array() <= bound.array() + 1e-12).all());
    }
  }
}

TEST(Neighbourhood, KeepsTheRestOfALargeMapUntilItEnds) {
  const int landmarks = 30;
  RandomStream random(3, 0);
  const Eigen::MatrixXd A =
      Eigen::MatrixXd::NullaryExpr(3 + 2 * landmarks, 80, [&] { return random.gaussian(); });
  Neighbourhood neighbourhood(A * A.transpose() / 80);
  EXPECT_EQ(neighbourhood.size(), 0);
  neighbourhood.predict(Eigen::Matrix3d::Identity(), 0.1 * Eigen::Matrix3d::Identity());
  neighbourhood.take(17);
  neighbourhood.take(4);
  EXPECT_EQ(neighbourhood.slot(4), 1);
  EXPECT_EQ(neighbourhood.slot(5), -1);
  EXPECT_EQ(neighbourhood.covariance().size(), 10);
  neighbourhood.renew(Eigen::Matrix2Xd::Zero(2, landmarks));
  EXPECT_EQ(neighbourhood.size(), 0);
  Eigen::MatrixXd expected = A * A.transpose() / 80;
  expected.topLeftCorner<3, 3>() += 0.1 * Eigen::Matrix3d::Identity();
  for (Eigen::Index row = 0; row < expected.rows(); ++row)
    for (Eigen::Index column = 0; column < expected.rows(); ++column)
      ASSERT_NEAR(neighbourhood.prior(row, column), expected(row, column), 1e-12);
}

TEST(PanelTriangleTest, SubtractsAProductOfAnyWidthAndGrows) {
  RandomStream random(2, 0);
  const auto gaussian = [&](Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.gaussian(); }).eval();
  };
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(0, 0);
  PanelTriangle P(expected);
  for (const Eigen::Index size : {3, 16, 17, 41, 120}) {
    P.grow(size);
    const auto before = expected;
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(size));
    std::iota(rows.begin(), rows.end(), Eigen::Index{0});
    expected = Eigen::MatrixXd::Zero(size, size);
    expected.topLeftCorner(before.rows(), before.cols()) = before;
    for (const Eigen::Index width : {1, 5, 100, 200}) {
      const Eigen::MatrixXd W = gaussian(size, width), D = gaussian(width, width);
      const Eigen::MatrixXd A = W * (D + D.transpose());
      P.subtractProduct(A, W, rows);
      expected -= A * W.transpose();
    }
    EXPECT_LT((P.full() - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.norm()) << size;
    EXPECT_EQ(P(size - 1, 0), P(0, size - 1));
  }
}

TEST(PanelTriangleTest, LeavesOtherRowsAsTheyAre) {
  PanelTriangle P(Eigen::MatrixXd::Ones(20, 20));
  P.subtractProduct(Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 2), {3, 18});
  Eigen::MatrixXd expected = Eigen::MatrixXd::Ones(20, 20);
  expected(3, 3) = 0;
  expected(18, 18) = -3;
  expected(3, 18) = expected(18, 3) = -1;
  EXPECT_EQ(P.full(), expected);
}

}  // namespace
}  // namespace slam::ekf
