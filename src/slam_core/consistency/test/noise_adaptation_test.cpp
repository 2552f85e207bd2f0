// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/noise_adaptation.hpp"

#include <gtest/gtest.h>

#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam {
namespace {

using Source = ConsistencyMonitor::Source;

/// What is learnt on a drive of an EKF, whose inputs have the noise that was learnt so far.
class NoiseAdaptationTest : public testing::Test {
 protected:
  struct Errors {
    double way = 1.0;    ///< factor on the odometry's way
    double range = 1.0;  ///< factor on the noise of ranges
  };

  void drive(std::uint64_t seed, const Errors& errors, int updates) {
    ekf::EkfSlam ekf;
    ekf.configure(ekf::EkfConfig());
    test::ComponentDriver inputs(ekf);
    const auto* mapper = capabilitiesOf(ekf).find<LandmarkMapper>();
    test::SimulatedWorld world(seed);
    ConsistencyMonitor monitor;
    for (int i = 0; i < updates; ++i) {
      auto step = world.next();
      const auto u = step.motion.increment.vector();
      step.motion.increment = Pose2(errors.way * u.x(), errors.way * u.y(), u.z());
      for (auto& z : step.observations.observations)
        z.covariance(0, 0) /= errors.range * errors.range;
      inputs.set(noise_.scaled(step.motion));
      inputs.set(noise_.scaled(step.observations));
      ekf.execute();
      monitor.add(mapper->statistics());
      if (noise_.learn(monitor, mapper->statistics())) monitor = ConsistencyMonitor();
    }
  }

  NoiseAdaptation noise_;
};

TEST_F(NoiseAdaptationTest, LeavesNoiseThatIsRight) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) drive(seed, {}, 300);
  EXPECT_TRUE(noise_.isNeutral());
}

TEST_F(NoiseAdaptationTest, FindsASensorThatIsFourTimesAsNoisyAsItReports) {
  Errors errors;
  errors.range = 4.0;
  drive(1, errors, 200);
  EXPECT_GT(noise_.scale(Source::kRange), 2.5);
  EXPECT_LT(noise_.scale(Source::kRange), 6.0);
  EXPECT_EQ(noise_.scale(Source::kBearing), 1.0);
}

TEST_F(NoiseAdaptationTest, BlamesTheWayWhereItsScaleIsWrong) {
  Errors errors;
  errors.way = 0.9;
  drive(1, errors, 200);
  EXPECT_GT(noise_.scale(Source::kMotion), 2.0);
}

TEST_F(NoiseAdaptationTest, TakesBackWhatIsOver) {
  Errors errors;
  errors.range = 6.0;
  drive(1, errors, 200);
  const double before = noise_.scale(Source::kRange);
  ASSERT_GT(before, 3.0);
  drive(2, {}, 600);
  EXPECT_LT(noise_.scale(Source::kRange), 0.7 * before);
}

TEST_F(NoiseAdaptationTest, ScalesSigmasAndNothingElse) {
  Errors errors;
  errors.range = 4.0;
  drive(1, errors, 200);
  const double factor = noise_.scale(Source::kRange);
  LandmarkObservationArray array;
  array.observations.emplace_back();
  array.observations[0].range = 2.0;
  array.observations[0].covariance << 0.04, 0.001, 0.001, 0.01;
  const auto scaled = noise_.scaled(array).observations[0];
  EXPECT_EQ(scaled.range, 2.0);
  EXPECT_DOUBLE_EQ(scaled.covariance(0, 0), 0.04 * factor * factor);
  EXPECT_DOUBLE_EQ(scaled.covariance(0, 1), 0.001 * factor);
  EXPECT_DOUBLE_EQ(scaled.covariance(1, 1), 0.01);
}

TEST_F(NoiseAdaptationTest, EnlargesNoCovarianceBeyondWhatAnInputMayHave) {
  Errors errors;
  errors.range = 4.0;
  drive(1, errors, 200);
  ASSERT_GT(noise_.scale(Source::kRange), 2.0);
  LandmarkObservationArray array;
  array.observations.emplace_back();
  auto& z = array.observations[0];
  z.range = 2.0;
  z.covariance = Eigen::Vector2d(0.5e6, 0.01).asDiagonal();
  ASSERT_EQ(faultOf(z), "");
  EXPECT_EQ(faultOf(noise_.scaled(array).observations[0]), "");
}

}  // namespace
}  // namespace slam
