// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <CLI/CLI.hpp>
#include <iostream>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_ros/tune_run.hpp"

namespace {

constexpr int kFailed = 1, kWrongUse = 2;

int fail(const std::string& sentence, int code) {
  std::cerr << "slam_tune: " << sentence << std::endl;
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Finds the noise of a robot's odometry and landmark sensor from bags it recorded, without "
      "truth, and writes a robot file. Do not judge the result on the same bags.",
      "slam_tune");
  slam_ros::TuneOptions options;
  app.add_option("ROBOT", options.robot, "a robot's name or file: where the search starts")
      ->required();
  app.add_option("--bag", options.bags, "recorded data; several are used together")->required();
  app.add_option("--out", options.out, "the robot file to write (default: tuned.yaml)");
  app.add_option("--product", options.product, "a product's name or file")->capture_default_str();
  app.add_option("--parameter", options.parameters,
                 "section.key of what is tuned (default: the alphas and the sensor's sigmas)");
  app.add_option("--set", options.overrides, "section.key=value, instead of the files' value");
  app.add_option("--remap", options.remaps, "input:=topic of the bag");
  options.out = "tuned.yaml";
  try {
    app.parse(argc, argv);
    slam_ros::tune(options);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(std::string(error.what()) + "; --help lists the options", kWrongUse);
  } catch (const slam_ros::UnknownName& error) {
    return fail(error.what(), kWrongUse);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
  return 0;
}
