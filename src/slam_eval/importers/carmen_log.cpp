// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_log.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "import_error.hpp"
#include "text_table.hpp"

namespace slam::eval {
namespace {

constexpr double kLargestRange = 80.0;  // of a SICK LMS [m]: above stand its error codes
constexpr std::size_t kMostBeams = 100000;
constexpr double kFarthest = 1e6;  // [m]: an odometry beyond is no robot's

const char kFrontLaser[] = "FLASER", kRobotLaser[] = "ROBOTLASER1";

// Words behind the ranges: laser pose, odometry, stamp, host, stamp of the logger.
constexpr std::size_t kFrontTail = 9;
// Words before the number of ranges, and behind the remissions: laser pose, robot pose, two
// velocities, three safety distances, stamp, host, stamp of the logger.
constexpr std::size_t kRobotHead = 8, kRobotTail = 14;
constexpr std::size_t kOdometryWords = 10;

[[noreturn]] void refuse(const TextRow& row, const std::string& what) {
  throw ImportError(row.place() + ": " + what);
}

std::size_t countAt(const TextRow& row, std::size_t column) {
  if (row.size() <= column) refuse(row, "the line is cut off");
  const auto count = row.integer(column);
  if (count < 0 || count > static_cast<std::int64_t>(kMostBeams))
    refuse(row, std::to_string(count) + " is no number of beams");
  return static_cast<std::size_t>(count);
}

void requireWords(const TextRow& row, std::size_t expected) {
  if (row.size() != expected)
    refuse(row, std::to_string(row.size()) + " words, expected " + std::to_string(expected) +
                    " (cut off, or another format)");
}

Pose2 poseAt(const TextRow& row, std::size_t column) {
  const Pose2 pose(row.number(column), row.number(column + 1), row.number(column + 2));
  if (pose.position().cwiseAbs().maxCoeff() > kFarthest) refuse(row, "the pose is no robot's");
  return pose;
}

/// A front laser sees half a circle; its line does not tell the angles. [rad]
double incrementOf(const TextRow& row, std::size_t beams) {
  if (beams == 180 || beams == 181) return M_PI / 180.0;
  if (beams == 360 || beams == 361) return M_PI / 360.0;
  refuse(row, std::to_string(beams) + " beams, where 180, 181, 360 or 361 are known");
}

class CarmenReader {
 public:
  CarmenReader(const std::string& path, std::optional<double> max_range)
      : path_(path), max_range_(max_range) {}

  CarmenLog read() {
    requireFile(path_);
    std::ifstream file(path_);
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number)
      addLine(line, path_ + ":" + std::to_string(number));
    if (file.bad() || !file.eof()) throw ImportError("cannot read " + path_);
    if (log_.scans.empty())
      throw ImportError(path_ + " holds no laser scans (FLASER or ROBOTLASER1)" +
                        (log_.bad_lines ? "; the first bad line: " + log_.first_bad_line : ""));
    return std::move(log_);
  }

 private:
  void addLine(const std::string& line, const std::string& place) {
    std::istringstream words(line);
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(std::move(word));
    if (fields.empty() || fields.front().front() == '#') return;
    const std::string kind = fields.front();
    try {
      addRow(TextRow(place, std::move(fields)), kind);
    } catch (const ImportError& error) {
      if (log_.bad_lines++ == 0) log_.first_bad_line = error.what();
    }
  }

  void addRow(const TextRow& row, const std::string& kind) {
    if (kind == "PARAM") {
      addParameter(row);
    } else if (kind == "ODOM") {
      addOdometry(row);
    } else if (kind == kFrontLaser && takes(kFrontLaser)) {
      addFrontScan(row);
    } else if (kind == kRobotLaser && takes(kRobotLaser)) {
      addRobotScan(row);
    } else {
      ++log_.left_out[kind];
    }
  }

  /// A log that has its scans in both forms has each of them twice.
  bool takes(const std::string& kind) const {
    return log_.scan_kind.empty() || log_.scan_kind == kind;
  }

  void addParameter(const TextRow& row) {
    if (row.size() < 3) return;
    if (row.text(1) == "robot_frontlaser_offset") log_.T_base_laser = Pose2(row.number(2), 0, 0);
    if (row.text(1) == "robot_front_laser_max" && row.number(2) > 0.0)
      log_range_ = std::min(row.number(2), kLargestRange);
  }

  void addOdometry(const TextRow& row) {
    requireWords(row, kOdometryWords);
    log_.odometry.push_back({row.stamp(7), poseAt(row, 1), row.number(4), row.number(5)});
  }

  void addFrontScan(const TextRow& row) {
    const std::size_t beams = countAt(row, 1), tail = 2 + beams;
    requireWords(row, tail + kFrontTail);
    CarmenLog::Scan scan;
    scan.reading.start_angle = -M_PI / 2.0;
    scan.reading.increment = incrementOf(row, beams);
    scan.reading.max_range = max_range_.value_or(log_range_);
    scan.odometry = poseAt(row, tail + 3);
    scan.stamp = row.stamp(tail + 6);
    addScan(row, 2, beams, std::move(scan));
  }

  void addRobotScan(const TextRow& row) {
    const std::size_t beams = countAt(row, kRobotHead);
    const std::size_t remissions = countAt(row, kRobotHead + 1 + beams);
    const std::size_t tail = kRobotHead + 2 + beams + remissions;
    requireWords(row, tail + kRobotTail);
    CarmenLog::Scan scan;
    scan.reading.start_angle = row.number(2);
    scan.reading.increment = row.number(4);
    scan.reading.max_range = max_range_.value_or(std::min(row.number(5), kLargestRange));
    scan.odometry = poseAt(row, tail + 3);
    scan.stamp = row.stamp(tail + 11);
    if (beams == 0 || scan.reading.increment <= 0.0 || scan.reading.max_range <= 0.0)
      refuse(row, "beams, angle between them and largest range have to be above 0");
    const Pose2 T_base_laser = scan.odometry.between(poseAt(row, tail));
    addScan(row, kRobotHead + 1, beams, std::move(scan));
    if (log_.scans.size() == 1) log_.T_base_laser = T_base_laser;
  }

  void addScan(const TextRow& row, std::size_t first, std::size_t beams, CarmenLog::Scan scan) {
    for (std::size_t i = 0; i < beams; ++i)
      scan.reading.ranges.push_back(rangeOrNone(row.number(first + i), scan.reading.max_range));
    scan.odometry_before = log_.odometry.size();
    log_.scan_kind = row.text(0);
    log_.scans.push_back(std::move(scan));
  }

  std::string path_;
  std::optional<double> max_range_;
  double log_range_ = kLargestRange;
  CarmenLog log_;
};

}  // namespace

CarmenLog readCarmen(const std::string& path, std::optional<double> max_range) {
  return CarmenReader(path, max_range).read();
}

}  // namespace slam::eval
