// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "carmen_clock.hpp"
#include "carmen_log.hpp"
#include "circles_log.hpp"
#include "mrclam_log.hpp"
#include "rawlog_log.hpp"
#include "rawlog_truth.hpp"

namespace slam::eval {
namespace {

namespace fs = std::filesystem;

std::string dataFolder() {
  const char* folder = std::getenv("SLAM_DATA_DIR");
  return folder != nullptr ? folder : SLAM_EVAL_DATA_DIR;
}

/// The first words of a file's rows, as they stand there.
std::vector<std::string> stampTexts(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> stamps;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') stamps.push_back(line.substr(0, line.find(' ')));
  }
  return stamps;
}

class MrclamSix : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    folder_ = (fs::path(dataFolder()) / "mrclam_dataset6").string();
    if (!fs::is_directory(folder_)) GTEST_SKIP() << "the real data set is absent: " << folder_;
  }

  std::string file(const std::string& kind) const {
    return folder_ + "/Robot" + std::to_string(GetParam()) + "_" + kind + ".dat";
  }

  std::string folder_;
};

TEST_P(MrclamSix, KeepsEveryStampAndEveryLandmarkReading) {
  const MrclamLog log = readMrclam(folder_, GetParam());
  const auto odometry = stampTexts(file("Odometry"));
  const auto measurements = stampTexts(file("Measurement"));
  EXPECT_EQ(log.odometry.size() + log.replaced_odometry, odometry.size());
  EXPECT_EQ(log.truth.size(), stampTexts(file("Groundtruth")).size());
  const std::set<std::string> stamps(measurements.begin(), measurements.end());
  EXPECT_EQ(log.sightings.size(), stamps.size());
  std::size_t readings = log.robot_readings + log.unknown_readings;
  for (const auto& sighting : log.sightings) readings += sighting.readings.size();
  EXPECT_EQ(readings, measurements.size());
  EXPECT_EQ(log.landmarks.size(), 15u);
}

TEST_P(MrclamSix, WritesStampsAsTheFileHasThem) {
  const MrclamLog log = readMrclam(folder_, GetParam());
  const auto texts = stampTexts(file("Groundtruth"));
  for (std::size_t i = 0; i < texts.size(); i += 997) {
    std::string digits = texts[i] + "000000";
    digits.erase(digits.find('.'), 1);
    EXPECT_EQ(std::to_string(log.truth[i].stamp), digits);
  }
}

