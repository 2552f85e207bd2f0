// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <string>
#include <vector>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "odometry_row.hpp"
#include "slam_core/wheel_odometry/wheel_odometry.hpp"

// Wheel odometry without ROS: a row `motion` for each motion (motion_row.hpp), as the other
// programs read it. Rows of the log as slam_core_text_log reads them; those of other kinds are
// passed over:
//   odometry STAMP_NS X Y THETA                     pose in the odometry frame [m, m, rad]

namespace slam {
namespace {

constexpr const char* kUsage =
    "usage: {} LOG.txt [SECTION.KEY=VALUE]...\n"
    "  SECTION.KEY  of a robot's file: wheel_odometry.alpha1=0.01\n";

void run(const std::string& path, const std::vector<std::string>& overrides) {
  Settings settings({}, {}, overrides);
  wheel_odometry::WheelOdometry odometry;
  odometry.configure(settings);
  settings.requireAllRead();
  LogRows row(path);
  while (row.next()) {
    if (row.kind() != "odometry") continue;
    odometry.set(odometryIn(row));
    if (const auto status = odometry.execute(); !status.isOk()) row.tell(status.message);
    if (odometry.motion()) fmt::print("{}", motionRow(*odometry.motion()));
  }
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
