// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>

#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "slam_ros/conversions.hpp"
#include "slam_ros/image_conversions.hpp"

namespace slam_ros {
namespace {

constexpr int kWidth = 64, kHeight = 48;

/// A grey slope with a dark square, which survives JPEG and Bayer patterns.
cv::Mat grayPicture() {
  cv::Mat gray(kHeight, kWidth, CV_8UC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      gray.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(60 + x + y);
  gray(cv::Rect(16, 16, 16, 16)).setTo(20);
  return gray;
}

sensor_msgs::Image message(const cv::Mat& pixels, const std::string& encoding) {
  sensor_msgs::Image image;
  image.header.stamp = ros::Time(12, 345);
  image.header.frame_id = "/camera";
  image.width = kWidth;
  image.height = kHeight;
  image.encoding = encoding;
  image.step = static_cast<std::uint32_t>(pixels.elemSize() * kWidth);
  image.data.assign(pixels.datastart, pixels.dataend);
  return image;
}

double meanDifference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total());
}

cv::Mat converted(const cv::Mat& gray, int code) {
  cv::Mat result;
  cv::cvtColor(gray, result, code);
  return result;
}

TEST(ImageConversion, GreyPixelsAreCopiedWithStampAndFrame) {
  auto mono = message(grayPicture(), "mono8");
  const auto image = fromMsg(mono);
  EXPECT_EQ(slam::nanoseconds(image.stamp), 12'000'000'345);
  EXPECT_EQ(image.frame, "camera");
  EXPECT_EQ(image.fault, "");
  mono.data.assign(mono.data.size(), 0);
  EXPECT_EQ(cv::norm(image.gray, grayPicture(), cv::NORM_INF), 0.0);
}

TEST(ImageConversion, RowsMayBePadded) {
  cv::Mat padded;
  cv::copyMakeBorder(grayPicture(), padded, 0, 0, 0, 16, cv::BORDER_CONSTANT, cv::Scalar(255));
  auto image = message(padded, "mono8");
  image.step = kWidth + 16;
  EXPECT_EQ(cv::norm(fromMsg(image).gray, grayPicture(), cv::NORM_INF), 0.0);
}

TEST(ImageConversion, EachColourEncodingGivesTheSameGrey) {
  const auto gray = grayPicture();
  for (const auto& [encoding, code] : {std::pair("bgr8", cv::COLOR_GRAY2BGR),
                                       {"rgb8", cv::COLOR_GRAY2RGB},
                                       {"bgra8", cv::COLOR_GRAY2BGRA},
                                       {"rgba8", cv::COLOR_GRAY2RGBA}}) {
    const auto image = fromMsg(message(converted(gray, code), encoding));
    EXPECT_EQ(image.fault, "") << encoding;
    EXPECT_LE(cv::norm(image.gray, gray, cv::NORM_INF), 1.0) << encoding;
  }
}

TEST(ImageConversion, RedAndBlueAreNotMistakenForEachOther) {
  const cv::Mat red(kHeight, kWidth, CV_8UC3, cv::Scalar(0, 0, 255));  // as bgr
  EXPECT_EQ(fromMsg(message(red, "bgr8")).gray.at<std::uint8_t>(0, 0), 76);
  EXPECT_EQ(fromMsg(message(red, "rgb8")).gray.at<std::uint8_t>(0, 0), 29);
}

TEST(ImageConversion, EachBayerPatternFindsItsColours) {
  // of a red surface only the red cells see light
  const std::map<std::string, cv::Point> red_cell = {{"bayer_rggb8", {0, 0}},
                                                     {"bayer_bggr8", {1, 1}},
                                                     {"bayer_gbrg8", {0, 1}},
                                                     {"bayer_grbg8", {1, 0}}};
  for (const auto& [encoding, cell] : red_cell) {
    cv::Mat mosaic = cv::Mat::zeros(kHeight, kWidth, CV_8UC1);
    for (int y = cell.y; y < kHeight; y += 2)
      for (int x = cell.x; x < kWidth; x += 2) mosaic.at<std::uint8_t>(y, x) = 255;
    const auto image = fromMsg(message(mosaic, encoding));
    ASSERT_EQ(image.fault, "") << encoding;
    EXPECT_NEAR(cv::mean(image.gray(cv::Rect(8, 8, 16, 16)))[0], 76, 1) << encoding;
  }
}

TEST(ImageConversion, SixteenBitsKeepTheirUpperHalfInEitherByteOrder) {
  cv::Mat wide;
  grayPicture().convertTo(wide, CV_16UC1, 256);
  auto little = message(wide, "mono16");
  EXPECT_EQ(cv::norm(fromMsg(little).gray, grayPicture(), cv::NORM_INF), 0.0);
  auto big = little;
  for (std::size_t i = 0; i < big.data.size(); i += 2) std::swap(big.data[i], big.data[i + 1]);
  big.is_bigendian = 1;
  EXPECT_EQ(cv::norm(fromMsg(big).gray, grayPicture(), cv::NORM_INF), 0.0);
}

TEST(ImageConversion, ValuesOfUnknownMeaningAreRefusedWithAWord) {
  const auto depth = fromMsg(message(cv::Mat::zeros(kHeight, kWidth, CV_16UC1), "16UC1"));
  EXPECT_TRUE(depth.gray.empty());
  EXPECT_NE(depth.fault.find("the encoding '16UC1' cannot be used"), std::string::npos);
  EXPECT_EQ(depth.frame, "camera");
}

TEST(ImageConversion, DataThatDoNotFitTheSizeAreRefusedWithAWord) {
  auto image = message(grayPicture(), "mono8");
  image.data.pop_back();
  EXPECT_NE(fromMsg(image).fault.find("64 x 48 pixels, mono8, cannot have 3071 bytes"),
            std::string::npos)
      << fromMsg(image).fault;
  image = message(grayPicture(), "bgr8");
  EXPECT_TRUE(fromMsg(image).gray.empty());
  EXPECT_NE(fromMsg(sensor_msgs::Image()).fault, "");
}

sensor_msgs::CompressedImage compressed(const cv::Mat& pixels, const std::string& extension) {
  sensor_msgs::CompressedImage image;
  image.format = extension.substr(1);
  cv::imencode(extension, pixels, image.data);
  return image;
}

TEST(ImageConversion, CompressedImagesAreDecodedToGrey) {
  EXPECT_LT(meanDifference(fromMsg(compressed(grayPicture(), ".jpg")).gray, grayPicture()), 1.0);
  EXPECT_EQ(meanDifference(fromMsg(compressed(grayPicture(), ".png")).gray, grayPicture()), 0.0);
  const auto colour = converted(grayPicture(), cv::COLOR_GRAY2BGR);
  EXPECT_LT(meanDifference(fromMsg(compressed(colour, ".jpg")).gray, grayPicture()), 1.0);
}

TEST(ImageConversion, CompressedDataThatAreDamagedAreRefusedWithAWord) {
  for (const auto* extension : {".jpg", ".png"}) {
    auto cut = compressed(grayPicture(), extension);
    cut.data.resize(cut.data.size() / 2);
    EXPECT_TRUE(fromMsg(cut).gray.empty()) << extension;
    EXPECT_NE(fromMsg(cut).fault.find("is cut off"), std::string::npos) << extension;
  }
  sensor_msgs::CompressedImage noise;
  noise.format = "jpeg";
  EXPECT_NE(fromMsg(noise).fault.find("0 bytes of the format 'jpeg'"), std::string::npos);
  noise.data.assign(1000, 7);
  EXPECT_NE(fromMsg(noise).fault.find("no image that can be decoded"), std::string::npos);
}

sensor_msgs::CameraInfo cameraInfo() {
  sensor_msgs::CameraInfo info;
  info.width = 640;
  info.height = 480;
  info.distortion_model = "plumb_bob";
  info.D = {0.1, -0.2, 0.001, 0.002, 0.0};
  info.K = {500, 0, 319.5, 0, 510, 239.5, 0, 0, 1};
  return info;
}

TEST(CameraInfoConversion, TakesTheIntrinsicsOfTheRawImage) {
  const auto calibration = fromMsg(cameraInfo());
  EXPECT_EQ(calibration.width, 640);
  EXPECT_EQ(calibration.height, 480);
  EXPECT_EQ(calibration.fx, 500);
  EXPECT_EQ(calibration.fy, 510);
  EXPECT_EQ(calibration.cx, 319.5);
  EXPECT_EQ(calibration.cy, 239.5);
  EXPECT_EQ(calibration.distortion, cameraInfo().D);
  EXPECT_EQ(calibration.distortion_model, "plumb_bob");
}

TEST(CameraInfoConversion, BinnedImagesKeepTheMiddleInTheMiddle) {
  auto info = cameraInfo();
  info.binning_x = info.binning_y = 2;
  const auto calibration = fromMsg(info);
  EXPECT_EQ(calibration.width, 320);
  EXPECT_EQ(calibration.height, 240);
  EXPECT_EQ(calibration.fx, 250);
  EXPECT_EQ(calibration.cx, 159.5);
  EXPECT_EQ(calibration.cy, 119.5);
  EXPECT_FALSE(calibration.is_region);
}

TEST(CameraInfoConversion, ARegionOfInterestMovesThePrincipalPoint) {
  auto info = cameraInfo();
  info.roi.x_offset = 100;
  info.roi.y_offset = 50;
  info.roi.width = 200;
  info.roi.height = 300;
  const auto calibration = fromMsg(info);
  EXPECT_EQ(calibration.width, 200);
  EXPECT_EQ(calibration.height, 300);
  EXPECT_EQ(calibration.cx, 219.5);
  EXPECT_EQ(calibration.cy, 189.5);
  EXPECT_TRUE(calibration.is_region);
}

TEST(ObservationConversion, ThereAndBackIsTheSame) {
  slam::LandmarkObservationArray array;
  array.sequence = 7;
  array.stamp = slam::stampFromNanoseconds(1234567890123456789);
  array.sensor_frame = "camera";
  array.sensor_pose = slam::Pose2(0.1, 0.2, 0.3);
  slam::LandmarkObservation seen{5, 2.5, -0.25, Eigen::Matrix2d::Identity()};
  seen.covariance(0, 1) = seen.covariance(1, 0) = 0.125;
  array.observations = {seen};
  const auto back = fromMsg(toMsg(array));
  EXPECT_EQ(back.sequence, 7u);
  EXPECT_EQ(back.stamp, array.stamp);
  EXPECT_EQ(back.sensor_frame, "camera");
  EXPECT_EQ(back.sensor_pose.theta(), 0.3);
  ASSERT_EQ(back.observations.size(), 1u);
  EXPECT_EQ(back.observations[0].id, 5);
  EXPECT_EQ(back.observations[0].bearing, -0.25);
  EXPECT_EQ(back.observations[0].covariance, seen.covariance);
}

TEST(ObservationConversion, ADrawingBecomesABgrImage) {
  std_msgs::Header header;
  header.frame_id = "camera";
  const auto image = toMsg(cv::Mat(4, 3, CV_8UC3, cv::Scalar(1, 2, 3)), header);
  EXPECT_EQ(image.encoding, "bgr8");
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 4u);
  ASSERT_EQ(image.data.size(), 36u);
  EXPECT_EQ(image.data[35], 3);
}

}  // namespace
}  // namespace slam_ros
