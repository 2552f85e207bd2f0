// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "import_error.hpp"
#include "mrclam_log.hpp"
#include "mrclam_set.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

class Mrclam : public testing::Test {
 protected:
  void SetUp() override { writeMrclamSet(folder_); }

  template <class Error>
  std::string failure(int robot = 2) {
    return messageOf<Error>([this, robot] { readMrclam(folder_.path(), robot); });
  }

  TempFolder folder_;
};

TEST_F(Mrclam, SortsRowsByStampAndCountsThoseOutOfOrder) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  EXPECT_EQ(log.out_of_order, 1u);
  ASSERT_EQ(log.odometry.size(), 4u);
  EXPECT_EQ(log.odometry[0].stamp, 1248444187156000000);
  EXPECT_EQ(log.odometry[1].stamp, 1248444187171000000);
  EXPECT_DOUBLE_EQ(log.odometry[1].forward, 0.3);
  EXPECT_DOUBLE_EQ(log.odometry[1].angular, 0.5);
}

TEST_F(Mrclam, KeepsTheLastOfTwoVelocitiesOfOneStamp) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  EXPECT_EQ(log.replaced_odometry, 1u);
  EXPECT_DOUBLE_EQ(log.odometry.back().forward, 0.5);
}

TEST_F(Mrclam, GroupsReadingsByStampUnderTheirSubjectNumbers) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  ASSERT_EQ(log.sightings.size(), 3u);
  EXPECT_EQ(log.sightings[0].stamp, 1248444187180000000);
  ASSERT_EQ(log.sightings[0].readings.size(), 2u);
  EXPECT_EQ(log.sightings[0].readings[0].landmark, 6);
  EXPECT_DOUBLE_EQ(log.sightings[0].readings[0].range, 2.5);
  EXPECT_EQ(log.sightings[0].readings[1].landmark, 7);
  EXPECT_DOUBLE_EQ(log.sightings[0].readings[1].bearing, -0.3);
}

TEST_F(Mrclam, DropsAndCountsOtherRobotsAndUnknownBarcodes) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  EXPECT_EQ(log.robot_readings, 2u);
  EXPECT_EQ(log.unknown_readings, 1u);
}

TEST_F(Mrclam, KeepsAStampWhoseReadingsAreAllDropped) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  EXPECT_EQ(log.sightings[1].stamp, 1248444187190000000);
  EXPECT_TRUE(log.sightings[1].readings.empty());
}

TEST_F(Mrclam, KeepsTwoReadingsOfOneLandmarkInOneStamp) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  ASSERT_EQ(log.sightings[2].readings.size(), 2u);
  EXPECT_EQ(log.sightings[2].readings[0].landmark, log.sightings[2].readings[1].landmark);
}

TEST_F(Mrclam, ReadsTheTruth) {
  const MrclamLog log = readMrclam(folder_.path(), 2);
  ASSERT_EQ(log.truth.size(), 2u);
  EXPECT_DOUBLE_EQ(log.truth[1].theta, 0.6);
  ASSERT_EQ(log.landmarks.size(), 2u);
  EXPECT_EQ(log.landmarks[0].id, 6);
  EXPECT_DOUBLE_EQ(log.landmarks[0].y, -2.5);
}

TEST_F(Mrclam, NamesTheMissingFile) {
  for (const std::string name : {"Barcodes.dat", "Landmark_Groundtruth.dat",
                                 "Robot2_Measurement.dat", "Robot2_Groundtruth.dat"}) {
    writeMrclamSet(folder_);
    std::filesystem::remove(folder_.file(name));
    const std::string message = failure<ImportError>();
    EXPECT_NE(message.find("no MRCLAM data set: it has no " + name), std::string::npos) << message;
  }
}

TEST_F(Mrclam, SaysWhichRobotsThereAre) {
  folder_.write("Robot4_Odometry.dat", "");
  const std::string message = failure<UsageError>(3);
  EXPECT_NE(message.find("has no robot 3; it has 2, 4"), std::string::npos) << message;
}

TEST_F(Mrclam, SaysThatTheFolderIsMissing) {
  EXPECT_THROW(readMrclam(folder_.file("none"), 2), UsageError);
}

TEST_F(Mrclam, NamesFileAndLineOfGarbage) {
  folder_.write("Robot2_Odometry.dat",
                "# Time v omega\n1248444187.156 0.1 -0.4\n1248444187.2 x 0\n");
  const std::string message = failure<ImportError>();
  EXPECT_NE(message.find("Robot2_Odometry.dat:3: column 2 is 'x'"), std::string::npos) << message;
}

TEST_F(Mrclam, RefusesABarcodeThatStandsTwice) {
  folder_.write("Barcodes.dat", "6 63\n7 63\n");
  EXPECT_NE(failure<ImportError>().find("barcode 63 stands twice"), std::string::npos);
}

}  // namespace
}  // namespace slam::eval
