// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "slam_core/camera/calibration_file.hpp"
#include "slam_core/camera/camera_gate.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/fiducial/fiducial_detector.hpp"

// Markers in image files, without ROS: a line for each marker. The camera looks along the robot's x
// axis from its origin; `camera.sensor_pose=[x, y, z, roll, pitch, yaw]` mounts it elsewhere.

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} apriltag|aruco CALIBRATION.yaml [SECTION.KEY=VALUE]... IMAGE...\n"
    "  CALIBRATION.yaml  as ROS's camera calibration writes it\n"
    "  SECTION.KEY       of a product's or robot's file: fiducial.marker_size=0.2\n";

struct Arguments {
  std::string detector, calibration;
  std::vector<std::string> overrides = {"camera.sensor_pose=[0, 0, 0, -1.5707963, 0, -1.5707963]"};
  std::vector<std::string> images;
};

std::string cornersText(const fiducial::Corners& corners) {
  std::string text;
  for (const auto& corner : corners)
    text += fmt::format(" ({:.2f} {:.2f})", corner.x(), corner.y());
  return text;
}

void print(const std::string& name, const std::vector<fiducial::MarkerDetection>& detections) {
  if (detections.empty()) fmt::print("{}: no marker found\n", name);
  for (const auto& marker : detections) {
    fmt::print("{}: id {}, corners{}", name, marker.id, cornersText(marker.corners));
    const auto& z = marker.observation;
    if (marker.isAccepted())
      fmt::print(", range {:.4f} +- {:.4f} m, bearing {:.4f} +- {:.4f} rad\n", z.range,
                 std::sqrt(z.covariance(0, 0)), z.bearing, std::sqrt(z.covariance(1, 1)));
    else
      fmt::print(", rejected: {}\n", marker.rejection);
  }
}

void run(const Arguments& arguments) {
  Settings settings({}, {}, arguments.overrides);
  auto role = Registry<LandmarkDetector>::instance().create(arguments.detector);
  auto* detector = dynamic_cast<fiducial::FiducialDetector*>(role.get());
  if (detector == nullptr)
    throw std::runtime_error(arguments.detector + " is no detector of fiducial markers");
  detector->configure(settings);
  CameraGate gate;
  gate.configure(settings);
  settings.requireAllRead();
  gate.set(loadCalibrationFile(arguments.calibration));
  Stamp stamp{};
  for (const auto& path : arguments.images) {
    requireInputFile(path, "the image");
    const auto gray = cv::imread(path, cv::IMREAD_GRAYSCALE);
    if (gray.empty()) throw std::runtime_error("cannot read the image " + path);
    stamp += std::chrono::seconds(1);
    gate.set(Image{stamp, "camera", gray, ""});
    auto status = gate.execute();
    detector->set(gate.view().value());
    status = moreUrgent(status, detector->execute());
    if (!status.isOk()) throw std::runtime_error(path + ": " + status.message);
    print(path, detector->detections());
  }
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  slam::Arguments arguments;
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    (word.find('=') == std::string::npos ? arguments.images : arguments.overrides).push_back(word);
  }
  if (arguments.images.empty()) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  arguments.detector = argv[1];
  arguments.calibration = argv[2];
  return slam::exitCodeOf([&] { slam::run(arguments); });
}
