// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/models/occupancy_grid.hpp"
#include "slam_core/product/step_report.hpp"

namespace slam_pipes {

// The process of a component reports to the program that started it. Reports cross a pipe of their
// own as port data do, under the names of ports that stand here.
namespace report {

constexpr const char* kWarning = "warning";  ///< slam::Status
constexpr const char* kStep = "step";        ///< StepDone, of the back-end
constexpr const char* kSummary = "summary";  ///< PartSummary, after the end of the data
constexpr const char* kFault = "fault";  ///< std::string: the sentence that the process ends with

/// In the other direction, behind the end of the bag's data.
constexpr const char* kFinish = "finish";  ///< Finish

}  // namespace report

struct StepDone {
  slam::StepReport report;
  std::int64_t nanoseconds = 0;  ///< that the step took

  template <class Archive>
  void persist(Archive& archive) {
    archive(report, nanoseconds);
  }
};

/// A component reports this when no more data come.
struct PartSummary {
  slam::Counters counters;  ///< of the component
  std::uint64_t dropped = 0;
  /// The counters of its input gates by the gate's name. Processes that take in the same data have
  /// the same gates, and count the same.
  std::map<std::string, slam::Counters> gate_counters;
  std::map<std::string, std::uint64_t> gate_dropped;
  // of the back-end
  std::string folder;      ///< where the files of the run stand until it is complete
  std::string starving;    ///< as slam::Intake::Arrivals has it
  slam::Counters waiting;  ///< data that no step was taken for
  std::uint64_t poses = 0, landmarks = 0;
  std::optional<slam::OccupancyGrid> grid;
  std::vector<std::string> calibration;  ///< sentences on what was calibrated

  template <class Archive>
  void persist(Archive& archive) {
    archive(counters, dropped, gate_counters, gate_dropped, folder, starving, waiting, poses,
            landmarks, grid, calibration);
  }
};

/// The run is good: the process writes what it has and ends.
struct Finish {
  std::string folder;  ///< that takes the files of modules
  std::string config;  ///< the content of config.yaml

  template <class Archive>
  void persist(Archive& archive) {
    archive(folder, config);
  }
};

}  // namespace slam_pipes
