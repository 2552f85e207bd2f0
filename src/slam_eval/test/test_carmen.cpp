// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "carmen_clock.hpp"
#include "carmen_log.hpp"
#include "carmen_maker.hpp"
#include "import_error.hpp"
#include "second.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

class Carmen : public testing::Test {
 protected:
  CarmenLog read(const std::string& content, std::optional<double> max_range = std::nullopt) {
    folder_.write("a.clf", content);
    return readCarmen(folder_.file("a.clf"), max_range);
  }
  std::string failure(const std::string& content) {
    return messageOf<ImportError>([&] { read(content); });
  }

  TempFolder folder_;
};

TEST_F(Carmen, ReadsScansWithTheRawOdometryAndTheStampOfTheirTime) {
  const CarmenLog log = read("# a comment\n\n" + flaser("976052857.340246"));
  ASSERT_EQ(log.scans.size(), 1u);
  const auto& scan = log.scans[0];
  EXPECT_EQ(scan.stamp, 976052857340246000);
  EXPECT_EQ(scan.odometry.vector(), Eigen::Vector3d(1.0, 2.0, 0.5));
  ASSERT_EQ(scan.reading.ranges.size(), 180u);
  EXPECT_EQ(scan.reading.ranges.front(), 2.5f);
}

TEST_F(Carmen, ReadsARangeAtOrBeyondTheMaximumAsNoReturn) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  EXPECT_EQ(read(flaser("1.0")).scans[0].reading.ranges.back(), kNone);
  const auto near = flaser("1.0", "0 0 0", 180, "49.5"), at = flaser("1.0", "0 0 0", 180, "50");
  EXPECT_EQ(read(near).scans[0].reading.ranges.back(), 49.5f);
  EXPECT_EQ(read(near, 40.0).scans[0].reading.ranges.back(), kNone);
  const std::string parameter = "PARAM robot_front_laser_max 50.0 nohost 0\n";
  EXPECT_EQ(read(parameter + near).scans[0].reading.ranges.back(), 49.5f);
  EXPECT_EQ(read(parameter + at).scans[0].reading.ranges.back(), kNone);
  const std::string far = "PARAM robot_front_laser_max 81.9 nohost 0\n";
  EXPECT_EQ(read(far + flaser("1.0")).scans[0].reading.ranges.back(), kNone)
      << "a SICK LMS tells by 81.83 that it saw nothing, whatever the robot's parameters say";
}

TEST_F(Carmen, SpreadsTheBeamsOverHalfACircle) {
  for (const auto& [beams, degrees] :
       {std::pair<std::size_t, double>{180, 1.0}, {181, 1.0}, {360, 0.5}, {361, 0.5}}) {
    const auto scan = read(flaser("1.0", "0 0 0", beams)).scans.at(0).reading;
    EXPECT_NEAR(scan.start_angle, -M_PI / 2.0, 1e-12);
    EXPECT_NEAR(scan.increment, degrees * M_PI / 180.0, 1e-12);
    const double last = scan.start_angle + static_cast<double>(beams - 1) * scan.increment;
    EXPECT_NEAR(last, M_PI / 2.0 - (beams % 2 ? 0.0 : scan.increment), 1e-9);
  }
}

TEST_F(Carmen, TakesTheLasersPlaceFromTheParameters) {
  const auto log = read("PARAM robot_frontlaser_offset 0.25 nohost 0\n" + flaser("1.0"));
  EXPECT_EQ(log.T_base_laser.vector(), Eigen::Vector3d(0.25, 0.0, 0.0));
}

