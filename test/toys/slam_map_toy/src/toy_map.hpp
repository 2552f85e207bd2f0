// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "slam_core/contract/map_module.hpp"
#include "slam_core/models/filter_pose.hpp"

namespace slam_toy {

struct ToyMapConfig {
  static constexpr const char* kSection = "toy_map";

  double cell = 0.5;

  void describe(slam::Fields& fields);
};

/// Where the robot has been: how many of the back-end's poses lie in each cell of a grid.
class ToyMap final : public slam::MapModule {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;
  void set(const slam::FilterPose& pose) { pose_ = pose; }
  slam::Status execute() override;
  slam::Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override { return counters_["invalid_pose"]; }
  std::string sentence() const override { return "also a file of the cells where the robot was"; }
  /// Writes `toy_map.csv`: the cell's middle in the map frame [m] and its number of poses.
  void save(const std::string& folder) const override;
  void reset() override;

 private:
  ToyMapConfig config_;
  std::optional<slam::FilterPose> pose_;
  std::map<std::pair<long, long>, int> visits_;  ///< by the cell's column and row
  slam::Counters counters_;
};

}  // namespace slam_toy
