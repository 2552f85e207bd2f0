// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include "slam_ros/bag_reader.hpp"

namespace slam_ros {

struct GroundTruthCounts {
  std::size_t poses = 0, landmarks = 0;
};

/// Writes a bag's truth into a run's folder: ground_truth.tum from /ground_truth/pose and
/// ground_truth_landmarks.yaml from /ground_truth/landmarks (the last map is used). If the bag has
/// none, files of an earlier run are removed. Poses that are not numbers or not newer than the one
/// before are left out. A pose whose quaternion is zero has no heading, and its line has the zero
/// quaternion as well. /ground_truth/point (geometry_msgs/PointStamped) says of which point of the
/// robot the poses are, and becomes the comment "# point of the robot: x y". The table of the log's
/// own stamps, which an importer wrote beside the bag (BAG.stamps.csv), is copied to stamps.csv.
/// @throw std::runtime_error naming the file that could not be read or written
GroundTruthCounts writeGroundTruth(const BagReader& bag, const std::string& folder);

/// Writes the poses of a bag's `odom` as wheel_odometry.tum, for comparison in runs with another
/// odometry. Files and poses are treated as above. @throw as above
void writeWheelOdometry(const BagReader& bag, const std::string& folder);

}  // namespace slam_ros
