// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/marker_texture.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>

#include <functional>
#include <map>
#include <memory>
#include <opencv2/aruco/dictionary.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "slam_sim/marker_family.hpp"

namespace slam::sim {
namespace {

/// OpenCV takes a marker's outline and that of its paper for one where they are nearer than a
/// twentieth of the marker's perimeter, and drops the marker.
constexpr int kMargin = 2;  // [cells]

using AprilTagFamily = std::unique_ptr<apriltag_family_t, std::function<void(apriltag_family_t*)>>;

AprilTagFamily aprilTagFamily(const std::string& name) {
  if (name == "36h11") return {tag36h11_create(), tag36h11_destroy};
  if (name == "25h9") return {tag25h9_create(), tag25h9_destroy};
  if (name == "16h5") return {tag16h5_create(), tag16h5_destroy};
  if (name == "Standard41h12") return {tagStandard41h12_create(), tagStandard41h12_destroy};
  return nullptr;
}

cv::Mat withMargin(const cv::Mat& cells, int n) {
  cv::Mat margin;
  cv::copyMakeBorder(cells, margin, n, n, n, n, cv::BORDER_CONSTANT, cv::Scalar(255));
  return margin;
}

MarkerPattern aprilTagPattern(apriltag_family_t& family, std::int64_t id) {
  const std::unique_ptr<image_u8_t, decltype(&image_u8_destroy)> image(
      apriltag_to_image(&family, static_cast<int>(id)), image_u8_destroy);
  const cv::Mat cells(image->height, image->width, CV_8UC1, image->buf,
                      static_cast<std::size_t>(image->stride));
  // Families with the border inside have data where the others have a margin of one cell.
  const int first = (family.total_width - family.width_at_border) / 2;
  const int margin = family.reversed_border ? kMargin : kMargin - 1;
  return {withMargin(cells, margin), first + margin, family.width_at_border};
}

MarkerPattern arucoPattern(const std::string& name, std::int64_t id) {
  // The enumerators of OpenCV by name, in its order.
  static const std::map<std::string, int> kDictionaries = {
#define SLAM_SIM_DICTIONARY(name) {#name, cv::aruco::name}
      SLAM_SIM_DICTIONARY(DICT_4X4_50),         SLAM_SIM_DICTIONARY(DICT_4X4_100),
      SLAM_SIM_DICTIONARY(DICT_4X4_250),        SLAM_SIM_DICTIONARY(DICT_4X4_1000),
      SLAM_SIM_DICTIONARY(DICT_5X5_50),         SLAM_SIM_DICTIONARY(DICT_5X5_100),
      SLAM_SIM_DICTIONARY(DICT_5X5_250),        SLAM_SIM_DICTIONARY(DICT_5X5_1000),
      SLAM_SIM_DICTIONARY(DICT_6X6_50),         SLAM_SIM_DICTIONARY(DICT_6X6_100),
      SLAM_SIM_DICTIONARY(DICT_6X6_250),        SLAM_SIM_DICTIONARY(DICT_6X6_1000),
      SLAM_SIM_DICTIONARY(DICT_7X7_50),         SLAM_SIM_DICTIONARY(DICT_7X7_100),
      SLAM_SIM_DICTIONARY(DICT_7X7_250),        SLAM_SIM_DICTIONARY(DICT_7X7_1000),
      SLAM_SIM_DICTIONARY(DICT_ARUCO_ORIGINAL), SLAM_SIM_DICTIONARY(DICT_APRILTAG_16h5),
      SLAM_SIM_DICTIONARY(DICT_APRILTAG_25h9),  SLAM_SIM_DICTIONARY(DICT_APRILTAG_36h10),
      SLAM_SIM_DICTIONARY(DICT_APRILTAG_36h11)
#undef SLAM_SIM_DICTIONARY
  };
  const auto dictionary = cv::aruco::getPredefinedDictionary(kDictionaries.at(name));
  const int border_cells = dictionary->markerSize + 2;
  cv::Mat cells;
  dictionary->drawMarker(static_cast<int>(id), border_cells, cells, 1);
  return {withMargin(cells, kMargin), kMargin, border_cells};
}

}  // namespace

MarkerPattern markerPattern(const std::string& family, std::int64_t id) {
  const MarkerFamily* known = findMarkerFamily(family);
  if (known == nullptr) throw std::invalid_argument("no marker family is called '" + family + "'");
  if (id < 0 || id >= known->ids) {
    throw std::invalid_argument("family '" + family + "' has no marker " + std::to_string(id) +
                                "; its ids are 0 to " + std::to_string(known->ids - 1));
  }
  if (const auto april_tag = aprilTagFamily(family)) return aprilTagPattern(*april_tag, id);
  return arucoPattern(family, id);
}

}  // namespace slam::sim