TEST_P(MrclamSix, SeesLandmarksWhereTheTruthHasThem) {
  const MrclamLog log = readMrclam(folder_, GetParam());
  std::size_t near = 0, all = 0, pose = 0;
  for (const auto& sighting : log.sightings) {
    while (pose + 1 < log.truth.size() && log.truth[pose + 1].stamp <= sighting.stamp) ++pose;
    if (std::abs(log.truth[pose].stamp - sighting.stamp) > 100'000'000) continue;
    for (const auto& reading : sighting.readings) {
      const auto& landmark = log.landmarks.at(static_cast<std::size_t>(reading.landmark - 6));
      const double distance =
          std::hypot(landmark.x - log.truth[pose].x, landmark.y - log.truth[pose].y);
      near += std::abs(distance - reading.range) < 0.5 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(all, 1000u);
  EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(all));
}

INSTANTIATE_TEST_SUITE_P(Robots, MrclamSix, testing::Range(1, 6));

TEST(KfSlamDemo, HasOnePoseOfTheTruthForEachOfItsFrames) {
  const std::string base = "/usr/share/mrpt/datasets/kf-slam_demo";
  if (!fs::exists(base + ".rawlog")) GTEST_SKIP() << "mrpt-common is not installed";
  std::ostringstream out;
  Progress progress(out, false);
  const RawlogLog log = readRawlog(base + ".rawlog", progress);
  const auto poses = readTruePath(base + "_ground_truth_robot_path.txt", log.frame_stamps.size());
  const auto landmarks = readTrueLandmarks(base + "_ground_truth.txt");
  EXPECT_TRUE(log.made_up_stamps);
  EXPECT_EQ(log.odometry.size(), 250u);
  ASSERT_EQ(log.sightings.size(), 250u);
  ASSERT_EQ(landmarks.size(), 70u);
  double squared = 0.0;
  std::size_t count = 0;
  for (const auto& sighting : log.sightings) {
    const auto& pose = poses[sighting.frame];
    for (const auto& reading : sighting.readings) {
      const auto& landmark = landmarks.at(static_cast<std::size_t>(reading.id - 1));
      const double bearing = std::atan2(landmark.y - pose.y, landmark.x - pose.x) - pose.theta;
      squared += std::pow(std::remainder(reading.bearing - bearing, 2.0 * M_PI), 2);
      ++count;
    }
  }
  // The simulator's sigma is 0.1 degrees: an offset of one frame would show at once.
  EXPECT_NEAR(std::sqrt(squared / static_cast<double>(count)), 0.1 * M_PI / 180.0, 2e-4);
}

TEST(RealCarmen, KeepsTheOrderOfIntelsScansWithRisingStamps) {
  const auto path = fs::path(dataFolder()) / "laser" / "intel.clf";
  if (!fs::exists(path)) GTEST_SKIP() << "the real data set is absent: " << path;
  const CarmenLog log = readCarmen(path.string(), std::nullopt);
  ASSERT_EQ(log.scans.size(), 13631u);
  EXPECT_EQ(log.bad_lines, 0u);
  const CarmenClock clock = makeClock(log.scans);
  EXPECT_EQ(clock.steps_back, 629u);
  for (std::size_t i = 1; i < clock.written.size(); ++i)
    ASSERT_GT(clock.written[i], clock.written[i - 1]);
  std::size_t none = 0;
  for (const auto& scan : log.scans) {
    ASSERT_EQ(scan.reading.ranges.size(), 180u);
    for (const float range : scan.reading.ranges) {
      none += std::isinf(range);
      ASSERT_TRUE(std::isinf(range) || range < 80.0f);
    }
  }
  EXPECT_GT(none, 10000u);
}

TEST(RealSena, DrivesItsLoopWithOneLaserThatLooksAhead) {
  const std::string path =
      "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  if (!fs::exists(path)) GTEST_SKIP() << "mrpt-common is not installed";
  std::ostringstream out;
  Progress progress(out, false);
  const RawlogLog log = readRawlog(path, progress);
  EXPECT_FALSE(log.made_up_stamps);
  ASSERT_EQ(log.scans.size(), 225u);
  ASSERT_EQ(log.lasers.size(), 1u);
  EXPECT_NEAR(log.lasers[0].x, 0.78, 1e-6);
  double way = 0.0;
  for (std::size_t i = 1; i < log.odometry.size(); ++i) {
    const auto &a = log.odometry[i - 1], &b = log.odometry[i];
    way += std::hypot(b.x - a.x, b.y - a.y);
    EXPECT_GT(b.stamp, a.stamp);
  }
  EXPECT_GT(way, 20.0);
  EXPECT_EQ(log.odometry.back().stamp, log.scans.back().stamp);
  EXPECT_EQ(log.scans[0].reading.ranges.size(), 361u);
  EXPECT_NEAR(log.scans[0].reading.increment, 0.5 * M_PI / 180.0, 1e-6);
}

TEST(RealCircles, HasTheNumbersOfItsDocumentation) {
  const auto path = fs::path(dataFolder()) / "circles" / "map.circles";
  if (!fs::exists(path)) GTEST_SKIP() << "the real data set is absent: " << path;
  const CirclesLog log = readCircles(path.string());
  EXPECT_EQ(log.steps.size(), 3297u);
  EXPECT_EQ(log.unidentified, 436u);
  std::set<std::int64_t> ids;
  double way = 0.0;
  for (const auto& step : log.steps) {
    way += step.displacement.head<2>().norm();
    for (const auto& reading : step.readings)
      if (reading.id >= 0) ids.insert(reading.id);
  }
  EXPECT_EQ(ids.size(), 576u);
  EXPECT_NEAR(way, 505.0, 1.0);
}

}  // namespace
}  // namespace slam::eval
