// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/proposal.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "slam_core/particle_filter/landmarks/landmark_filter.hpp"
#include "slam_core/particle_filter/landmarks/weighting.hpp"

namespace slam::particle_filter {
namespace {

constexpr double kGate = 18.4;

LandmarkObservation observation(double range, double bearing) {
  LandmarkObservation z;
  z.range = range;
  z.bearing = bearing;
  z.covariance << 0.01, 0.001, 0.001, 0.0004;
  return z;
}

/// A robot near the origin that sees three landmarks, as well known as its motion.
class ProposalTest : public testing::Test {
 protected:
  void SetUp() override {
    sight.sensor = Pose2(0.1, 0.0, 0.2);
    sight.gate = kGate;
    prior.mean = Pose2(0.5, -0.2, 0.3);
    prior.covariance << 0.02, 0.001, 0.0, 0.001, 0.01, 0.0005, 0.0, 0.0005, 0.003;
    const std::vector<Eigen::Vector2d> places = {{3, 1}, {2, -2}, {-1, 4}};
    for (std::size_t slot = 0; slot < places.size(); ++slot) {
      Eigen::Matrix2d P;
      P << 0.004, 0.001, 0.001, 0.006;
      map.push_back({places[slot], P});
      const Eigen::Vector2d z = model.predict(truth, sight.sensor, places[slot]);
      sight.matches.push_back({slot, slot, observation(z.x() + 0.02, z.y() - 0.01)});
    }
    predictions.resize(places.size());
  }
  PoseGaussian propose(const Proposal& proposal) {
    RandomStream random(1, 2, 3);
    return proposal.propose(model, sight, map, prior, random, predictions.data());
  }

  RangeBearingModel model;
  ParticleMap::Memory memory;
  ParticleMap map{memory};
  Sight sight;
  PoseGaussian prior;
  const Pose2 truth{0.53, -0.17, 0.31};
  std::vector<Prediction> predictions;
};

TEST_F(ProposalTest, OfFastSlam1IsTheMotionPriorAlone) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  constexpr int kDraws = 20000;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    RandomStream random(1, 2, i);
    const auto drawn =
        MotionProposal().propose(model, sight, map, prior, random, predictions.data());
    EXPECT_TRUE(drawn.isCertain());
    const Eigen::Vector3d d = drawn.mean.vector() - prior.mean.vector();
    mean += d / kDraws;
    second += d * d.transpose() / kDraws;
  }
  EXPECT_LT((mean.array() / prior.covariance.diagonal().array().sqrt()).abs().maxCoeff(), 0.03);
  EXPECT_LT((second - prior.covariance).cwiseAbs().maxCoeff(), 0.03 * 0.02);
}

TEST(PoseGaussian, DrawsOnlyWhereItIsUncertain) {
  PoseGaussian line{Pose2(1, 2, 0.5), Eigen::Matrix3d::Zero()};
  const Eigen::Vector3d along(0.3, 0.4, 0.0);
  line.covariance = along * along.transpose();  // of rank one
  double variance = 0.0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    RandomStream random(1, 2, i);
    const auto drawn = line.sample(random);
    const Eigen::Vector3d d = drawn.vector() - line.mean.vector();
    EXPECT_LT((d - along * (d.dot(along) / along.squaredNorm())).norm(), 1e-7);
    variance += d.squaredNorm() / 1000;
    EXPECT_TRUE(std::isfinite(line.logDensity(drawn)));
  }
  EXPECT_NEAR(variance, 0.25, 0.03);
}

TEST_F(ProposalTest, OfFastSlam1WeighsAtThePoseDrawn) {
  const auto drawn = propose(MotionProposal());
  for (std::size_t k = 0; k < predictions.size(); ++k) {
    const auto e = expect(model, drawn.mean, sight.sensor, map[k], sight.matches[k].z);
    EXPECT_EQ(predictions[k].S, e->R) << "without the noise of the motion";
    EXPECT_EQ(predictions[k].nu, e->nu);
  }
}

