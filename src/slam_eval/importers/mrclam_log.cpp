// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mrclam_log.hpp"

#include <filesystem>
#include <map>

#include "import_error.hpp"
#include "sort_by_stamp.hpp"
#include "text_table.hpp"

namespace slam::eval {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kLastRobotSubject = 5;  // subjects 1 to 5 are robots, 6 to 20 landmarks

std::string robotFile(const std::string& folder, int robot, const std::string& kind) {
  return (fs::path(folder) / ("Robot" + std::to_string(robot) + "_" + kind + ".dat")).string();
}

std::string robotsIn(const std::string& folder) {
  std::string list;
  for (int robot = 1; robot <= kLastRobotSubject; ++robot) {
    if (!fs::exists(robotFile(folder, robot, "Odometry"))) continue;
    list += (list.empty() ? "" : ", ") + std::to_string(robot);
  }
  return list;
}

void checkFiles(const std::string& folder, int robot) {
  if (!fs::is_directory(folder)) throw UsageError("there is no folder " + folder);
  const auto require = [&folder](const std::string& path) {
    if (fs::is_regular_file(path)) return;
    throw ImportError(folder + " is no MRCLAM data set: it has no " +
                      fs::path(path).filename().string());
  };
  require((fs::path(folder) / "Barcodes.dat").string());
  require((fs::path(folder) / "Landmark_Groundtruth.dat").string());
  const std::string robots = robotsIn(folder);
  if (robots.empty()) require(robotFile(folder, 1, "Odometry"));
  if (!fs::exists(robotFile(folder, robot, "Odometry"))) {
    throw UsageError(folder + " has no robot " + std::to_string(robot) + "; it has " + robots);
  }
  require(robotFile(folder, robot, "Measurement"));
  require(robotFile(folder, robot, "Groundtruth"));
}

/// A velocity holds until the next one: of several with one stamp all but the last hold for no
/// time. @return rows removed
std::size_t keepLastOfEachStamp(std::vector<MrclamLog::Velocity>& rows) {
  std::vector<MrclamLog::Velocity> kept;
  for (const MrclamLog::Velocity& row : rows) {
    if (!kept.empty() && kept.back().stamp == row.stamp) kept.pop_back();
    kept.push_back(row);
  }
  const std::size_t removed = rows.size() - kept.size();
  rows = std::move(kept);
  return removed;
}

void readOdometry(const std::string& path, MrclamLog& log) {
  for (const TextRow& row : readTable(path, 3, '#')) {
    log.odometry.push_back({row.stamp(0), row.number(1), row.number(2)});
  }
  log.out_of_order += sortByStamp(log.odometry);
  log.replaced_odometry = keepLastOfEachStamp(log.odometry);
}

std::map<std::int64_t, std::int64_t> readBarcodes(const std::string& path) {
  std::map<std::int64_t, std::int64_t> subject_of;
  for (const TextRow& row : readTable(path, 2, '#')) {
    if (!subject_of.emplace(row.integer(1), row.integer(0)).second) {
      throw ImportError(path + ": barcode " + std::to_string(row.integer(1)) + " stands twice");
    }
  }
  return subject_of;
}

struct RawReading {
  std::int64_t stamp;
  std::int64_t barcode;
  double range;
  double bearing;
};

void readMeasurements(const std::string& path, const std::map<std::int64_t, std::int64_t>& subjects,
                      MrclamLog& log) {
  std::vector<RawReading> rows;
  for (const TextRow& row : readTable(path, 4, '#')) {
    rows.push_back({row.stamp(0), row.integer(1), row.number(2), row.number(3)});
  }
  log.out_of_order += sortByStamp(rows);
  for (const RawReading& row : rows) {
    if (log.sightings.empty() || log.sightings.back().stamp != row.stamp) {
      log.sightings.push_back({row.stamp, {}});
    }
    const auto subject = subjects.find(row.barcode);
    if (subject == subjects.end()) {
      ++log.unknown_readings;
    } else if (subject->second <= kLastRobotSubject) {
      ++log.robot_readings;
    } else {
      log.sightings.back().readings.push_back({subject->second, row.range, row.bearing});
    }
  }
}

void readTruth(const std::string& path, MrclamLog& log) {
  for (const TextRow& row : readTable(path, 4, '#')) {
    log.truth.push_back({row.stamp(0), row.number(1), row.number(2), row.number(3)});
  }
  log.out_of_order += sortByStamp(log.truth);
}

void readLandmarks(const std::string& path, MrclamLog& log) {
  for (const TextRow& row : readTable(path, 5, '#')) {
    log.landmarks.push_back({row.integer(0), row.number(1), row.number(2)});
  }
}

}  // namespace

MrclamLog readMrclam(const std::string& folder, int robot) {
  checkFiles(folder, robot);
  MrclamLog log;
  readOdometry(robotFile(folder, robot, "Odometry"), log);
  readMeasurements(robotFile(folder, robot, "Measurement"),
                   readBarcodes((fs::path(folder) / "Barcodes.dat").string()), log);
  readTruth(robotFile(folder, robot, "Groundtruth"), log);
  readLandmarks((fs::path(folder) / "Landmark_Groundtruth.dat").string(), log);
  return log;
}

}  // namespace slam::eval
