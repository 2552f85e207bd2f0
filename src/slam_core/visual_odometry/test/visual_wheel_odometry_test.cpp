// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_wheel_odometry.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "slam_core/camera/test/camera_feed.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::visual_odometry {
namespace {

namespace ceilings = slam::test::ceilings;

Stamp at(double t) { return Stamp(std::chrono::seconds(10)) + durationFromSeconds(t); }

/// A robot that drives along x at 0.5 m/s; its wheels tell all of it, 5 % too long.
class VisualWheelTest : public testing::Test {
 protected:
  VisualWheelTest() {
    loadLibraries({});
    source_ = Registry<OdometrySource>::instance().create("visual_wheel");
    Settings settings({}, {}, {"visual_odometry.ceiling_height=1.7"});
    source_->configure(settings);
    inputs_.emplace(*source_);
    camera_.gate.set(ceilings::smallCamera());
    camera_.gate.set(ceilings::mountUp());
  }

  void execute() {
    do {
      const auto status = source_->execute();
      if (!status.isOk()) message_ = status.message;
      if (source_->motion()) motions_.push_back(*source_->motion());
    } while (source_->isBusy());
  }
  void turnWheels(double t) {
    OdometrySample sample;
    sample.stamp = at(t);
    sample.pose = Pose2(1.05 * 0.5 * t, 0.0, 0.0);
    inputs_->set(sample);
    execute();
  }
  void look(double t, bool dark = false) {
    static const ceilings::Ceiling kCeiling;
    const auto light = kCeiling.seenBy(ceilings::mountUp(), Pose2(0.5 * t, 0.0, 0.0));
    const ceilings::Exposure exposure{dark ? 0.0 : 1.0, 0.0, 2.0};
    show({at(t), "ceiling_camera", ceilings::exposed(light, exposure, ++images_), ""});
  }
  void show(const Image& image) {
    camera_.show(image, [&](const CameraView& view) {
      inputs_->set(view);
      execute();
      return Status::ok();
    });
  }

  std::unique_ptr<OdometrySource> source_;
  std::optional<slam::test::ComponentDriver> inputs_;
  slam::test::CameraFeed camera_;
  std::vector<Motion> motions_;
  std::string message_;
  std::uint64_t images_ = 0;
};

TEST_F(VisualWheelTest, TakesTheWheelsWhereTheImagesTellNothing) {
  for (int i = 0; i < 12; ++i) {
    turnWheels(0.1 * i);
    turnWheels(0.1 * i + 0.05);
    look(0.1 * i + 0.02, i >= 4 && i < 8);
  }
  ASSERT_EQ(motions_.size(), 11u);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const bool is_dark = i >= 3 && i < 7;
    if (i == 7) continue;  // takes back what the wheels were wrong by
    EXPECT_NEAR(motions_[i].increment.x(), is_dark ? 0.0525 : 0.05, 0.0015) << i;
    EXPECT_EQ(faultOf(motions_[i]), "");
  }
  EXPECT_NEAR(motions_.back().odometry_end.x(), 0.55, 0.004);
  EXPECT_NE(message_.find("the wheels' motion is used meanwhile"), std::string::npos) << message_;
}

TEST_F(VisualWheelTest, TakesTheWheelsWhereTheCameraRepeatsAnImage) {
  static const ceilings::Ceiling kCeiling;
  const auto light = kCeiling.seenBy(ceilings::mountUp(), Pose2(0.2, 0.0, 0.0));
  const auto hung = ceilings::exposed(light, {1.0, 0.0, 2.0}, 7);
  for (int i = 0; i < 12; ++i) {
    turnWheels(0.1 * i + 0.05);
    if (i < 4)
      look(0.1 * i + 0.02);
    else
      show({at(0.1 * i + 0.02), "ceiling_camera", hung, ""});
  }
  ASSERT_EQ(motions_.size(), 11U);
  for (std::size_t i = 4; i < motions_.size(); ++i)
    EXPECT_NEAR(motions_[i].increment.x(), 0.0525, 0.0015) << i;
}

TEST_F(VisualWheelTest, DoesNotDependOnTheOrderOfArrival) {
  std::vector<std::vector<Motion>> runs;
  for (const bool wheels_first : {true, false}) {
    source_->reset();
    camera_.gate.reset();
    motions_.clear();
    images_ = 0;
    for (int i = 0; i < 8; ++i) {
      if (wheels_first) turnWheels(0.1 * i + 0.05);
      look(0.1 * i + 0.02, i == 4);
      if (!wheels_first) turnWheels(0.1 * i + 0.05);
    }
    runs.push_back(motions_);
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    EXPECT_EQ(runs[0][i].increment.vector(), runs[1][i].increment.vector()) << i;
    EXPECT_EQ(runs[0][i].covariance, runs[1][i].covariance) << i;
  }
}

TEST_F(VisualWheelTest, GoesOnWithoutWheelsThatAreSilent) {
  for (int i = 0; i < 20; ++i) look(0.1 * i);
  EXPECT_GE(motions_.size(), 8u);
  EXPECT_GT(source_->counters()["wheels_missing"], 0u);
  EXPECT_NEAR(motions_.back().increment.x(), 0.05, 0.003);
}

}  // namespace
}  // namespace slam::visual_odometry
