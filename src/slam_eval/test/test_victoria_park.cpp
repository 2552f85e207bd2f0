// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <functional>

#include "bag_contents.hpp"
#include "import_error.hpp"
#include "matlab_maker.hpp"
#include "program.hpp"
#include "temp_folder.hpp"
#include "victoria_park_log.hpp"

namespace slam::eval {
namespace {

using Form = MatlabMaker::Form;

constexpr std::size_t kBeams = 361;
constexpr double kPeriod = 25.0;  // of speed and steering [ms]

/// A drive of a car: one second ahead, then a left turn, with the GPS that its antenna would have.
struct Drive {
  std::vector<double> time, speed, steering;
  std::vector<double> gps_time, x, y;
  std::vector<double> laser_time;

  explicit Drive(int rows = 1600) {
    double px = 0.0, py = 0.0, heading = 0.0;
    for (int i = 0; i < rows; ++i) {
      time.push_back(1000.0 + kPeriod * i);
      speed.push_back(3.0);
      steering.push_back(i < 40 ? 0.0 : 0.1);
      const double curvature = std::tan(steering.back()) / 2.83;
      const double way = 1e-3 * kPeriod * 3.0 / (1.0 - 0.76 * curvature);
      if (i % 10 == 0) {
        gps_time.push_back(time.back());
        x.push_back(px + 3.78 * std::cos(heading) - 0.5 * std::sin(heading));
        y.push_back(py + 3.78 * std::sin(heading) + 0.5 * std::cos(heading));
      }
      if (i % 8 == 0) laser_time.push_back(time.back() + 3.0);
      px += way * std::cos(heading), py += way * std::sin(heading);
      heading += way * curvature;
    }
  }

