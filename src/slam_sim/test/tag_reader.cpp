// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tag_reader.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>

#include <map>
#include <opencv2/aruco.hpp>

namespace slam::sim {
namespace {

struct AprilTagMaker {
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

const std::map<std::string, AprilTagMaker> kAprilTags = {
    {"36h11", {tag36h11_create, tag36h11_destroy}},
    {"25h9", {tag25h9_create, tag25h9_destroy}},
    {"16h5", {tag16h5_create, tag16h5_destroy}},
    {"Standard41h12", {tagStandard41h12_create, tagStandard41h12_destroy}}};

const std::map<std::string, int> kDictionaries = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11}};

std::vector<ReadMarker> readAprilTags(const cv::Mat& gray, const AprilTagMaker& maker) {
  apriltag_family_t* family = maker.create();
  apriltag_detector_t* detector = apriltag_detector_create();
  detector->quad_decimate = 1.0F;
  apriltag_detector_add_family_bits(detector, family, 1);
  image_u8_t image{gray.cols, gray.rows, static_cast<int32_t>(gray.step), gray.data};
  zarray_t* found = apriltag_detector_detect(detector, &image);
  std::vector<ReadMarker> markers;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found, i, &detection);
    ReadMarker marker{detection->id, {}};
    // The library begins at the lower left and goes counterclockwise as one looks at the image.
    for (std::size_t k = 0; k < 4; ++k) {
      marker.corners[k] = {detection->p[3 - k][0], detection->p[3 - k][1]};
    }
    markers.push_back(marker);
  }
  apriltag_detections_destroy(found);
  apriltag_detector_destroy(detector);
  maker.destroy(family);
  return markers;
}

std::vector<ReadMarker> readAruco(const cv::Mat& gray, int dictionary) {
  auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(gray, cv::aruco::getPredefinedDictionary(dictionary), corners, ids,
                           parameters);
  std::vector<ReadMarker> markers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ReadMarker marker{ids[i], {}};
    for (std::size_t k = 0; k < 4; ++k) {
      marker.corners[k] = {static_cast<double>(corners[i][k].x),
                           static_cast<double>(corners[i][k].y)};
    }
    markers.push_back(marker);
  }
  return markers;
}

}  // namespace

std::vector<ReadMarker> readMarkers(const cv::Mat& gray, const std::string& family) {
  const auto april_tag = kAprilTags.find(family);
  return april_tag == kAprilTags.end() ? readAruco(gray, kDictionaries.at(family))
                                       : readAprilTags(gray, april_tag->second);
}

}  // namespace slam::sim
