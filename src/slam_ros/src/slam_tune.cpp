// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/command_line.hpp"
#include "slam_ros/tune_run.hpp"

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_tune",
      "Finds the noise of a robot's odometry and landmark sensor from bags it recorded, without "
      "truth, and writes a robot file. Do not judge the result on the same bags.");
  slam_ros::TuneOptions options;
  line.add("ROBOT", options.robot, "a robot's name or file: where the search starts").required();
  line.add("--bag", options.bags, "recorded data; several are used together").required();
  line.add("--out", options.out, "the robot file to write (default: tuned.yaml)");
  line.add("--product", options.product, "a product's name or file").withDefault();
  line.add("--parameter", options.parameters,
           "section.key of what is tuned (default: the alphas and the sensor's sigmas)");
  line.add("--set", options.overrides, "section.key=value, instead of the files' value");
  line.add("--remap", options.remaps, "input:=topic of the bag");
  options.out = "tuned.yaml";
  return line.run(argc, argv, [&] { slam_ros::tune(options); });
}
