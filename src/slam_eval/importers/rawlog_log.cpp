// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_log.hpp"

#include <algorithm>

#include "rawlog_file.hpp"
#include "rawlog_lasers.hpp"
#include "rawlog_steps.hpp"
#include "sort_by_stamp.hpp"

namespace slam::eval {

namespace {

constexpr std::int64_t kShortestMeanInterval = 5'000'000;  // [ns]

/// A simulator stamps its log with the time it ran: frames in a few milliseconds, some at
/// once. Frames between actions have to come one after the other; single observations may be
/// sorted.
bool hasUsableStamps(const RawlogSteps& log) {
  std::int64_t first = 0, last = 0, ticks = 0;
  std::size_t last_frame = 0;
  for (const RawlogStep& step : log.steps) {
    if (step.stamp == 0) return false;
    if (!step.ends_frame) continue;
    const bool new_frame = ticks > 0 && step.frame != last_frame;
    if (log.has_actions && new_frame && step.stamp <= last) return false;
    first = ticks == 0 ? step.stamp : std::min(first, step.stamp);
    last = std::max(last, step.stamp);
    last_frame = step.frame;
    ++ticks;
  }
  return ticks < 2 || last - first >= (ticks - 1) * kShortestMeanInterval;
}

/// A clock that ticks once a frame; odometry between frames is that of the next frame's time.
void makeUpStamps(RawlogSteps& log, std::size_t& left_out) {
  for (RawlogStep& step : log.steps) {
    const auto ticks = static_cast<std::int64_t>(step.frame) + 1;
    step.stamp = RawlogLog::kClockStart + ticks * RawlogLog::kStepTime;
  }
  while (!log.steps.empty() && !log.steps.back().ends_frame) {
    log.steps.pop_back();
    ++left_out;
  }
}

/// Two sensors may see at the same time; a source's stamps must rise.
void separateEqualSightings(std::vector<RawlogStep>& steps) {
  std::int64_t newest = 0;
  for (RawlogStep& step : steps) {
    if (!step.ends_frame) continue;
    step.stamp = std::max(step.stamp, newest + 1);
    newest = step.stamp;
  }
}

void addOdometry(const RawlogStep& step, RawlogLog& log) {
  if (!log.odometry.empty() && log.odometry.back().stamp >= step.stamp) {
    log.odometry.pop_back();
    ++log.left_out_odometry;
  }
  log.odometry.push_back(*step.odometry);
  log.odometry.back().stamp = step.stamp;
}

void addSeen(RawlogStep& step, RawlogLog& log) {
  if (step.sighting) {
    step.sighting->stamp = step.stamp;
    log.sightings.push_back(std::move(*step.sighting));
  }
  if (step.scan && step.scan->laser == log.main_laser) {
    step.scan->stamp = step.stamp;
    log.scans.push_back(std::move(*step.scan));
  }
}

/// Motion needs a pose from which it starts. Where a frame comes before the first action, that is
/// the pose of this frame.
void addStart(const RawlogSteps& steps, RawlogLog& log) {
  if (steps.has_actions ? !steps.begins_with_action : !log.made_up_stamps) return;
  RawlogLog::Odometry start;
  for (const RawlogStep& step : steps.steps) {
    if (steps.has_actions || !step.odometry) continue;
    start = *step.odometry;
    break;
  }
  if (steps.steps.empty()) return;
  start.stamp = std::max<std::int64_t>(steps.steps.front().stamp - RawlogLog::kStepTime, 1);
  log.odometry.push_back(start);
}

}  // namespace

RawlogLog readRawlog(const std::string& path, Progress& progress) {
  RawlogSteps steps = makeRawlogSteps(readRawlogObjects(path, progress), path);
  RawlogLog log;
  log.left_out_odometry = steps.left_out_odometry;
  log.left_out_readings = steps.left_out_readings;
  log.left_out_scans = steps.left_out_scans;
  log.other_objects = steps.other_objects;
  log.lasers = std::move(steps.lasers);
  log.main_laser = mainLaser(log.lasers);
  log.made_up_stamps = !hasUsableStamps(steps);
  if (log.made_up_stamps) makeUpStamps(steps, log.left_out_odometry);
  if (!steps.has_actions) log.out_of_order = sortByStamp(steps.steps);
  separateEqualSightings(steps.steps);
  addStart(steps, log);
  log.frame_stamps.resize(steps.frames);
  for (RawlogStep& step : steps.steps) {
    if (step.odometry) addOdometry(step, log);
    if (step.ends_frame) log.frame_stamps[step.frame] = step.stamp;
    addSeen(step, log);
  }
  return log;
}

}  // namespace slam::eval
