// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "victoria_park_log.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "import_error.hpp"
#include "laser_messages.hpp"
#include "sort_by_stamp.hpp"
#include "victoria_park_vehicle.hpp"

namespace slam::eval {
namespace {

constexpr double kLaserReach = 80.0;        // [m]; beyond stand the SICK's codes for no return
constexpr double kLongestInMetres = 100.0;  // ranges above are centimetres
constexpr double kRangeBits = 8192.0;       // the three bits above hold the intensity
constexpr double kLongestPeriod = 5.0;      // of any sensor [s]; longer ones are milliseconds
constexpr double kFastest = 50.0;           // [m/s]
constexpr double kSharpest = 1.2;           // [rad]
constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kTurnLength = 10.0;  // of a part of the way whose turn is compared [m]

/// Seconds a unit of the table's time stands for.
double timeUnit(const VictoriaParkTables::Table& table) {
  std::vector<double> periods;
  for (std::size_t i = 1; i < table.time.size(); ++i)
    if (const double period = table.time[i] - table.time[i - 1]; period > 0.0)
      periods.push_back(period);
  if (periods.empty()) throw ImportError(table.path + " holds no two rows of rising time");
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle > kLongestPeriod ? 1e-3 : 1.0;
}

/// Calls add(row, stamp [ns]) for each row whose values are numbers. @return rows left out
template <class Add>
std::size_t forEachRow(const VictoriaParkTables::Table& table, Add add) {
  if (table.path.empty()) return 0;
  constexpr double kLatest = 1e9;  // [s]
  const double unit = timeUnit(table);
  std::size_t left_out = 0;
  for (std::size_t row = 0; row < table.time.size(); ++row) {
    const double time = unit * table.time[row];
    const bool is_number =
        std::isfinite(time) && std::all_of(table.columns.begin(), table.columns.end(),
                                           [&](const auto& c) { return std::isfinite(c[row]); });
    if (is_number && std::abs(time) > kLatest)
      throw ImportError(table.path + ": row " + std::to_string(row + 1) +
                        ": the time is none of this log's");
    is_number ? add(row, std::llround(time * 1e9)) : void(++left_out);
  }
  return left_out;
}

/// Sorts, and keeps the first of equal stamps. @return rows left out
template <class Row>
std::size_t putInOrder(std::vector<Row>& rows) {
  sortByStamp(rows);
  const auto end = std::unique(rows.begin(), rows.end(),
                               [](const auto& a, const auto& b) { return a.stamp == b.stamp; });
  const auto doubles = static_cast<std::size_t>(std::distance(end, rows.end()));
  rows.erase(end, rows.end());
  return doubles;
}

void addScans(const VictoriaParkTables::Table& table, VictoriaParkLog& log) {
  double longest = 0.0;
  for (const auto& beam : table.columns)
    for (const double range : beam) longest = std::max(longest, range);
  const double unit = longest > kLongestInMetres ? 0.01 : 1.0;
  const bool has_intensity = unit < 1.0 && longest >= kRangeBits;
  log.left_out += forEachRow(table, [&](std::size_t row, std::int64_t stamp) {
    VictoriaParkLog::Scan scan;
    scan.stamp = stamp;
    for (const auto& beam : table.columns) {
      const double intensity = has_intensity ? std::floor(beam[row] / kRangeBits) : 0.0;
      scan.ranges.push_back(rangeOrNone(unit * (beam[row] - kRangeBits * intensity), kLaserReach));
      if (has_intensity) scan.intensities.push_back(static_cast<float>(intensity));
    }
    log.scans.push_back(std::move(scan));
  });
}

[[noreturn]] void refuseDriving(const VictoriaParkTables::Table& table, std::size_t row) {
  throw ImportError(table.path + ": row " + std::to_string(row + 1) + ": a speed of " +
                    std::to_string(table.columns[0][row]) + " m/s and a steering angle of " +
                    std::to_string(table.columns[1][row]) + " rad are none of a car");
}

void addDriving(const VictoriaParkTables::Table& table, VictoriaParkLog& log) {
  log.left_out += forEachRow(table, [&](std::size_t row, std::int64_t stamp) {
    const double speed = table.columns[0][row], steering = table.columns[1][row];
    if (std::abs(speed) > kFastest || std::abs(steering) > kSharpest) refuseDriving(table, row);
    const double curvature = std::tan(steering) / victoria_park::kWheelBase;
    const double forward = speed / (1.0 - victoria_park::kEncoderOffset * curvature);
    log.driving.push_back({stamp, forward, forward * curvature});
  });
}

void addFixes(const VictoriaParkTables::Table& table, VictoriaParkLog& log) {
  log.left_out += forEachRow(table, [&](std::size_t row, std::int64_t stamp) {
    log.fixes.push_back({stamp, table.columns[0][row], table.columns[1][row]});
  });
}

/// ROS knows no stamp of zero or before: the log then begins at one second.
void startAboveZero(VictoriaParkLog& log) {
  std::int64_t first = log.scans.front().stamp;
  first = std::min(first, log.driving.front().stamp);
  if (!log.fixes.empty()) first = std::min(first, log.fixes.front().stamp);
  if (first > 0) return;
  const auto shift = [&](auto& rows) {
    for (auto& row : rows) row.stamp += kSecond - first;
  };
  shift(log.scans);
  shift(log.driving);
  shift(log.fixes);
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether the fixes turn the other way than the steering, summed over the log: then their axes
/// make a left-handed frame, and x is y.
bool isMirrored(const VictoriaParkLog& log) {
  const auto poses = deadReckoning(log.driving);
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> parts;  // ends: steered, by GPS
  double agreement = 0.0;
  std::size_t row = 0;
  for (const auto& fix : log.fixes) {
    while (row + 1 < log.driving.size() && log.driving[row].stamp < fix.stamp) ++row;
    const std::pair<Eigen::Vector2d, Eigen::Vector2d> end{poses[row].position(), {fix.x, fix.y}};
    if (!parts.empty() && (end.first - parts.back().first).norm() < kTurnLength) continue;
    parts.push_back(end);
    if (parts.size() < 3) continue;
    const auto &from = parts[parts.size() - 3], &over = parts[parts.size() - 2];
    agreement += cross(over.first - from.first, end.first - over.first) *
                 cross(over.second - from.second, end.second - over.second);
  }
  return agreement < 0.0;
}

}  // namespace

std::vector<Pose2> deadReckoning(const std::vector<VictoriaParkLog::Driving>& driving) {
  std::vector<Pose2> poses;
  Pose2 pose;
  for (std::size_t i = 0; i < driving.size(); ++i) {
    if (i > 0) {
      const double dt = 1e-9 * static_cast<double>(driving[i].stamp - driving[i - 1].stamp);
      pose = pose *
             Pose2::exp(dt * Eigen::Vector3d(driving[i - 1].forward, 0.0, driving[i - 1].angular));
    }
    poses.push_back(pose);
  }
  return poses;
}

VictoriaParkLog makeVictoriaParkLog(const VictoriaParkTables& tables) {
  VictoriaParkLog log;
  addScans(tables.laser, log);
  addDriving(tables.driving, log);
  addFixes(tables.gps, log);
  log.left_out += putInOrder(log.scans) + putInOrder(log.driving) + putInOrder(log.fixes);
  if (log.scans.empty() || log.driving.empty())
    throw ImportError((log.scans.empty() ? tables.laser : tables.driving).path +
                      " holds no row without a value that is no number");
  startAboveZero(log);
  if (!tables.is_gps_named && isMirrored(log)) {
    log.are_axes_swapped = true;
    for (auto& fix : log.fixes) std::swap(fix.x, fix.y);
  }
  return log;
}

}  // namespace slam::eval
