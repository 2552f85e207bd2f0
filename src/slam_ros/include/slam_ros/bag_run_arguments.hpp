// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "slam_ros/bag_run.hpp"

namespace slam_ros {

/// The command line of BagRunOptions; each program adds where its files go.
class BagRunArguments {
 public:
  /// @param options take what is given; they outlive the parsing
  void addTo(CLI::App& app, BagRunOptions& options) {
    app.add_option("PRODUCT", options.product, "a product's name, or its file")->required();
    app.add_option("--bag", options.bag, "the recorded data")->required();
    app.add_option("--robot", options.robot, "a robot's name or file; default: the bag's");
    app.add_option("--seed", seed_, "of every random stream; default: the product's");
    app.add_option("--set", options.overrides, "section.key=value, instead of the files' value");
    app.add_option("--remap", options.remaps, "input:=topic of the bag");
    app.add_option(
        "--origin", origin_,
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
