// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/scan_detector.hpp"

#include <algorithm>
#include <utility>

namespace slam::laser_landmarks {

void ScanDetector::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", this);
  ports.makes<LandmarkObservationArray>("observations", observations_);
}

void ScanDetector::reset() {
  next_scan_.reset();
  observations_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status ScanDetector::execute() {
  observations_.reset();
  const auto scan = std::exchange(next_scan_, std::nullopt);
  if (!scan) return Status::ok();
  auto& array = observations_.emplace();
  array.sequence = next_sequence_++;
  array.stamp = scan->stamp;
  array.sensor_frame = scan->sensor_frame;
  array.sensor_pose = scan->sensor_pose;
  auto& found = array.observations;
  const auto status = find(*scan, found, counters_);
  const auto is_invalid = [](const auto& z) { return !faultOf(z).empty(); };
  const auto valid = std::remove_if(found.begin(), found.end(), is_invalid);
  if (valid != found.end())
    counters_.add("invalid_observation", static_cast<std::uint64_t>(found.end() - valid));
  found.erase(valid, found.end());
  return status;
}

void ScanDetector::saveState(ArchiveWriter& archive) const { archive(*this); }

void ScanDetector::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::laser_landmarks
