// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/camera_gate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

class CameraGateTest : public testing::Test {
 protected:
  CameraGateTest() { gate_.configure(CameraConfig()); }

  static CameraCalibration calibration() { return {8, 6, "plumb_bob", 5, 5, 3.5, 2.5, {}}; }
  static CameraMount mount() {
    return {"camera", Eigen::Isometry3d(Eigen::Translation3d(1, 0, 0))};
  }
  /// The image is of one gray.
  static Image imageAt(double s, int width = 8, int height = 6, int type = CV_8UC1) {
    return {Stamp(durationFromSeconds(s)), "camera", cv::Mat::zeros(height, width, type), ""};
  }
  void calibrate() {
    gate_.set(calibration());
    gate_.set(mount());
  }
  void send(const Image& image) { gate_.set(image); }
  Status next() { return gate_.execute(); }
  std::uint64_t count(const std::string& reason) const { return gate_.counters()[reason]; }
  bool isUsable() const { return gate_.view() && gate_.view()->isUsable(); }
  /// The stamps [s] that come out, usable or not.
  std::vector<double> drain() {
    std::vector<double> stamps;
    for (next(); gate_.view(); next()) stamps.push_back(seconds(gate_.view()->stamp - Stamp()));
    return stamps;
  }

  CameraGate gate_;
};

bool says(const Status& status, const std::string& words) {
  return status.message.find(words) != std::string::npos;
}