TEST_F(Carmen, ReadsScansThatTellTheirAnglesAndTheLasersPlace) {
  const CarmenLog log = read(robotLaser("7.5") + flaser("7.5"));
  ASSERT_EQ(log.scans.size(), 1u) << "a log in both forms has each scan twice";
  EXPECT_EQ(log.left_out.at("FLASER"), 1u);
  const auto& scan = log.scans[0];
  EXPECT_EQ(scan.stamp, 7 * kSecond + kSecond / 2);
  EXPECT_EQ(scan.reading.start_angle, -1.0);
  EXPECT_EQ(scan.reading.increment, 1.0);
  EXPECT_EQ(scan.reading.max_range, 50.0);
  ASSERT_EQ(scan.reading.ranges.size(), 3u);
  EXPECT_EQ(scan.reading.ranges[2], 2.5f);
  EXPECT_TRUE(std::isinf(scan.reading.ranges[1]));
  EXPECT_TRUE(log.T_base_laser.vector().isApprox(Eigen::Vector3d(0.2, 0.0, 0.0), 1e-6));
}

TEST_F(Carmen, LeavesOutBadLinesAndTellsTheFirst) {
  const std::string good = flaser("1.0");
  const CarmenLog log =
      read(good + "FLASER 180 1.0 2.0\n" + flaser("2.0", "0 0 x") + flaser("3.0", "nan 0 0") +
           flaser("4.0", "0 0 0", 200) + flaser("-5.0") + flaser("6.0", "1e99 0 0") +
           "FLASER -3\nFLASER\nROBOTLASER1 0 1\n" + "ODOM 1 2\n" + flaser("9.0", "0 0 0", 181));
  EXPECT_EQ(log.scans.size(), 2u);
  EXPECT_EQ(log.bad_lines, 9u) << "ROBOTLASER1 is another kind here, not bad";
  EXPECT_NE(log.first_bad_line.find("a.clf:2: 4 words, expected 191"), std::string::npos)
      << log.first_bad_line;
}

TEST_F(Carmen, CountsLinesOfOtherKinds) {
  const CarmenLog log = read(flaser("1.0") + "SYNC nothing 1.0 host 1.0\nSYNC\nRLASER 1 2\n");
  EXPECT_EQ(log.left_out.at("SYNC"), 2u);
  EXPECT_EQ(log.left_out.at("RLASER"), 1u);
  EXPECT_EQ(log.bad_lines, 0u);
}

TEST_F(Carmen, RefusesALogWithoutScans) {
  EXPECT_NE(failure(odom("1.0", "0 0 0")).find("holds no laser scans"), std::string::npos);
  EXPECT_NE(failure("").find("holds no laser scans"), std::string::npos);
  const auto message = failure("FLASER 180 1.0\n");
  EXPECT_NE(message.find("the first bad line: "), std::string::npos) << message;
  EXPECT_NE(message.find("a.clf:1:"), std::string::npos) << message;
  EXPECT_THROW(readCarmen(folder_.file("none.clf"), std::nullopt), UsageError);
}

TEST_F(Carmen, WritesStampsThatRiseInFileOrder) {
  const CarmenLog log = read(flaser("10.0") + flaser("10.5") + flaser("10.5") + flaser("10.1") +
                             flaser("10.50025") + flaser("11.0"));
  const CarmenClock clock = makeClock(log.scans);
  const std::vector<std::int64_t> expected{10000000000, 10500000000, 10500100000,
                                           10500200000, 10500300000, 11000000000};
  EXPECT_EQ(clock.written, expected);
  EXPECT_EQ(clock.steps_back, 1u);
  EXPECT_EQ(clock.largest_step_back, 400000000);
  EXPECT_EQ(clock.repeated, 1u);
  const auto table = stampTable(log.scans, clock);
  EXPECT_EQ(table.substr(0, table.find('\n')), "source_stamp,written_stamp");
  EXPECT_NE(table.find("\n10.100000000,10.500200000\n"), std::string::npos) << table;
}

TEST_F(Carmen, KeepsOdometryThatLiesBetweenItsScans) {
  const CarmenLog log =
      read(odom("9.0", "1 0 0") + flaser("10.0") + odom("9.5", "2 0 0") + odom("10.2", "3 0 0") +
           odom("10.1", "4 0 0") + odom("10.5", "5 0 0") + flaser("10.5") + odom("12.0", "6 0 0"));
  const auto kept = odometryBetween(log, makeClock(log.scans));
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 2, 5}));
}

}  // namespace
}  // namespace slam::eval
