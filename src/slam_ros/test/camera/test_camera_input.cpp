// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "slam_ros/camera_input.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/latency_window.hpp"

namespace slam_ros {
namespace {

tf2_msgs::TFMessage edge(const std::string& parent, const std::string& child, double x,
                         double yaw = 0.0) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  auto& transform = message.transforms.front();
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.z = std::sin(yaw / 2);
  transform.transform.rotation.w = std::cos(yaw / 2);
  return message;
}

sensor_msgs::Image image(const std::string& frame) {
  sensor_msgs::Image message;
  message.header.frame_id = frame;
  message.encoding = "mono8";
  message.width = message.height = message.step = 1;
  message.data = {9};
  return message;
}

/// What came out, in order.
struct CameraInputTest : ::testing::Test {
  CameraInput camera{"base_link",
                     {[this](const slam::Image&) { came.push_back("image"); },
                      [this](const slam::CameraCalibration&) { came.push_back("calibration"); },
                      [this](const slam::CameraMount& known) {
                        came.push_back("mount");
                        mount = known;
                      }}};
  std::vector<std::string> came;
  slam::CameraMount mount;
};

using Order = std::vector<std::string>;

TEST_F(CameraInputTest, TheMountIsTheWholeChainOfTransforms) {
  camera.take(edge("base_link", "mast", 1.0, M_PI / 2));
  camera.take(edge("mast", "camera", 0.5));
  camera.take(image("camera"));
  EXPECT_EQ(came, (Order{"mount", "image"}));
  EXPECT_EQ(mount.camera_frame, "camera");
  EXPECT_TRUE(mount.T_base_camera.translation().isApprox(Eigen::Vector3d(1.0, 0.5, 0.0)));
  EXPECT_TRUE(
      (mount.T_base_camera.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
}

TEST_F(CameraInputTest, ATransformThatComesAfterTheImageIsPassedOnThen) {
  camera.take(image("/camera"));
  EXPECT_EQ(camera.missingTransform(), "base_link -> camera");
  camera.take(edge("base_link", "other", 1.0));
  EXPECT_EQ(came, (Order{"image"}));
  camera.take(edge("/base_link", "/camera", 1.0));
  EXPECT_EQ(came, (Order{"image", "mount"}));
  EXPECT_EQ(camera.missingTransform(), "");
}

TEST_F(CameraInputTest, WhatIsRepeatedIsPassedOnOnce) {
  for (int i = 0; i < 3; ++i) {
    camera.take(edge("base_link", "camera", 1.0));
    camera.take(sensor_msgs::CameraInfo());
    camera.take(image("camera"));
  }
  EXPECT_EQ(came, (Order{"calibration", "mount", "image", "image", "image"}));
}

TEST_F(CameraInputTest, WhatChangesIsPassedOnAgain) {
  camera.take(edge("base_link", "camera", 1.0));
  camera.take(image("camera"));
  sensor_msgs::CameraInfo info;
  camera.take(info);
  info.K[0] = 300;
  camera.take(info);
  camera.take(edge("base_link", "camera", 2.0));
  EXPECT_EQ(came, (Order{"mount", "image", "calibration", "calibration", "mount"}));
  EXPECT_EQ(mount.T_base_camera.translation().x(), 2.0);
}

TEST_F(CameraInputTest, ATransformThatIsNoneIsAFaultUntilOneComes) {
  auto zeros = edge("base_link", "camera", 1.0);
  zeros.transforms[0].transform.rotation = geometry_msgs::Quaternion();
  for (const auto& none : {edge("base_link", "camera", std::nan("")), zeros}) {
    camera.take(none);
    camera.take(image("camera"));
    EXPECT_NE(slam::faultOf(mount), "");
  }
  camera.take(edge("base_link", "camera", 1.0));
  EXPECT_EQ(slam::faultOf(mount), "");
}

TEST_F(CameraInputTest, AnImageWithoutAFrameMissesItsTransform) {
  camera.take(edge("base_link", "camera", 1.0));
  camera.take(image(""));
  EXPECT_EQ(camera.missingTransform(), "base_link -> (no frame)");
}

TEST(CameraTopics, AreNamedAsImageTransportDoes) {
  for (const auto* name : {"camera/image_raw", "camera/image_raw/compressed"}) {
    const auto topics = cameraTopics(name);
    EXPECT_EQ(topics.raw, "camera/image_raw");
    EXPECT_EQ(topics.compressed, "camera/image_raw/compressed");
    EXPECT_EQ(topics.info, "camera/camera_info");
  }
  EXPECT_EQ(cameraTopics("image").info, "camera_info");
}

TEST(LatencyWindow, TellsRateAndPercentilesOfTheLastHundred) {
  LatencyWindow window;
  EXPECT_EQ(window.rate(), 0.0);
  LatencyWindow::Clock::time_point now;
  for (int i = 1; i <= 150; ++i) {
    now += std::chrono::milliseconds(100);
    window.add(now - std::chrono::milliseconds(i), now);
  }
  EXPECT_NEAR(window.rate(), 10.0, 1e-9);
  EXPECT_NEAR(window.milliseconds(0.5), 100.0, 1e-9);
  EXPECT_NEAR(window.milliseconds(0.99), 149.0, 1e-9);
}

}  // namespace
}  // namespace slam_ros
