// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "slam_core/camera/calibration_file.hpp"
#include "slam_core/camera/camera_gate.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/visual_odometry/visual_odometry.hpp"

// Visual odometry without ROS: a row `motion` for each motion (motion_row.hpp), as the other
// programs read it. Rows of the log; files stand beside it or have a whole path:
//   image STAMP_NS FILE
// The camera looks up from the robot's origin; `ceiling_camera.sensor_pose=[x, y, z, roll, pitch,
// yaw]` mounts it elsewhere.

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} CALIBRATION.yaml LOG.txt ceiling_camera.ceiling_height=METRES "
    "[SECTION.KEY=VALUE]...\n"
    "  CALIBRATION.yaml  as ROS's camera calibration writes it\n"
    "  SECTION.KEY       of a product's or robot's file\n";

Image imageIn(LogRows& row, const std::filesystem::path& folder) {
  const auto stamp = stampFromNanoseconds(row.integer());
  const auto path = (folder / row.rest()).string();
  if (const auto fault = inputFileFault(path); !fault.empty())
    row.fail("cannot read the image " + path + ": " + fault);
  const auto gray = cv::imread(path, cv::IMREAD_GRAYSCALE);
  if (gray.empty()) row.fail("cannot read the image " + path);
  return {stamp, "ceiling_camera", gray, ""};
}

void run(const std::string& calibration, const std::string& path,
         const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  visual_odometry::VisualOdometry odometry;
  odometry.configure(settings);
  CeilingCameraGate gate;
  gate.configure(settings);
  settings.requireAllRead();
  gate.set(loadCalibrationFile(calibration));
  LogRows row(path);
  const auto folder = std::filesystem::absolute(path).parent_path();
  while (row.next()) {
    if (row.kind() != "image") continue;
    gate.set(imageIn(row, folder));
    if (const auto status = gate.execute(); !status.isOk()) row.tell(status.message);
    if (gate.view()) odometry.set(*gate.view());
    if (const auto status = odometry.execute(); !status.isOk()) row.tell(status.message);
    if (odometry.motion()) fmt::print("{}", motionRow(*odometry.motion()));
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
  return slam::exitCodeOf([&] { slam::run(argv[1], argv[2], overrides); });
}
