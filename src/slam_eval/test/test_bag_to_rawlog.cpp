// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "carmen_maker.hpp"
#include "program.hpp"
#include "rawlog_log.hpp"
#include "second.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

/// A CARMEN log that becomes a bag, and that a rawlog.
class BagToRawlog : public testing::Test {
 protected:
  ProgramRun convert(const std::string& log, const std::string& options = "") {
    std::ofstream(folder.file("a.clf")) << log;
    EXPECT_EQ(runSlamImport("carmen " + folder.file("a.clf") + " " + bag).exit_code, 0);
    return runCommand("'" SLAM_EVAL_RAWLOG "' " + bag + " " + rawlog + " " + options);
  }
  RawlogLog read() {
    std::ostringstream text;
    Progress progress(text, false);
    return readRawlog(rawlog, progress);
  }

  TempFolder folder;
  const std::string bag = folder.file("a.bag"), rawlog = folder.file("a.rawlog");
};

TEST_F(BagToRawlog, ScansAndOdometryAreThoseOfTheLog) {
  const auto run = convert(flaser("100", "1 2 0") + flaser("101", "2 2 0.5"));
  EXPECT_EQ(run.output, "100000000000 1 2 0 1\n101000000000 2 2 0.5 1\n");
  const auto log = read();
  ASSERT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(log.scans[1].stamp, 101 * kSecond);
  EXPECT_EQ(log.scans[1].reading.ranges.size(), 180u);
  EXPECT_EQ(log.scans[1].reading.ranges[0], 2.5f);
  EXPECT_TRUE(std::isinf(log.scans[1].reading.ranges[179])) << "it saw nothing";
  EXPECT_NEAR(log.scans[1].reading.start_angle, -M_PI * 179 / 360, 1e-6) << "about the mount";
  EXPECT_NEAR(log.odometry.back().x - log.odometry.front().x, 1.0, 1e-6);
  EXPECT_NEAR(log.odometry.back().theta, 0.5, 1e-6);
}

TEST_F(BagToRawlog, AFrameComesWhereTheRobotHasGoneOrTurnedFarEnough) {
  const auto run = convert(flaser("100", "0 0 0") + flaser("101", "0.2 0 0") +
                               flaser("102", "0.4 0 0") + flaser("103", "0.4 0 0.4"),
                           "--distance 0.3 --angle 0.3");
  EXPECT_EQ(run.output,
            "100000000000 0 0 0 1\n101000000000 0.2 0 0 0\n102000000000 0.4 0 0 1\n"
            "103000000000 0.4 0 0.4 1\n");
  EXPECT_EQ(read().scans.size(), 3u);
}

TEST_F(BagToRawlog, ABagThatIsNoneIsToldInASentence) {
  std::ofstream(bag) << "x";
  const auto run = runCommand("'" SLAM_EVAL_RAWLOG "' " + bag + " " + rawlog);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("a.bag"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace slam::eval
