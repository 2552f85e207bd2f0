// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/mono_ekf/mono_ekf.hpp"
#include "slam_core/mono_ekf/test/textured_room.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::mono_ekf {
namespace {

/// A robot that goes round in a room whose four walls look alike. Its odometry is exact and claims
/// some noise.
class MonoEkfAmongEqualWalls : public testing::Test {
 protected:
  MonoEkfAmongEqualWalls() { filter_.configure(MonoEkfConfig()); }

  void step() {
    Motion motion;
    motion.start = Stamp(durationFromSeconds(0.1 * images_));
    motion.end = Stamp(durationFromSeconds(0.1 * ++images_));
    motion.increment = Pose2::exp({0.05, 0.0, 0.05});
    motion.covariance = Eigen::Vector3d(1e-5, 1e-5, 1e-4).asDiagonal();
    truth_ = truth_ * motion.increment;
    inputs_.set(motion);
    inputs_.set(room_.look(Pose2(0.0, -1.0, 0.0) * truth_, motion.end));
    filter_.execute();
  }
  bool isLost() { return as<LostReporter>(filter_).lostSince().has_value(); }

  static constexpr int kLap = 126;

  test::TexturedRoom room_{3, 4.0, test::PaintedRoom::Walls::kAlike};
  MonoEkf filter_;
  test::ComponentDriver inputs_{filter_};
  Pose2 truth_;
  int images_ = 0;
};

TEST_F(MonoEkfAmongEqualWalls, IsNotPutBeforeTheWrongOneAfterItWasCarried) {
  for (int i = 0; i < kLap + 20; ++i) step();
  ASSERT_FALSE(isLost());
  EXPECT_LT((filter_.pose().pose.position() - truth_.position()).norm(), 0.1);
  truth_ = truth_ * Pose2(0.3, 0.2, 0.8);
  bool was_lost = false;
  for (int i = 0; i < 80; ++i) {
    step();
    was_lost |= isLost();
    if (i < 10 || isLost()) continue;
    EXPECT_LT((filter_.pose().pose.position() - truth_.position()).norm(), 0.3) << i;
  }
  EXPECT_TRUE(was_lost);
}

}  // namespace
}  // namespace slam::mono_ekf
