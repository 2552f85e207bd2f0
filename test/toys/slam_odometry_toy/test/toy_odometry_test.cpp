// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "toy_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam_toy {
namespace {

slam::OdometrySample sampleAt(int second, const slam::Pose2& pose) {
  slam::OdometrySample sample;
  sample.stamp = slam::stampFromNanoseconds(second * 1000000000LL);
  sample.pose = pose;
  return sample;
}

class ToyOdometryTest : public testing::Test {
 protected:
  ToyOdometryTest() {
    slam::Settings settings({}, {}, {"toy_odometry.relative_sigma=0.1", "toy_odometry.floor=0.01"});
    odometry_->configure(settings);
  }
  const std::optional<slam::Motion>& after(const slam::OdometrySample& sample) {
    inputs_.set(sample);
    odometry_->execute();
    return odometry_->motion();
  }

  std::unique_ptr<slam::OdometrySource> odometry_ =
      slam::Registry<slam::OdometrySource>::instance().create("toy");
  slam::test::ComponentDriver inputs_{*odometry_};
};

TEST_F(ToyOdometryTest, GivesWhatLiesBetweenTwoPosesInTheRobotsFrame) {
  EXPECT_FALSE(after(sampleAt(1, {5, 5, M_PI / 2})));
  const auto motion = after(sampleAt(2, {5, 7, M_PI / 2 + 0.5}));
  ASSERT_TRUE(motion);
  EXPECT_LT((motion->increment.vector() - Eigen::Vector3d(2, 0, 0.5)).norm(), 1e-12);
  EXPECT_NEAR(motion->covariance(0, 0), std::pow(0.1 * 2 + 0.01, 2), 1e-12);
  EXPECT_NEAR(motion->covariance(2, 2), std::pow(0.1 * 0.5 + 0.01, 2), 1e-12);
  EXPECT_EQ(slam::faultOf(*motion), "");
}

TEST_F(ToyOdometryTest, LeavesOutWhatIsLateOrNoNumber) {
  after(sampleAt(1, {}));
  EXPECT_FALSE(after(sampleAt(1, {1, 0, 0})));
  EXPECT_FALSE(after(sampleAt(2, {std::nan(""), 0, 0})));
  EXPECT_EQ(odometry_->counters()["late"], 1U);
  EXPECT_EQ(odometry_->counters()["invalid"], 1U);
  const auto motion = after(sampleAt(3, {1, 0, 0}));
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->start, slam::stampFromNanoseconds(1000000000LL));
}

}  // namespace
}  // namespace slam_toy
