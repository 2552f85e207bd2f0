// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_ros/bag_run.hpp"
#include "slam_ros/command_line.hpp"

namespace slam_ros {

/// The command-line arguments for BagRunOptions; each program adds those for its output.
class BagRunArguments {
 public:
  /// @param options take what is given; they outlive the parsing
  void addTo(CommandLine& line, BagRunOptions& options) {
    line.add("PRODUCT", options.product, "a product's name, or its file").required();
    line.add("--bag", options.bag, "the recorded data").required();
    line.add("--robot", options.robot, "a robot's name or file; default: the bag's");
    line.add("--seed", seed_, "of every random stream; default: the product's");
    line.add("--set", options.overrides, "section.key=value, instead of the files' value");
    line.add("--remap", options.remaps, "input:=topic of the bag");
    line.add("--origin", origin_,
             "JSON that metrics.json and config.yaml get as `run`: version, bag, date, command");
  }

  /// To be called when the command line has been parsed. @throw std::runtime_error
  void complete(BagRunOptions& options) const {
    if (!seed_.empty()) options.overrides.push_back("seed=" + seed_);
    options.origin = RunOrigin(origin_);
  }

 private:
  std::string seed_, origin_;
};

}  // namespace slam_ros
