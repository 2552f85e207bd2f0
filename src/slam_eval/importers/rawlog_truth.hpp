// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slam::eval {

/// The truth that MRPT's simulators write beside a rawlog as text.
struct RawlogTruth {
  struct Pose {
    double x, y, theta;  // [m, m, rad]
  };
  struct Landmark {
    std::int64_t id;
    double x, y;  // [m]
  };
};

/// The file NAME + ending or FILE + ending beside FILE = NAME.rawlog; empty if there is none.
std::string findTruthFile(const std::string& rawlog, const std::string& ending);

/// Rows "x y z . . . id" (_ground_truth.txt).
/// @throw UsageError no such file; ImportError a row is wrong or an id stands twice
std::vector<RawlogTruth::Landmark> readTrueLandmarks(const std::string& path);

/// Rows "x y z yaw pitch roll" (_ground_truth_robot_path.txt), one for each frame of the log; a
/// row more, the pose after the last motion, is left out.
/// @throw UsageError no such file; ImportError a row is wrong or their number does not fit
std::vector<RawlogTruth::Pose> readTruePath(const std::string& path, std::size_t frames);

}  // namespace slam::eval
