// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/image_conversions.hpp"

#include <fmt/format.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "slam_ros/conversions.hpp"
#include "slam_ros/image_decoder.hpp"

namespace slam_ros {
namespace {

constexpr int kNoConversion = -1;
constexpr double kQuaternionTolerance = 1e-2;  // of the squared norm

/// How an encoding becomes grey.
struct Encoding {
  int type;        ///< OpenCV's, of the message's pixels
  int conversion;  ///< OpenCV's code
};

/// cv_bridge (1.16) would be no substitute: it refuses 8UC1, 8UC3, 8UC4, yuv422_yuy2 and colour of
/// 16 bits in big-endian order, and makes two channels of mono16 in that order. Images of 8 bits
/// become the same bytes in the same time, those of 16 bits sooner (VGA grey 0.04 ms, here 0.11
/// ms), but colour and Bayer patterns of 16 bits other bytes.
///
/// OpenCV names a Bayer pattern after the second row's second and third pixel.
const std::map<std::string, Encoding>& encodings() {
  namespace enc = sensor_msgs::image_encodings;
  static const std::map<std::string, Encoding> kEncodings = {
      {enc::MONO8, {CV_8UC1, kNoConversion}},
      {enc::TYPE_8UC1, {CV_8UC1, kNoConversion}},
      {enc::MONO16, {CV_16UC1, kNoConversion}},
      {enc::BGR8, {CV_8UC3, cv::COLOR_BGR2GRAY}},
      {enc::TYPE_8UC3, {CV_8UC3, cv::COLOR_BGR2GRAY}},
      {enc::RGB8, {CV_8UC3, cv::COLOR_RGB2GRAY}},
      {enc::BGRA8, {CV_8UC4, cv::COLOR_BGRA2GRAY}},
      {enc::TYPE_8UC4, {CV_8UC4, cv::COLOR_BGRA2GRAY}},
      {enc::RGBA8, {CV_8UC4, cv::COLOR_RGBA2GRAY}},
      {enc::BGR16, {CV_16UC3, cv::COLOR_BGR2GRAY}},
      {enc::RGB16, {CV_16UC3, cv::COLOR_RGB2GRAY}},
      {enc::BAYER_RGGB8, {CV_8UC1, cv::COLOR_BayerBG2GRAY}},
      {enc::BAYER_BGGR8, {CV_8UC1, cv::COLOR_BayerRG2GRAY}},
      {enc::BAYER_GBRG8, {CV_8UC1, cv::COLOR_BayerGR2GRAY}},
      {enc::BAYER_GRBG8, {CV_8UC1, cv::COLOR_BayerGB2GRAY}},
      {enc::BAYER_RGGB16, {CV_16UC1, cv::COLOR_BayerBG2GRAY}},
      {enc::BAYER_BGGR16, {CV_16UC1, cv::COLOR_BayerRG2GRAY}},
      {enc::BAYER_GBRG16, {CV_16UC1, cv::COLOR_BayerGR2GRAY}},
      {enc::BAYER_GRBG16, {CV_16UC1, cv::COLOR_BayerGB2GRAY}},
      {enc::YUV422, {CV_8UC2, cv::COLOR_YUV2GRAY_UYVY}},
      {"yuv422_yuy2", {CV_8UC2, cv::COLOR_YUV2GRAY_YUY2}}};
  return kEncodings;
}

std::string faultOf(const sensor_msgs::Image& message) {
  const auto encoding = encodings().find(message.encoding);
  if (encoding == encodings().end())
    return fmt::format(
        "an image of the encoding '{}' cannot be used; mono8, bgr8, rgb8, bayer_* and the like can",
        message.encoding);
  const std::size_t row = message.width * std::size_t{CV_ELEM_SIZE(encoding->second.type)};
  const bool fits = message.width > 0 && message.height > 0 && message.step >= row &&
                    message.data.size() >= message.height * std::size_t{message.step};
  if (fits) return "";
  return fmt::format("an image of {} x {} pixels, {}, cannot have {} bytes in rows of {}",
                     message.width, message.height, message.encoding, message.data.size(),
                     message.step);
}

/// The upper 8 of 16 bits, whatever their order in the message.
cv::Mat upperBytes(const cv::Mat& pixels, bool big_endian) {
  const int channels = pixels.channels();
  cv::Mat upper(pixels.rows, pixels.cols, CV_8UC(channels));
  const int offset = big_endian ? 0 : 1;
  for (int row = 0; row < pixels.rows; ++row) {
    const auto* from = pixels.ptr<std::uint8_t>(row) + offset;
    auto* to = upper.ptr<std::uint8_t>(row);
    for (int i = 0; i < pixels.cols * channels; ++i) to[i] = from[2 * i];
  }
  return upper;
}

/// @pre faultOf(message) is empty
cv::Mat grayOf(const sensor_msgs::Image& message) {
  const auto& [type, conversion] = encodings().at(message.encoding);
  // OpenCV has no view of constant data; nobody writes to this one
  cv::Mat pixels(static_cast<int>(message.height), static_cast<int>(message.width), type,
                 const_cast<std::uint8_t*>(message.data.data()), message.step);
  if (CV_MAT_DEPTH(type) == CV_16U) pixels = upperBytes(pixels, message.is_bigendian != 0);
  cv::Mat gray;
  if (conversion == kNoConversion)
    pixels.copyTo(gray);
  else
    cv::cvtColor(pixels, gray, conversion);
  return gray;
}

/// libjpeg and libpng fill what is missing with grey and only tell the console.
bool isCutOff(const std::vector<std::uint8_t>& data) {
  const auto begins = [&](std::initializer_list<std::uint8_t> mark) {
    return data.size() >= mark.size() && std::equal(mark.begin(), mark.end(), data.begin());
  };
  const auto holds = [&](std::initializer_list<std::uint8_t> mark) {
    constexpr std::ptrdiff_t kTail = 4096;  // drivers pad their buffers
    const auto from = data.end() - std::min<std::ptrdiff_t>(kTail, data.end() - data.begin());
    return std::search(from, data.end(), mark.begin(), mark.end()) != data.end();
  };
  if (begins({0xFF, 0xD8})) return !holds({0xFF, 0xD9});
  if (begins({0x89, 'P', 'N', 'G'})) return !holds({'I', 'E', 'N', 'D'});
  return false;
}

template <class Message>
slam::Image withoutPixels(const Message& message) {
  slam::Image image;
  image.stamp = fromRos(message.header.stamp);
  image.frame = frameId(message.header.frame_id);
  return image;
}

}  // namespace

slam::Image fromMsg(const sensor_msgs::Image& message) {
  auto image = withoutPixels(message);
  image.fault = faultOf(message);
  if (image.fault.empty()) image.gray = grayOf(message);
  return image;
}

slam::Image fromMsg(const sensor_msgs::CompressedImage& message) try {
  auto image = withoutPixels(message);
  if (isCutOff(message.data))
    image.fault = fmt::format("a compressed image of {} bytes is cut off", message.data.size());
  else if (image.gray = decodedGray(message.data); image.gray.empty())
    image.fault = fmt::format("{} bytes of the format '{}' are no image that can be decoded",
                              message.data.size(), message.format);
  return image;
} catch (const std::runtime_error& error) {  // decodedGray() cannot load the codecs
  auto image = withoutPixels(message);
  image.fault = error.what();
  return image;
}

slam::CameraCalibration fromMsg(const sensor_msgs::CameraInfo& message) {
  const auto& roi = message.roi;
  const double bin_x = std::max(1u, message.binning_x), bin_y = std::max(1u, message.binning_y);
  const auto size = [](std::uint32_t whole, std::uint32_t region, double bin) {
    return static_cast<int>((region > 0 ? region : whole) / bin);
  };
  // the centre of the first pixel is at 0, hence the halves
  const auto centre = [](double at, std::uint32_t offset, double bin) {
    return (at - offset + 0.5) / bin - 0.5;
  };
  slam::CameraCalibration calibration;
  calibration.width = size(message.width, roi.width, bin_x);
  calibration.height = size(message.height, roi.height, bin_y);
  calibration.distortion_model = message.distortion_model;
  calibration.fx = message.K[0] / bin_x;
  calibration.fy = message.K[4] / bin_y;
  calibration.cx = centre(message.K[2], roi.x_offset, bin_x);
  calibration.cy = centre(message.K[5], roi.y_offset, bin_y);
  calibration.distortion = message.D;
  calibration.is_region = (roi.width > 0 && roi.width < message.width) ||
                          (roi.height > 0 && roi.height < message.height);
  return calibration;
}

Eigen::Isometry3d fromMsg(const geometry_msgs::Transform& transform) {
  const auto& [t, q] = std::tie(transform.translation, transform.rotation);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  // what is no rotation must not become one: normalized() makes a zero quaternion the identity
  if (std::abs(rotation.squaredNorm() - 1.0) < kQuaternionTolerance)
    pose.linear() = rotation.normalized().toRotationMatrix();
  else
    pose.linear().setZero();
  pose.translation() << t.x, t.y, t.z;
  return pose;
}

sensor_msgs::Image toMsg(const cv::Mat& colour, const std_msgs::Header& header) {
  sensor_msgs::Image message;
  message.header = header;
  message.width = static_cast<std::uint32_t>(colour.cols);
  message.height = static_cast<std::uint32_t>(colour.rows);
  message.encoding = sensor_msgs::image_encodings::BGR8;
  message.step = message.width * 3;
  message.data.resize(std::size_t{message.step} * message.height);
  for (int row = 0; row < colour.rows; ++row)
    std::memcpy(message.data.data() + std::size_t{message.step} * static_cast<std::size_t>(row),
                colour.ptr(row), message.step);
  return message;
}

}  // namespace slam_ros
