// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>

#include "fiducial_detection.hpp"
#include "fiducial_timing.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_ros/command_line.hpp"

// Time of the fiducial detectors beside the bare libraries, and what they see from where.

namespace slam::eval {
namespace {

struct Options {
  std::string image;
  int repeats = 60, trials = 20;
};

nlohmann::json times(const Options& options) {
  auto timing = timeDetectors(tenMarkers(), "10 rendered tags, 640x480", options.repeats);
  if (options.image.empty()) return timing;
  const cv::Mat photo = cv::imread(options.image, cv::IMREAD_GRAYSCALE);
  if (photo.empty()) throw std::runtime_error(options.image + ": is no picture that can be read");
  const auto name = options.image.substr(options.image.find_last_of('/') + 1) + ", " +
                    std::to_string(photo.cols) + "x" + std::to_string(photo.rows);
  for (const auto& entry : timeDetectors(photo, name, options.repeats)) timing.push_back(entry);
  return timing;
}

nlohmann::json detections(const Options& options) {
  Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  bool begun = false;
  const auto table = detectionTable(options.trials, [&](std::size_t cell, std::size_t cells) {
    if (!begun) progress.begin("detection of rendered markers", cells);
    begun = true;
    progress.update(cell);
  });
  progress.end();
  return table;
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_fiducial",
      "Time of the fiducial detectors beside the bare libraries, and their detection rate");
  slam::eval::Options options;
  line.add("--image", options.image, "photograph to measure the time on as well").existingFile();
  line.add("--repeats", options.repeats, "frames for each time").positive().withDefault();
  line.add("--trials", options.trials, "images for each distance and obliqueness")
      .positive()
      .withDefault();
  return line.run(argc, argv, [&] {
    cv::setNumThreads(1);
    const nlohmann::json result = {{"timing", slam::eval::times(options)},
                                   {"detection", slam::eval::detections(options)}};
    std::puts(result.dump(1).c_str());
  });
}
