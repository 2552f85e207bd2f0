// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_imu_odometry.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "slam_core/camera/test/camera_feed.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/gyro/test/turning_robot.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::visual_odometry {
namespace {

namespace ceilings = slam::test::ceilings;
using gyro::test::TurningRobot;

/// A robot with a camera that looks up and a gyro. It turns for 6 s, which confirms the gyro, and
/// goes on turning the other way.
class CameraAndGyro : public testing::Test {
 protected:
  CameraAndGyro() : robot_(1, {}, {0.008, 2e-5, 2e-4, 0.005}, {10.0, 100.0}) {
    loadLibraries({});
    robot_.drive({{6.0, 0.1, 0.3}, {4.0, 0.1, -0.6}, {1.0, 0.1, 0.0}});
  }

  void drive(const std::string& name, double dark_since, double dark_until) {
    source_ = Registry<OdometrySource>::instance().create(name);
    Settings settings({}, {}, {"visual_odometry.ceiling_height=1.7"});
    source_->configure(settings);
    inputs_ = std::make_unique<slam::test::ComponentDriver>(*source_);
    slam::test::CameraFeed camera;
    camera.gate.set(ceilings::smallCamera());
    camera.gate.set(ceilings::mountUp());
    motions_.clear();
    message_.clear();
    has_drawn_ = false;
    auto sample = robot_.gyro().begin();
    std::uint64_t images = 0;
    for (const auto& [stamp, pose] : robot_.truth()) {
      const auto until = stamp + std::chrono::milliseconds(50);
      for (; sample != robot_.gyro().end() && sample->stamp <= until; ++sample)
        if (name == "visual_imu") take(*sample);
      const double second = seconds(stamp - robot_.truth().front().stamp);
      const bool is_dark = second >= dark_since && second < dark_until;
      const auto light = ceiling_.seenBy(ceilings::mountUp(), pose);
      const ceilings::Exposure exposure{is_dark ? 0.0 : 1.0, 0.0, 2.0};
      camera.show({stamp, "ceiling_camera", ceilings::exposed(light, exposure, ++images), ""},
                  [&](const CameraView& view) {
                    take(view);
                    return Status::ok();
                  });
    }
  }
  template <class Input>
  void take(const Input& input) {
    inputs_->set(input);
    do {
      const auto status = source_->execute();
      if (!status.isOk()) message_ = status.message;
      if (source_->motion()) motions_.push_back(*source_->motion());
      const auto* drawer = dynamic_cast<const ViewDrawer*>(source_.get());
      has_drawn_ = has_drawn_ || (drawer != nullptr && !drawer->drawing().empty());
    } while (source_->isBusy());
  }
  /// @param index of a motion, at whose end the error is
  double headingError(std::size_t index) const {
    return robot_.truth()[index + 1].pose.between(motions_[index].odometry_end).theta();
  }

  const VisualImuOdometry of_library_;  // or the library would not be linked
  const ceilings::Ceiling ceiling_;
  TurningRobot robot_;
  std::unique_ptr<OdometrySource> source_;
  std::unique_ptr<slam::test::ComponentDriver> inputs_;
  std::vector<Motion> motions_;
  std::string message_;
  bool has_drawn_ = false;
};

TEST_F(CameraAndGyro, KnowTheTurnWhereTheImagesTellNothing) {
  drive("visual_imu", 6.5, 8.5);
  constexpr std::size_t kInTheDark = 83, kAfterwards = 105;
  ASSERT_EQ(motions_.size(), robot_.truth().size() - 1);
  EXPECT_NE(message_.find("the last velocity and the gyro are used meanwhile"), std::string::npos)
      << message_;
  EXPECT_NEAR(headingError(kInTheDark), 0.0, 0.02);
  EXPECT_LT(std::sqrt(motions_[kInTheDark].covariance(2, 2)), 0.05);
  EXPECT_NEAR(headingError(kAfterwards), 0.0, 0.01);
  for (const auto& motion : motions_) EXPECT_EQ(faultOf(motion), "");
  drive("visual", 6.5, 8.5);
  EXPECT_GT(std::sqrt(motions_[kInTheDark].covariance(2, 2)), 0.5);
}

TEST_F(CameraAndGyro, TheCameraGoesOnAloneInTheLight) {
  drive("visual", 1e9, 1e9);
  const auto alone = motions_;
  drive("visual_imu", 1e9, 1e9);
  ASSERT_EQ(motions_.size(), alone.size());
  EXPECT_EQ(message_, "");
  EXPECT_TRUE(has_drawn_);
  EXPECT_NEAR(headingError(motions_.size() - 1), 0.0, 0.01);
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(motions_[i].increment.theta(), alone[i].increment.theta(), 0.005) << i;
}

}  // namespace
}  // namespace slam::visual_odometry
