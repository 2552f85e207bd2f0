// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/innovation_bias.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

/// Innovations of a robot that drives along x and sees landmarks ahead, at the left and behind.
class InnovationBiasTest : public testing::Test {
 protected:
  InnovationBiasTest() {
    prediction.F(1, 2) = 0.2;
    group.H.resize(6, 3);
    group.H << -1, 0, 0, 0, -0.5, -1,  //
        0, -1, 0, 0.5, 0, -1,          //
        1, 0, 0, 0, 0.5, -1;
    group.R = 25e-4 * Eigen::MatrixXd::Identity(6, 6);
    group.S = group.R + 25e-4 * group.H * group.H.transpose();
  }
  /// @param factor of the true standard deviation over that of S
  void step(const Eigen::VectorXd& mean, double factor = 1.0) {
    Eigen::VectorXd white(6);
    for (auto& element : white) element = random_.gaussian();
    const Eigen::VectorXd noise = group.S.llt().matrixL() * white;
    group.nu = mean + factor * noise;
    bias.add(group, prediction);
  }
  /// The largest evidence within the steps.
  double worst(int steps, const Eigen::VectorXd& mean, double factor = 1.0) {
    double worst = 0.0;
    for (int i = 0; i < steps; ++i) {
      step(mean, factor);
      worst = std::max(worst, std::abs(bias.mean().evidence));
    }
    return worst;
  }

  InnovationBias bias{50};
  PosePrediction prediction;
  JointInnovation group;
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(6);

 private:
  RandomStream random_{5, 0};
};

TEST_F(InnovationBiasTest, SeesNoneInNoise) { EXPECT_LT(worst(20000, nothing), 4.5); }

TEST_F(InnovationBiasTest, TakesASigmaThatIsTooSmallForNoBias) {
  EXPECT_LT(worst(20000, nothing, 3.0), 4.5);
}

TEST_F(InnovationBiasTest, TellsWhereTheInnovationsAreOff) {
  const Eigen::VectorXd along = 0.06 * group.H.col(0), across = 0.06 * group.H.col(1);
  for (const double factor : {1.0, 3.0}) {
    EXPECT_GT(worst(200, 2.0 * factor * along, factor), 4.5);
    EXPECT_EQ(bias.direction(), InnovationBias::kAlong);
    EXPECT_NE(bias.finding().find("along the way"), std::string::npos) << bias.finding();
    EXPECT_GT(worst(200, -2.0 * factor * across, factor), 4.5);
    EXPECT_EQ(bias.direction(), InnovationBias::kAcross);
    EXPECT_NE(bias.finding().find("across the way"), std::string::npos) << bias.finding();
  }
}

TEST_F(InnovationBiasTest, DoesWithoutKnowingHowTheyDependOnThePose) {
  group.H.resize(0, 3);
  Eigen::VectorXd ranges = nothing;
  for (Eigen::Index row = 0; row < 6; row += 2) ranges(row) = 0.1;
  EXPECT_GT(worst(50, ranges), 4.5);
  EXPECT_EQ(bias.direction(), InnovationBias::kRange);
}

TEST_F(InnovationBiasTest, SaysNothingOfFewSteps) {
  for (int i = 0; i < 9; ++i) step(group.H.col(0));
  EXPECT_EQ(bias.mean().evidence, 0.0);
}

TEST_F(InnovationBiasTest, InnovationsWithoutAnyScatterAreFinite) {
  group.nu = nothing;
  for (int i = 0; i < 60; ++i) bias.add(group, prediction);
  EXPECT_EQ(bias.mean().evidence, 0.0);
  group.nu = group.H.col(0);
  for (int i = 0; i < 60; ++i) bias.add(group, prediction);
  EXPECT_TRUE(std::isfinite(bias.mean().evidence));
}

}  // namespace
}  // namespace slam