/// One observation: the pose's Gaussian is that of a Kalman update over (pose, landmark).
TEST_F(ProposalTest, OfFastSlam2IsTheMarginalOfAJointKalmanUpdate) {
  sight.matches.resize(1);
  const auto refined = propose(ConditionedProposal());

  Eigen::Matrix<double, 5, 5> P = Eigen::Matrix<double, 5, 5>::Zero();
  P.topLeftCorner<3, 3>() = prior.covariance;
  P.bottomRightCorner<2, 2>() = map[0].covariance();
  const auto e = expect(model, prior.mean, sight.sensor, map[0], sight.matches[0].z);
  Eigen::Matrix<double, 2, 5> H;
  H << e->H_robot, e->H_landmark;
  const Eigen::Matrix2d S = H * P * H.transpose() + sight.matches[0].z.covariance;
  const Eigen::Matrix<double, 5, 2> K = P * H.transpose() * S.inverse();
  const Eigen::VectorXd dx = K * e->nu;
  P -= (K * S * K.transpose()).eval();
  EXPECT_LT((refined.mean.vector() - prior.mean.vector() - dx.head<3>()).norm(), 1e-12);
  EXPECT_LT((refined.covariance - P.topLeftCorner<3, 3>()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((predictions[0].S - S).cwiseAbs().maxCoeff(), 1e-12) << "motion noise included";
}

TEST_F(ProposalTest, OfFastSlam2IsRefinedByEveryObservation) {
  std::vector<double> traces = {prior.covariance.trace()};
  const auto all = sight.matches;
  for (std::size_t count = 1; count <= all.size(); ++count) {
    sight.matches.assign(all.begin(), all.begin() + std::ptrdiff_t(count));
    const auto refined = propose(ConditionedProposal());
    EXPECT_LT(refined.covariance.trace(), traces.back());
    traces.push_back(refined.covariance.trace());
  }
  const auto refined = propose(ConditionedProposal());
  const auto before = (truth.vector() - prior.mean.vector()).norm();
  EXPECT_LT((truth.vector() - refined.mean.vector()).norm(), before);
}

TEST_F(ProposalTest, OfFastSlam2StaysPutWithoutMotion) {
  prior.covariance.setZero();
  const auto refined = propose(ConditionedProposal());
  EXPECT_EQ(refined.mean.vector(), prior.mean.vector());
  RandomStream random(1, 2, 3);
  EXPECT_EQ(refined.sample(random).vector(), prior.mean.vector());
}

TEST_F(ProposalTest, IsPulledTheLessTheFurtherOutAnOutlierLies) {
  const auto all = sight;
  sight.matches.erase(sight.matches.begin() + 1);
  const auto without = propose(ConditionedProposal());
  const auto pullOf = [&](double error) {
    sight = all;
    sight.matches[1].z.range += error;
    const auto refined = propose(ConditionedProposal());
    return (refined.mean.vector() - without.mean.vector()).norm();
  };
  EXPECT_GT(pullOf(2.0), pullOf(10.0));
  EXPECT_TRUE(predictions[1].gated);
  EXPECT_GT(pullOf(10.0), 3 * pullOf(50.0));
  EXPECT_LT(pullOf(1e6), 1e-6);
}

TEST_F(ProposalTest, FindsBothOfTwoOutliersUnlikelyAndTheNearerOneLessSo) {
  const Eigen::Matrix2d S = Eigen::Vector2d(0.04, 0.01).asDiagonal();
  const auto likelihood = [&](double sigmas) {
    return predictionOf({0.2 * sigmas, 0.0}, S, kGate).log_likelihood;
  };
  const double edge = std::sqrt(kGate);
  EXPECT_NEAR(likelihood(edge - 1e-6), likelihood(edge + 1e-6), 1e-4) << "without a step";
  EXPECT_GT(likelihood(edge), likelihood(6));
  EXPECT_GT(likelihood(6), likelihood(60));
  EXPECT_GT(likelihood(60), -0.5 * 60 * 60 / 2) << "but only so much";
}

TEST_F(ProposalTest, IsDoubtfulWhereMostEstablishedLandmarksAreElsewhere) {
  EXPECT_FALSE(isDoubtful(predictions.data(), 0));
  const auto predict = [&](int established, int wrong) {
    for (std::size_t slot = 0; slot < 3; ++slot) {
      auto landmark = map[slot];
      landmark.credit = int(slot) < established ? LandmarkEstimate::kEstablished : 1;
      map.edit(slot) = landmark;
    }
    const auto all = sight;
    for (int k = 0; k < wrong; ++k) sight.matches[std::size_t(k)].z.range += 100.0;
    propose(ConditionedProposal());
    sight = all;
    return isDoubtful(predictions.data(), 3);
  };
  EXPECT_FALSE(predict(3, 1));
  EXPECT_TRUE(predict(3, 2));
  EXPECT_FALSE(predict(2, 1));
  EXPECT_TRUE(predict(1, 1)) << "the only witness";
  EXPECT_FALSE(predict(0, 3)) << "nobody is one";
}

TEST_F(ProposalTest, LeavesALandmarkOutThatItStandsOn) {
  map.edit(1) = {(prior.mean * sight.sensor).position(), 0.01 * Eigen::Matrix2d::Identity()};
  const auto refined = propose(ConditionedProposal());
  EXPECT_TRUE(predictions[1].gated);
  EXPECT_TRUE(std::isfinite(predictions[1].log_likelihood));
  EXPECT_TRUE(refined.mean.isFinite());
}

TEST_F(ProposalTest, WeightsAreTheLikelihoodOfAllObservations) {
  propose(ConditionedProposal());
  double sum = 0.0;
  for (const auto& prediction : predictions) sum += prediction.log_likelihood;
  EXPECT_DOUBLE_EQ(PredictiveWeighting().logFactor(predictions.data(), 3), sum);
}

/// In a linear world target over proposal is the predictive likelihood wherever the pose falls.
TEST_F(ProposalTest, ImportanceCorrectsNothingWhereNothingBends) {
  prior.covariance *= 1e-6;
  for (std::size_t slot = 0; slot < 3; ++slot)
    map.edit(slot) = {map[slot].mean(), 1e-6 * map[slot].covariance()};
  for (auto& [slot, column, z] : sight.matches) {
    const Eigen::Vector2d expected = model.predict(prior.mean, sight.sensor, map[slot].mean());
    z = observation(expected.x() + 1e-4, expected.y());
    z.covariance *= 1e-6;
  }
  const auto refined = propose(ConditionedProposal());
  for (std::uint32_t i = 0; i < 20; ++i) {
    RandomStream random(5, 0, i);
    const auto drawn = refined.sample(random);
    EXPECT_NEAR(ImportanceWeighting().logCorrection(model, sight, map, prior, refined, drawn,
                                                    predictions.data()),
                0.0, 0.02);
  }
}

TEST_F(ProposalTest, ImportanceHasNothingToCorrectWhereThePoseWasWeighedItself) {
  const auto drawn = propose(MotionProposal());
  EXPECT_EQ(ImportanceWeighting().logCorrection(model, sight, map, prior, drawn, drawn.mean,
                                                predictions.data()),
            0.0);
}

TEST(LandmarkFilter, PutsANewLandmarkWhereEquation54Says) {
  const Pose2 robot(1, 2, M_PI / 2), sensor(0.3, 0.1, 0.0);
  const auto z = observation(2.0, 0.0);
  const auto landmark = initialized(RangeBearingModel(), robot, sensor, z);
  EXPECT_LT((landmark.mean() - Eigen::Vector2d(1 - 0.1, 2 + 0.3 + 2.0)).norm(), 1e-12);
  EXPECT_NEAR(landmark.yy, 0.01, 1e-12) << "range noise along the line of sight";
  EXPECT_NEAR(landmark.xx, 4 * 0.0004, 1e-12) << "bearing noise across it";
  EXPECT_NEAR(landmark.xy, -2 * 0.001, 1e-12);
}

TEST(LandmarkFilter, AveragesWhatItSees) {
  const Pose2 robot, sensor;
  const Eigen::Vector2d truth(4, 1);
  const RangeBearingModel model;
  const Eigen::Vector2d z = model.predict(robot, sensor, truth);
  auto landmark = initialized(model, robot, sensor, observation(z.x() + 0.1, z.y()));
  const double first = landmark.covariance().trace();
  for (int i = 0; i < 99; ++i)
    landmark =
        updated(model, robot, sensor, landmark, observation(z.x() + (i % 2 ? 0.1 : -0.1), z.y()));
  EXPECT_LT((landmark.mean() - truth).norm(), 5e-3);
  EXPECT_NEAR(landmark.covariance().trace(), first / 100, 0.02 * first / 100);
}

TEST(LandmarkFilter, BeginsALandmarkAnewThatIsNeverSeenWhereItShouldBe) {
  const Pose2 robot, sensor;
  const RangeBearingModel model;
  auto stray = initialized(model, robot, sensor, observation(80.0, 0.0));
  takeSighting(model, robot, sensor, observation(2.0, 0.0), false, stray);
  EXPECT_LT((stray.mean() - Eigen::Vector2d(2, 0)).norm(), 1e-12);

  auto trusted = initialized(model, robot, sensor, observation(2.0, 0.0));
  for (int i = 0; i < 100; ++i)
    takeSighting(model, robot, sensor, observation(2.0, 0.0), true, trusted);
  for (int i = 0; i < LandmarkEstimate::kMostCredit; ++i) {
    takeSighting(model, robot, sensor, observation(4.0, 0.0), false, trusted);
    EXPECT_LT((trusted.mean() - Eigen::Vector2d(2, 0)).norm(), 1e-9) << "a few may be wrong";
  }
  takeSighting(model, robot, sensor, observation(4.0, 0.0), false, trusted);
  EXPECT_LT((trusted.mean() - Eigen::Vector2d(4, 0)).norm(), 1e-12) << "it was moved";
}

TEST(LandmarkFilter, StaysPositiveDefiniteWithSensorsThatClaimToBeExact) {
  const Pose2 robot, sensor;
  auto exact = observation(2.0, 0.5);
  exact.covariance = 1e-14 * Eigen::Matrix2d::Identity();
  LandmarkEstimate landmark({1.7, 1.0}, Eigen::Matrix2d::Identity());
  for (int i = 0; i < 1000; ++i) {
    landmark = updated(RangeBearingModel(), robot, sensor, landmark, exact);
    ASSERT_GT(landmark.xx, 0.0);
    ASSERT_GT(landmark.covariance().determinant(), 0.0) << "update " << i;
  }
}

}  // namespace
}  // namespace slam::particle_filter
