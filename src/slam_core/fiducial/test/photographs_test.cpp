// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "slam_core/fiducial/april_tag_detector.hpp"
#include "slam_core/fiducial/aruco_detector.hpp"

// Three photographs of a robot competition with expected tags: test data of the AprilTag library.
// They lie in the folder `tags` of $SLAM_DATA_DIR, else of shared/data beside the repository.

namespace slam::fiducial {
namespace {

struct ExpectedTag {
  LandmarkId id;
  Corners corners;
};

std::filesystem::path folder() {
  const char* data = std::getenv("SLAM_DATA_DIR");
  const auto repository = std::filesystem::path(__FILE__).parent_path() / "../../../..";
  return (data != nullptr ? std::filesystem::path(data) : repository / "../shared/data") / "tags";
}

/// Lines "ID, (X Y), (X Y), (X Y), (X Y)" in the library's convention: pixel centres at 0.5, from
/// the lower left corner on.
std::vector<ExpectedTag> expectedTags(const std::filesystem::path& file) {
  std::vector<ExpectedTag> tags;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    for (char& c : line)
      if (c == ',' || c == '(' || c == ')') c = ' ';
    std::istringstream words(line);
    ExpectedTag tag;
    words >> tag.id;
    for (std::size_t i = 4; i-- > 0;) {
      words >> tag.corners[i].x() >> tag.corners[i].y();
      tag.corners[i].array() -= 0.5;
    }
    if (words) tags.push_back(tag);
  }
  return tags;
}

double worstDistance(const Corners& a, const Corners& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

/// How many of the expected tags are found, all corners within `tolerance` [px].
std::size_t countFound(const std::vector<ExpectedTag>& expected,
                       const std::vector<MarkerDetection>& found, double tolerance) {
  std::size_t count = 0;
  for (const auto& tag : expected)
    for (const auto& marker : found)
      if (marker.id == tag.id && worstDistance(marker.corners, tag.corners) < tolerance) {
        ++count;
        break;
      }
  return count;
}

class Photograph : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto name = folder() / GetParam();
    if (!std::filesystem::exists(name.string() + ".jpg"))
      GTEST_SKIP() << "no photographs in " << folder() << "; $SLAM_DATA_DIR names another folder";
    image_ = cv::imread(name.string() + ".jpg", cv::IMREAD_GRAYSCALE);
    expected_ = expectedTags(name.string() + ".txt");
    ASSERT_FALSE(image_.empty());
    ASSERT_GE(expected_.size(), 10u);
  }

  cv::Mat image_;
  std::vector<ExpectedTag> expected_;
};

TEST_P(Photograph, HasTheExpectedTagsWithinAPixel) {
  AprilTagDetector detector;
  detector.configure(AprilTagConfig());
  std::vector<MarkerDetection> found;
  detector.detect(image_, found);
  EXPECT_EQ(found.size(), expected_.size());
  EXPECT_EQ(countFound(expected_, found, 1.0), expected_.size());
}

TEST_P(Photograph, HasTheExpectedTagsExactlyAsTheyWereMade) {
  AprilTagConfig config;
  config.corner_refinement = AprilTagConfig::Refinement::kNone;
  AprilTagDetector detector;
  detector.configure(config);
  std::vector<MarkerDetection> found;
  detector.detect(image_, found);
  EXPECT_EQ(countFound(expected_, found, 0.2), expected_.size());
}

TEST_P(Photograph, HasTagsForArucoAtTheSamePlaces) {
  ArucoDetector aruco;
  aruco.configure(ArucoConfig());
  std::vector<MarkerDetection> found;
  aruco.detect(image_, found);
  // it finds fewer of the small ones, and one or two at the rim that the expectation lacks
  EXPECT_GE(found.size(), 5u);
  EXPECT_GE(countFound(expected_, found, 1.0) + 2, found.size());
}

INSTANTIATE_TEST_SUITE_P(Tags, Photograph,
                         testing::Values("33369213973_9d9bb4cc96_c", "34085369442_304b6bafd9_c",
                                         "34139872896_defdb2f8d9_c"),
                         [](const auto& name) {
                           return "Photograph" + std::string(name.param).substr(0, 11);
                         });

}  // namespace
}  // namespace slam::fiducial