TEST_F(CameraGateTest, LetsImagesOutInTheirOrder) {
  calibrate();
  for (const double s : {1.0, 2.0, 3.0}) send(imageAt(s));
  EXPECT_EQ(drain(), (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(gate_.counters().all().empty());
}

TEST_F(CameraGateTest, HoldsImagesUntilCalibrationAndMountAreKnown) {
  send(imageAt(1));
  EXPECT_TRUE(next().isOk()) << "the first image before the calibration is not worth a word";
  EXPECT_FALSE(gate_.view());
  gate_.set(calibration());
  next();
  EXPECT_FALSE(gate_.view()) << "an identity mount is never assumed";
  gate_.set(mount());
  next();
  ASSERT_TRUE(gate_.view());
  EXPECT_TRUE(isUsable());
  EXPECT_EQ(gate_.view()->mount.T_base_camera.translation().x(), 1.0);
}

TEST_F(CameraGateTest, SaysWhatItWaitsFor) {
  send(imageAt(1));
  send(imageAt(2.5));
  EXPECT_TRUE(says(next(), "camera_info"));
  gate_.set(calibration());
  const auto status = next();
  EXPECT_TRUE(says(status, "'camera'")) << status.message;
  EXPECT_TRUE(says(status, "camera.sensor_pose")) << status.message;
}

TEST_F(CameraGateTest, LetsTheOldestOutAsUnusableWhenItHoldsTooMany) {
  for (std::size_t i = 0; i < CameraGate::kCapacity + 2; ++i) send(imageAt(0.1 * i));
  EXPECT_TRUE(says(next(), "camera_info"));
  ASSERT_TRUE(gate_.view());
  EXPECT_EQ(gate_.view()->stamp, Stamp());
  EXPECT_FALSE(isUsable());
  next();
  EXPECT_TRUE(gate_.view());
  next();
  EXPECT_FALSE(gate_.view()) << "the rest is held";
  EXPECT_EQ(count("no_calibration"), 2u);
  EXPECT_EQ(gate_.held()["no_calibration"], CameraGate::kCapacity);
  calibrate();
  EXPECT_EQ(drain().size(), CameraGate::kCapacity);
}

TEST_F(CameraGateTest, DropsImagesThatComeLate) {
  calibrate();
  for (const double s : {1.0, 2.0, 2.0, 1.5, 3.0}) send(imageAt(s));
  EXPECT_TRUE(says(next(), "not newer"));
  EXPECT_EQ(drain(), (std::vector<double>{2, 3}));
  EXPECT_EQ(count("late"), 2u);
}

TEST_F(CameraGateTest, SaysThatADriverSetsNoStamps) {
  calibrate();
  send(imageAt(0));
  send(imageAt(0));
  EXPECT_TRUE(says(next(), "an image has the stamp 0, since its driver sets none"));
}

TEST_F(CameraGateTest, TakesAStepBackOfSecondsForANewBeginning) {
  calibrate();
  for (const double s : {100.0, 95.5, 95.0, 95.1}) send(imageAt(s));
  EXPECT_EQ(drain(), (std::vector<double>{100, 95, 95.1}));
  EXPECT_EQ(count("late"), 1u);
}

TEST_F(CameraGateTest, LetsImagesOutAsUnusableThatDoNotFit) {
  calibrate();
  const auto reasonOf = [&](const Image& image, const std::string& reason,
                            const std::string& words) {
    send(image);
    const auto status = next();
    EXPECT_TRUE(gate_.view()) << "moves time on";
    EXPECT_FALSE(isUsable());
    EXPECT_EQ(count(reason), 1u) << reason;
    EXPECT_TRUE(says(status, words)) << status.message;
  };
  reasonOf(imageAt(1, 4, 3), "image_size", "4x3 px does not fit the calibration for 8x6 px");
  auto faulty = imageAt(2);
  faulty.fault = "the encoding 'yuv422' is not known";
  reasonOf(faulty, "unreadable", "yuv422");
  auto colour = imageAt(3, 8, 6, CV_8UC3);
  send(colour);
  EXPECT_TRUE(says(next(), "8 bit gray"));
  send({Stamp(durationFromSeconds(4)), "camera", {}, ""});
  EXPECT_TRUE(says(next(), "empty"));
  EXPECT_EQ(count("unreadable"), 3u);
}

TEST_F(CameraGateTest, UsesNoCalibrationOrMountThatCannotBeRight) {
  auto bad = calibration();
  bad.fx = bad.fy = 0;
  gate_.set(bad);
  gate_.set(mount());
  send(imageAt(1));
  EXPECT_TRUE(says(next(), "not calibrated"));
  EXPECT_TRUE(gate_.view() && !isUsable());
  gate_.set(calibration());
  auto torn = mount();
  torn.T_base_camera.translation().x() = NAN;
  gate_.set(torn);
  send(imageAt(2));
  EXPECT_TRUE(says(next(), "mount"));
  EXPECT_TRUE(gate_.view() && !isUsable());
  EXPECT_EQ(count("bad_calibration"), 1u);
  EXPECT_EQ(count("bad_mount"), 1u);
  calibrate();
  send(imageAt(3));
  EXPECT_TRUE(next().isOk()) << "a corrected calibration counts at once";
  EXPECT_TRUE(isUsable());
}

TEST_F(CameraGateTest, LetsAnImageThatComesAgainOutAsRepeated) {
  calibrate();
  auto image = imageAt(1);
  image.gray.at<std::uint8_t>(2, 3) = 9;
  send(image);
  EXPECT_TRUE(next().isOk());
  image.gray = image.gray.clone();
  for (const double s : {1.1, 1.2, 1.25}) {
    image.stamp = Stamp(durationFromSeconds(s));
    send(image);
    EXPECT_EQ(says(next(), "same image again"), s > 1.2) << "single ones are not worth a word";
    EXPECT_FALSE(isUsable());
    EXPECT_TRUE(gate_.view()->is_repeated);
    EXPECT_TRUE(gate_.view()->camera) << "who trusts it can use it";
  }
  image.gray = image.gray.clone();
  image.gray.at<std::uint8_t>(2, 3) = 10;
  image.stamp = Stamp(durationFromSeconds(1.3));
  send(image);
  EXPECT_TRUE(next().isOk());
  EXPECT_TRUE(isUsable()) << "its noise makes each image another one";
  EXPECT_EQ(count("repeated"), 3U);
}

TEST_F(CameraGateTest, TakesImagesOfOneGrayForALensCap) {
  calibrate();
  for (const double s : {1.0, 1.1}) send(imageAt(s));
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(next().isOk());
    EXPECT_TRUE(isUsable());
  }
}

TEST_F(CameraGateTest, LeavesOutImagesOfAnotherFocalLengthThanTheFirst) {
  calibrate();
  const auto take = [&](double stamp, double zoom, double size = 1.0) {
    auto other = calibration();
    other.fx *= zoom * size;
    other.fy *= zoom * size;
    other.width = static_cast<int>(size * other.width);
    other.height = static_cast<int>(size * other.height);
    gate_.set(other);
    auto image = imageAt(stamp);
    image.gray = cv::Mat(other.height, other.width, CV_8UC1, cv::Scalar(stamp * 10.0));
    send(image);
    return next();
  };
  EXPECT_TRUE(take(1.0, 1.0).isOk());
  EXPECT_TRUE(take(1.1, 1.01).isOk()) << "as of an automatic focus";
  EXPECT_TRUE(says(take(1.2, 1.3), "has changed its focal length"));
  EXPECT_FALSE(isUsable());
  EXPECT_TRUE(take(1.3, 1.0).isOk()) << "as before";
  EXPECT_TRUE(isUsable());
  EXPECT_TRUE(take(1.4, 1.0, 2.0).isOk()) << "another resolution has another focal length";
  EXPECT_EQ(count("calibration_changed"), 1U);
  gate_.reset();
  EXPECT_TRUE(take(0.5, 1.3).isOk()) << "after a fresh start";
}

TEST_F(CameraGateTest, PrefersTheConfiguredMount) {
  CameraConfig config;
  config.sensor_pose = {0.1, 0.2, 0.3, -M_PI / 2, 0, -M_PI / 2};
  gate_.configure(config);
  gate_.set(calibration());
  gate_.set(mount());
  send(imageAt(1));
  next();
  ASSERT_TRUE(isUsable());
  const auto& T = gate_.view()->mount.T_base_camera;
  EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_TRUE(T.linear().col(2).isApprox(Eigen::Vector3d::UnitX(), 1e-12)) << "looks ahead";
  EXPECT_TRUE(T.linear().col(0).isApprox(-Eigen::Vector3d::UnitY(), 1e-12)) << "x to the right";
}

TEST_F(CameraGateTest, KeepsCalibrationAndMountThroughAReset) {
  calibrate();
  send(imageAt(10));
  gate_.reset();
  EXPECT_TRUE(drain().empty());
  send(imageAt(9));
  next();
  EXPECT_TRUE(isUsable());
}

TEST(CameraConfig, RefusesASensorPoseOfAnotherLength) {
  CameraConfig config;
  config.sensor_pose = {1, 2, 3};
  EXPECT_TRUE(test::oneSays(test::faultsOf([&] { CameraGate().configure(config); }),
                            {"camera.sensor_pose", "3 values", "6"}));
}

}  // namespace
}  // namespace slam
