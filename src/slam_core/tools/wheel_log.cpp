// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion_line.hpp"
#include "slam_core/wheel_odometry/wheel_odometry.hpp"

// Wheel odometry without ROS: a line for each motion. Lines of the log as slam_core_text_log reads
// them; those of other kinds are passed over:
//   odometry STAMP_NS X Y THETA                     pose in the odometry frame [m, m, rad]

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} LOG.txt [SECTION.KEY=VALUE]...\n"
    "  SECTION.KEY  of a robot's file: wheel_odometry.alpha1=0.01\n";

OdometrySample sampleOf(std::istringstream& words, int line) {
  std::int64_t stamp = 0;
  double x = 0.0, y = 0.0, theta = 0.0;
  if (!(words >> stamp >> x >> y >> theta))
    throw std::runtime_error(fmt::format("line {}: a number is missing or malformed", line));
  OdometrySample sample;
  sample.stamp = stampFromNanoseconds(stamp);
  sample.pose = Pose2(x, y, theta);
  return sample;
}

void run(const std::string& path, const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  wheel_odometry::WheelOdometry odometry;
  odometry.configure(settings);
  settings.requireAllRead();
  std::ifstream log(path);
  if (!log) throw std::runtime_error("cannot read the log " + path + "; does it exist?");
  std::string line, kind;
  for (int number = 1; std::getline(log, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    if (!(words >> kind) || kind != "odometry") continue;
    odometry.set(sampleOf(words, number));
    const auto status = odometry.execute();
    if (!status.isOk()) fmt::print(stderr, "line {}: {}\n", number, status.message);
    if (odometry.motion()) fmt::print("{}", motionLine(*odometry.motion()));
  }
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  try {
    slam::run(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
