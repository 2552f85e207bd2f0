// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/corner_detector.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tagStandard41h12.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <opencv2/core/utility.hpp>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/fiducial/april_tag_detector.hpp"
#include "slam_core/fiducial/aruco_detector.hpp"
#include "slam_core/fiducial/rejection.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"

namespace slam::fiducial {
namespace {

using slam::test::faultsOf;
using slam::test::oneSays;
using test::facing;
using test::MarkerPicture;
using test::printedMarker;

const CameraModel kCamera(test::vgaCalibration());

AprilTagConfig aprilTags(std::vector<std::string> families) {
  AprilTagConfig config;
  config.families = std::move(families);
  return config;
}

ArucoConfig arucoMarkers(std::vector<std::string> dictionaries) {
  ArucoConfig config;
  config.dictionaries = std::move(dictionaries);
  return config;
}

template <class Detector, class Config>
std::vector<MarkerDetection> detect(const cv::Mat& image, const Config& config) {
  Detector detector;
  detector.configure(config);
  std::vector<MarkerDetection> found;
  detector.detect(image, found);
  sortById(found);
  return found;
}

std::vector<MarkerDetection> acceptedOf(std::vector<MarkerDetection> found) {
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](const auto& marker) { return !marker.isAccepted(); }),
              found.end());
  return found;
}

/// The largest distance of a corner from where it really is [px].
double worstError(const MarkerDetection& marker, const Eigen::Isometry3d& T, double size) {
  double worst = 0.0;
  const auto square = cornersOfSquare(size);
  for (std::size_t i = 0; i < 4; ++i)
    worst = std::max(worst, (marker.corners[i] - *kCamera.project(T * square[i])).norm());
  return worst;
}

TEST(CornerDetectors, FindTheTrueCornersInTheSameOrder) {
  // Where pixel centres lie, and where a marker's corners begin, is each library's own convention.
  for (const double turn : {0.0, 0.4, 1.7, 3.0}) {
    auto T = facing({0.11, -0.07, 1.1}, 0.4, 0.9);
    T.linear() = T.linear() * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
    MarkerPicture picture(kCamera);
    picture.add(printedMarker(17), T);
    const auto image = picture.exposed(2.0);
    const auto tags = detect<AprilTagDetector>(image, AprilTagConfig());
    const auto markers = detect<ArucoDetector>(image, ArucoConfig());
    for (const auto* found : {&tags, &markers}) {
      ASSERT_EQ(found->size(), 1u) << turn;
      EXPECT_EQ((*found)[0].id, 17);
      EXPECT_TRUE((*found)[0].isAccepted());
      EXPECT_LT(worstError((*found)[0], T, 0.16), 0.3) << turn;
    }
  }
}

struct Kind {
  std::string name;
  int dictionary;
};

class EveryArucoDictionary : public testing::TestWithParam<Kind> {};

