// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <string>
#include <vector>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "observations_row.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/landmark_sensor.hpp"

// EKF-SLAM without ROS: a row "pose STAMP_NS X Y THETA" of the robot in the map for each
// observations row, and at the end "landmark ID X Y  SX SY" for each landmark [m, m, rad]. Rows of
// the log, in the order of time, of which observations are taken where the motion before them ends;
// '#' begins a comment:
//   motion START_NS END_NS X Y THETA  DX DY DTHETA  SX SY STHETA    as slam_core_wheel_log prints
//   it observations STAMP_NS [ID RANGE BEARING]...                     [m, rad]

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} LOG.txt [SECTION.KEY=VALUE]...\n"
    "  SECTION.KEY  of a product's or robot's file: landmark_sensor.sigma_range=0.1\n";

void print(const LandmarkMap& landmarks) {
  for (const auto& landmark : landmarks) {
    const Eigen::Vector2d sigma = landmark.covariance.diagonal().cwiseSqrt();
    fmt::print("landmark {} {:.9g} {:.9g}  {:.9g} {:.9g}\n", landmark.id, landmark.position.x(),
               landmark.position.y(), sigma.x(), sigma.y());
  }
}

void run(const std::string& path, std::vector<std::string> overrides) {
  Settings settings({}, {}, std::move(overrides));
  ekf::EkfSlam filter;
  filter.configure(settings);
  const auto sensor = settings.read<LandmarkSensorConfig>();
  settings.requireAllRead();
  LogRows row(path);
  while (row.next()) {
    if (row.kind() == "motion") filter.set(motionIn(row));
    if (row.kind() != "observations") continue;
    auto array = observationsIn(row);
    completeCovariances(sensor, array);
    for (const auto& z : array.observations)
      if (const auto fault = faultOf(z); !fault.empty()) row.fail(fault);
    filter.set(array);
    if (const auto status = filter.execute(); !status.isOk()) row.tell(status.message);
    fmt::print("{}", poseRow(array.stamp, filter.pose().pose));
  }
  print(as<LandmarkMapper>(filter).landmarks());
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, slam::kUsage, argv[0]);
    return 2;
  }
  return slam::exitCodeOf([&] { slam::run(argv[1], {argv + 2, argv + argc}); });
}
