// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slam::eval {

/// A line of a CARMEN log: a scan of the front laser, all ranges alike but the last.
inline std::string flaser(const std::string& stamp, const std::string& odometry = "1 2 0.5",
                          std::size_t beams = 180, const std::string& last_range = "81.83") {
  std::string line = "FLASER " + std::to_string(beams);
  for (std::size_t i = 0; i + 1 < beams; ++i) line += " 2.5";
  return line + " " + last_range + " 9 9 9 " + odometry + " " + stamp + " host " + stamp + "\n";
}

/// A line of odometry.
inline std::string odom(const std::string& stamp, const std::string& pose) {
  return "ODOM " + pose + " 0.3 -0.1 0 " + stamp + " host " + stamp + "\n";
}

/// A scan of three beams with intensities, from a laser 0.2 m ahead of the robot's centre.
inline std::string robotLaser(const std::string& stamp) {
  return "ROBOTLASER1 0 -1.0 2.0 1.0 50 0.01 2 3 1.5 50 2.5 2 7 8 1 2.2 1.5707963 "
         "1 2 1.5707963 0 0 0 0 0 " +
         stamp + " host 0.1\n";
}

}  // namespace slam::eval