TEST_P(EveryArucoDictionary, IsReadUprightAndOnce) {
  const auto T = facing({0.05, 0.04, 0.8}, 0.3);
  MarkerPicture picture(kCamera);
  picture.add(printedMarker(3, 0.16, GetParam().dictionary), T);
  const auto found = detect<ArucoDetector>(picture.exposed(2.0), arucoMarkers({GetParam().name}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, 3);
  EXPECT_LT(worstError(found[0], T, 0.16), 0.3);
}

INSTANTIATE_TEST_SUITE_P(
    Dictionaries, EveryArucoDictionary,
    testing::Values(Kind{"DICT_4X4_50", cv::aruco::DICT_4X4_50},
                    Kind{"DICT_5X5_100", cv::aruco::DICT_5X5_100},
                    Kind{"DICT_6X6_250", cv::aruco::DICT_6X6_250},
                    Kind{"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
                    Kind{"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
                    Kind{"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
                    Kind{"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
                    Kind{"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11}),
    [](const auto& kind) { return kind.param.name; });

test::PrintedMarker printedStandard41h12(int id, double size) {
  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family(
      tagStandard41h12_create(), tagStandard41h12_destroy);
  // image_u8_destroy is not in every build of the library
  const auto destroy = [](image_u8_t* image) {
    std::free(image->buf);
    std::free(image);
  };
  const std::unique_ptr<image_u8_t, decltype(destroy)> image(apriltag_to_image(family.get(), id),
                                                             destroy);
  test::PrintedMarker marker;
  marker.size = size;
  marker.quiet_cells = (family->total_width - family->width_at_border) / 2;
  marker.cells = cv::Mat(image->height, image->width, CV_8UC1, image->buf,
                         static_cast<std::size_t>(image->stride))
                     .clone();
  return marker;
}

TEST(AprilTagDetector, ReadsSeveralFamiliesAtOnce) {
  const auto left = facing({-0.25, 0.02, 1.0}, 0.2), middle = facing({0.0, 0.1, 1.1}, 0.3),
             right = facing({0.28, -0.05, 0.9}, 0.4), low = facing({0.0, -0.25, 1.0}, 0.1);
  MarkerPicture picture(kCamera);
  picture.add(printedMarker(5, 0.16, cv::aruco::DICT_APRILTAG_36h11), left);
  picture.add(printedMarker(6, 0.16, cv::aruco::DICT_APRILTAG_25h9), middle);
  picture.add(printedMarker(7, 0.16, cv::aruco::DICT_APRILTAG_16h5), low);
  picture.add(printedStandard41h12(8, 0.10), right);
  auto config = aprilTags({"36h11", "25h9", "16h5", "Standard41h12"});
  config.id_offsets = {{"25h9", 1000}, {"16h5", 2000}, {"Standard41h12", 3000}};
  const auto found = acceptedOf(detect<AprilTagDetector>(picture.exposed(2.0), config));
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].id, 5);
  EXPECT_LT(worstError(found[0], left, 0.16), 0.3);
  EXPECT_EQ(found[1].id, 1006);
  EXPECT_LT(worstError(found[1], middle, 0.16), 0.3);
  EXPECT_EQ(found[2].id, 2007);
  EXPECT_LT(worstError(found[2], low, 0.16), 0.3);
  EXPECT_EQ(found[3].id, 3008);
  EXPECT_LT(worstError(found[3], right, 0.10), 0.3);
}

void expectSame(const std::vector<MarkerDetection>& a, const std::vector<MarkerDetection>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].margin, b[i].margin);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(a[i].corners[k], b[i].corners[k]);
  }
}

TEST(CornerDetectors, GiveTheSameForAnyNumberOfThreads) {
  MarkerPicture picture(kCamera);
  for (int i = 0; i < 12; ++i)
    picture.add(printedMarker(i),
                facing({-0.6 + 0.4 * (i % 4), -0.4 + 0.4 * (i / 4), 1.6}, 0.3, i));
  const auto image = picture.exposed(3.0);
  AprilTagConfig config;
  const auto tags = detect<AprilTagDetector>(image, config);
  EXPECT_EQ(tags.size(), 12u);
  for (const int threads : {2, 4}) {
    config.threads = threads;
    expectSame(detect<AprilTagDetector>(image, config), tags);
  }
  const auto markers = detect<ArucoDetector>(image, ArucoConfig());  // as many as there are cores
  EXPECT_EQ(markers.size(), 12u);
  const int threads_before = cv::getNumThreads();
  cv::setNumThreads(1);
  expectSame(detect<ArucoDetector>(image, ArucoConfig()), markers);
  cv::setNumThreads(threads_before);
}

TEST(AprilTagDetector, LeavesTheImageAsItIs) {
  MarkerPicture picture(kCamera);
  picture.add(printedMarker(1), facing({0, 0, 1.0}, 0.2));
  const auto image = picture.exposed(2.0);
  const cv::Mat before = image.clone();
  for (const double decimate : {1.0, 2.0}) {
    for (const double sigma : {0.0, 0.8, -0.8}) {
      AprilTagConfig config;
      config.quad_decimate = decimate;
      config.quad_sigma = sigma;
      EXPECT_EQ(detect<AprilTagDetector>(image, config).size(), 1u) << decimate << " " << sigma;
      EXPECT_EQ(cv::countNonZero(image != before), 0) << "blurred in place";
    }
  }
}

TEST(AprilTagDetector, RejectsWhatItReadWithDoubt) {
  auto printed = printedMarker(9);
  printed.cells.at<std::uint8_t>(5, 5) ^= 255;  // two bits wrong
  printed.cells.at<std::uint8_t>(4, 6) ^= 255;
  MarkerPicture picture(kCamera);
  picture.add(printed, facing({0, 0, 1.0}, 0.2));
  AprilTagConfig config;
  auto found = detect<AprilTagDetector>(picture.exposed(2.0), config);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].hamming, 2);
  EXPECT_EQ(found[0].rejection, "hamming");
  config.max_hamming = 2;
  EXPECT_TRUE(detect<AprilTagDetector>(picture.exposed(2.0), config)[0].isAccepted());
  config.min_margin = 250;
  EXPECT_EQ(detect<AprilTagDetector>(picture.exposed(2.0), config)[0].rejection, "low_margin");
}

