// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion_line.hpp"
#include "slam_core/camera/calibration_file.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"

// Visual odometry without ROS: a line for each motion. Lines of the log; files stand beside it or
// have a whole path:
//   image STAMP_NS FILE
// The camera looks up from the robot's origin; `ceiling_camera.sensor_pose=[x, y, z, roll, pitch,
// yaw]` mounts it elsewhere.

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} CALIBRATION.yaml LOG.txt visual_odometry.ceiling_height=METRES "
    "[SECTION.KEY=VALUE]...\n"
    "  CALIBRATION.yaml  as ROS's camera calibration writes it\n"
    "  SECTION.KEY       of a product's or robot's file\n";

Image imageOf(std::istringstream& words, const std::filesystem::path& folder, int line) {
  std::int64_t stamp = 0;
  std::string file;
  if (!(words >> stamp) || !std::getline(words >> std::ws, file))
    throw std::runtime_error(fmt::format("line {}: not of the form image STAMP_NS FILE", line));
  const auto path = (folder / file).string();
  const auto gray = cv::imread(path, cv::IMREAD_GRAYSCALE);
  if (gray.empty())
    throw std::runtime_error(fmt::format("line {}: cannot read the image {}", line, path));
  return {stampFromNanoseconds(stamp), "ceiling_camera", gray, ""};
}

void run(const std::string& calibration, const std::string& path,
         const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  visual_odometry::VisualOdometry odometry;
  odometry.configure(settings);
  settings.requireAllRead();
  odometry.set(loadCalibrationFile(calibration));
  std::ifstream log(path);
  if (!log) throw std::runtime_error("cannot read the log " + path + "; does it exist?");
  const auto folder = std::filesystem::absolute(path).parent_path();
  std::string line, kind;
  for (int number = 1; std::getline(log, line); ++number) {
    std::istringstream words(line);
    if (!(words >> kind) || kind != "image") continue;
    odometry.set(imageOf(words, folder, number));
    const auto status = odometry.execute();
    if (!status.isOk()) fmt::print(stderr, "line {}: {}\n", number, status.message);
    if (odometry.motion()) fmt::print("{}", motionLine(*odometry.motion()));
  }
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  std::vector<std::string> overrides = {"ceiling_camera.sensor_pose=[0, 0, 0, 0, 0, 0]"};
  overrides.insert(overrides.end(), argv + 3, argv + argc);
  try {
    slam::run(argv[1], argv[2], overrides);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