  /// Ranges [cm], scan after scan: beam i of scan k reads 100 + i + k; beams at both ends none.
  double range(std::size_t scan, std::size_t beam) const {
    return beam == 0 || beam + 1 == kBeams ? 8191.0 : 100.0 + static_cast<double>(scan + beam);
  }
};

std::vector<double> rangesOf(const Drive& drive) {
  std::vector<double> column_by_column;
  for (std::size_t beam = 0; beam < kBeams; ++beam)
    for (std::size_t scan = 0; scan < drive.laser_time.size(); ++scan)
      column_by_column.push_back(drive.range(scan, beam));
  return column_by_column;
}

void writeMatlab(const TempFolder& folder, const Drive& drive, Form form) {
  const auto scans = static_cast<std::uint32_t>(drive.laser_time.size());
  folder.write("aa3_lsr2.mat", MatlabMaker(form)
                                   .addUint16("LASER", scans, kBeams, rangesOf(drive))
                                   .addColumn("TLsr", drive.laser_time)
                                   .bytes());
  folder.write("aa3_dr.mat", MatlabMaker(form)
                                 .addColumn("speed", drive.speed)
                                 .addColumn("steering", drive.steering)
                                 .addColumn("time", drive.time)
                                 .bytes());
  folder.write("aa3_gpsx.mat", MatlabMaker(form)
                                   .addColumn("La_m", drive.y)
                                   .addColumn("Lo_m", drive.x)
                                   .addColumn("timeGps", drive.gps_time)
                                   .bytes());
}

/// The text form: seconds and metres, a scan's numbers on several lines.
void writeText(const TempFolder& folder, const Drive& drive, bool is_north_first) {
  std::string laser, driving, gps;
  for (std::size_t k = 0; k < drive.laser_time.size(); ++k) {
    laser += std::to_string(drive.laser_time[k] / 1000);
    for (std::size_t i = 0; i < kBeams; ++i)
      laser += (i % 50 == 0 ? "\n" : "\t") + std::to_string(drive.range(k, i) / 100);
    laser += "\n";
  }
  for (std::size_t i = 0; i < drive.time.size(); ++i)
    driving += std::to_string(drive.time[i] / 1000) + " " + std::to_string(drive.speed[i]) + " " +
               std::to_string(drive.steering[i]) + "\n";
  for (std::size_t i = 0; i < drive.gps_time.size(); ++i)
    gps += std::to_string(drive.gps_time[i] / 1000) + " " +
           std::to_string(is_north_first ? drive.y[i] : drive.x[i]) + " " +
           std::to_string(is_north_first ? drive.x[i] : drive.y[i]) + "\n";
  folder.write("LASER.txt", laser);
  folder.write("DRS.txt", "time speed steering\n" + driving);
  folder.write("GPS.txt", gps);
}

class VictoriaPark : public testing::Test {
 protected:
  VictoriaParkLog read() const {
    return makeVictoriaParkLog(readVictoriaParkTables(folder_.path()));
  }
  std::string failure() const {
    return messageOf<ImportError>([&] { read(); });
  }
  void expectFailure(const std::string& text) const {
    EXPECT_NE(failure().find(text), std::string::npos) << failure();
  }
  void expectTheDrive(const VictoriaParkLog& log) const {
    ASSERT_EQ(log.scans.size(), drive_.laser_time.size());
    EXPECT_EQ(log.scans[1].stamp, 1'203'000'000);
    ASSERT_EQ(log.scans[1].ranges.size(), kBeams);
    EXPECT_EQ(log.scans[1].ranges[0], std::numeric_limits<float>::infinity());
    EXPECT_NEAR(log.scans[1].ranges[180], 2.81, 1e-5);
    ASSERT_EQ(log.driving.size(), drive_.time.size());
    EXPECT_EQ(log.driving[1].stamp, 1'025'000'000);
    ASSERT_EQ(log.fixes.size(), drive_.gps_time.size());
    EXPECT_NEAR(log.fixes.back().x, drive_.x.back(), 1e-5);
    EXPECT_NEAR(log.fixes.back().y, drive_.y.back(), 1e-5);
    EXPECT_EQ(log.left_out, 0u);
  }

  TempFolder folder_, out_;
  Drive drive_;
};

TEST_F(VictoriaPark, EachFormOfItsFilesTellsTheSame) {
  for (const auto form : {Form::kLevel4, Form::kLevel5, Form::kLevel5Compressed}) {
    writeMatlab(folder_, drive_, form);
    expectTheDrive(read());
  }
}

TEST_F(VictoriaPark, TextTellsTheSameWhicheverAxisOfTheGpsComesFirst) {
  for (const bool is_north_first : {false, true}) {
    writeText(folder_, drive_, is_north_first);
    const auto log = read();
    expectTheDrive(log);
    EXPECT_EQ(log.are_axes_swapped, is_north_first);
  }
}

TEST_F(VictoriaPark, TheMiddleOfTheRearAxleDrivesFasterThanTheInnerWheel) {
  writeMatlab(folder_, drive_, Form::kLevel5);
  const auto log = read();
  EXPECT_EQ(log.driving[0].forward, 3.0);
  EXPECT_EQ(log.driving[0].angular, 0.0);
  const auto& turn = log.driving[100];
  EXPECT_NEAR(turn.angular / turn.forward, std::tan(0.1) / 2.83, 1e-12) << "Ackermann";
  EXPECT_NEAR(turn.forward - 0.76 * turn.angular, 3.0, 1e-12) << "the left wheel's own speed";
}

TEST_F(VictoriaPark, DeadReckoningEndsWhereTheAntennaIs) {
  writeMatlab(folder_, drive_, Form::kLevel5);
  const auto log = read();
  const auto poses = deadReckoning(log.driving);
  const auto& fix = log.fixes.back();
  const auto row = static_cast<std::size_t>(1e-6 * static_cast<double>(fix.stamp) - 1000) / 25;
  const Eigen::Vector2d antenna = poses[row].transform({3.78, 0.5});
  EXPECT_NEAR(antenna.x(), fix.x, 0.5) << "the test drives in short straight lines";
  EXPECT_NEAR(antenna.y(), fix.y, 0.5);
}

TEST_F(VictoriaPark, TheHighBitsOfARangeAreItsIntensity) {
  writeMatlab(folder_, drive_, Form::kLevel5);
  folder_.write("aa3_lsr2.mat",
                MatlabMaker(Form::kLevel5)
                    .addUint16("LASER", 2, kBeams, std::vector<double>(2 * kBeams, 8192 * 5 + 1234))
                    .addColumn("TLsr", {1000, 1200})
                    .bytes());
  const auto log = read();
  EXPECT_NEAR(log.scans[0].ranges[7], 12.34, 1e-5);
  EXPECT_EQ(log.scans[0].intensities[7], 5.0f);
}

TEST_F(VictoriaPark, ALogThatStartsAtZeroIsMovedBehindZero) {
  for (auto* times : {&drive_.time, &drive_.laser_time, &drive_.gps_time})
    for (auto& time : *times) time -= 1000.0;
  writeMatlab(folder_, drive_, Form::kLevel5);
  expectTheDrive(read());
}

TEST_F(VictoriaPark, RowsThatAreNoNumbersOrStandTwiceAreLeftOut) {
  drive_.speed[5] = std::nan("");
  drive_.time[9] = drive_.time[8];
  writeMatlab(folder_, drive_, Form::kLevel5);
  const auto log = read();
  EXPECT_EQ(log.left_out, 2u);
  EXPECT_EQ(log.driving.size(), drive_.time.size() - 2);
}

TEST_F(VictoriaPark, MakesABagWithItsUnitsAndFrames) {
  writeMatlab(folder_, drive_, Form::kLevel5Compressed);
  const auto bag = out_.file("park.bag");
  const auto run = runSlamImport("victoria_park " + folder_.path() + " " + bag);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("200 scans, 1600 velocities, 160 GPS fixes"), std::string::npos)
      << run.output;
  EXPECT_EQ(messagesOf<std_msgs::String>(bag, "/robot").at(0).data, "victoria_park");
  const auto scan = messagesOf<sensor_msgs::LaserScan>(bag, "/scan").at(0);
  EXPECT_NEAR(scan.angle_min, -M_PI / 2, 1e-6);
  EXPECT_NEAR(scan.angle_max, M_PI / 2, 1e-6);
  EXPECT_EQ(scan.range_max, 80.0f);
  const auto mount = messagesOf<tf2_msgs::TFMessage>(bag, "/tf_static").at(0).transforms.at(0);
  EXPECT_EQ(mount.transform.translation.x, 3.78);
  EXPECT_EQ(mount.transform.translation.y, 0.5);
  EXPECT_EQ(messagesOf<nav_msgs::Odometry>(bag, "/odom").at(0).twist.twist.linear.x, 3.0);
  const auto truth = messagesOf<geometry_msgs::PoseStamped>(bag, "/ground_truth/pose").at(0);
  EXPECT_EQ(truth.pose.orientation.w, 0.0) << "no heading";
  EXPECT_EQ(messagesOf<geometry_msgs::PointStamped>(bag, "/ground_truth/point").at(0).point.x,
            3.78);
}

TEST_F(VictoriaPark, SaysWhatIsWrongWithItsFiles) {
  EXPECT_NE(messageOf<UsageError>([&] { readVictoriaParkTables("nowhere"); }).find("no folder"),
            std::string::npos);
  expectFailure("holds no laser scans (aa3_lsr2.mat or LASER.txt)");
  writeText(folder_, drive_, true);
  std::filesystem::remove(folder_.file("DRS.txt"));
  expectFailure("holds no speed and steering");
  folder_.write("DRS.txt", "1.0 3.0 0.1\n1.1 3.0\n");
  expectFailure("DRS.txt holds 5 numbers, where each row has 3 (truncated");
  folder_.write("DRS.txt", "1.0 3.0 0.1\n1.1 fast 0.1\n");
  expectFailure("DRS.txt:2: 'fast' is no number");
  folder_.write("DRS.txt", "1.0 3.0 0.1\n1.1 3.0 15\n");
  expectFailure("DRS.txt: row 2: a speed of 3.000000 m/s and a steering angle of 15.000000 rad");
  folder_.write("DRS.txt", "1.0 3.0 0.1\n1.0 3.0 0.1\n");
  expectFailure("no two rows of rising time");
}

TEST_F(VictoriaPark, SaysWhatIsWrongWithItsMatrices) {
  writeMatlab(folder_, drive_, Form::kLevel5);
  const auto replace = [&](const std::string& name, const MatlabMaker& maker) {
    folder_.write(name, maker.bytes());
  };
  replace("aa3_dr.mat", MatlabMaker(Form::kLevel5)
                            .addColumn("speed", {1, 2})
                            .addColumn("steering", {0, 0})
                            .addColumn("time", {1, 2, 3}));
  expectFailure("aa3_dr.mat holds 3 times, but 2 values");
  replace("aa3_dr.mat",
          MatlabMaker(Form::kLevel5).addColumn("speed", {1, 2}).addColumn("steering", {0, 0}));
  expectFailure("aa3_dr.mat holds speed, but no time");
  writeMatlab(folder_, drive_, Form::kLevel5);
  replace(
      "aa3_lsr2.mat",
      MatlabMaker(Form::kLevel5).add("LASER", 2, 3, {1, 2, 3, 4, 5, 6}).addColumn("TLsr", {1, 2}));
  expectFailure("LASER is 2 x 3, where scans have 361 ranges");
}

}  // namespace
}  // namespace slam::eval