TEST(CornerDetectors, FindNothingInImagesWithoutMarkers) {
  for (const auto& size :
       {cv::Size(1, 1), cv::Size(3, 200), cv::Size(17, 16), cv::Size(640, 480)}) {
    const cv::Mat dark = cv::Mat::zeros(size, CV_8UC1);
    for (const double decimate : {1.0, 2.0, 3.0}) {
      AprilTagConfig config;
      config.quad_decimate = decimate;
      EXPECT_TRUE(detect<AprilTagDetector>(dark, config).empty()) << size;
    }
    EXPECT_TRUE(detect<ArucoDetector>(dark, ArucoConfig()).empty()) << size;
  }
}

TEST(CornerDetectors, RefuseFamiliesThatAreNotKnownWithTheNearestName) {
  EXPECT_TRUE(oneSays(faultsOf([] { AprilTagDetector().configure(aprilTags({"36h12"})); }),
                      {"apriltag.families", "'36h12'", "did you mean '36h11'"}));
  EXPECT_TRUE(oneSays(faultsOf([] { ArucoDetector().configure(arucoMarkers({"DICT_4x4_50"})); }),
                      {"aruco.dictionaries", "did you mean 'DICT_4X4_50'"}));
}

TEST(CornerDetectors, RefuseIdsThatAreNotUnique) {
  auto config = aprilTags({"36h11", "25h9"});
  EXPECT_TRUE(
      oneSays(faultsOf([&] { AprilTagDetector().configure(config); }),
              {"apriltag.id_offsets", "36h11 (0 .. 586)", "25h9 (0 .. 34)", "overlap", "587"}));
  config.id_offsets = {{"25h9", 587}};
  EXPECT_TRUE(faultsOf([&] { AprilTagDetector().configure(config); }).empty());
  config.id_offsets = {{"25h9", 586}};
  EXPECT_FALSE(faultsOf([&] { AprilTagDetector().configure(config); }).empty());
  config.id_offsets = {{"25h9", 600}, {"16h5", 900}};
  EXPECT_TRUE(
      oneSays(faultsOf([&] { AprilTagDetector().configure(config); }), {"16h5 is not in use"}));
  EXPECT_TRUE(oneSays(faultsOf([] {
                        AprilTagDetector().configure(aprilTags({"36h11", "36h11"}));
                      }),
                      {"36h11 is listed twice"}));
  EXPECT_TRUE(oneSays(faultsOf([] {
                        ArucoDetector().configure(arucoMarkers({"DICT_4X4_50", "DICT_5X5_100"}));
                      }),
                      {"aruco.id_offsets", "DICT_4X4_50 (0 .. 49)", "overlap"}));
}

TEST(CornerDetectors, RefuseDictionariesThatHoldTheSameMarkers) {
  auto config = arucoMarkers({"DICT_5X5_50", "DICT_5X5_100"});
  config.id_offsets = {{"DICT_5X5_100", 50}};
  EXPECT_TRUE(oneSays(faultsOf([&] { ArucoDetector().configure(config); }),
                      {"aruco.dictionaries", "DICT_5X5_50", "DICT_5X5_100", "the same markers"}));
  config = arucoMarkers({"DICT_APRILTAG_36h10", "DICT_APRILTAG_36h11", "DICT_6X6_50"});
  config.id_offsets = {{"DICT_APRILTAG_36h11", 3000}, {"DICT_6X6_50", 4000}};
  EXPECT_TRUE(faultsOf([&] { ArucoDetector().configure(config); }).empty());
}

TEST(CornerDetectors, RefuseAnEmptyListOfFamilies) {
  EXPECT_TRUE(oneSays(faultsOf([] { AprilTagDetector().configure(aprilTags({})); }),
                      {"apriltag.families", "empty"}));
  EXPECT_TRUE(oneSays(faultsOf([] { ArucoDetector().configure(arucoMarkers({})); }),
                      {"aruco.dictionaries", "empty"}));
}

}  // namespace
}  // namespace slam::fiducial
