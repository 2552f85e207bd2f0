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
/// ground_truth_landmarks.yaml from /ground_truth/landmarks (the last map counts). Where the bag
/// has none, no file is left from an earlier run either. Poses that are not numbers or not newer
/// than the one before are left out. A pose whose quaternion is zero has no heading, and its line
/// keeps that; /ground_truth/point (geometry_msgs/PointStamped) says of which point of the robot
/// the poses are, and becomes the comment "# point of the robot: x y". The table of the log's own
/// stamps that an importer wrote beside the bag (BAG.stamps.csv) goes to stamps.csv.
/// @throw std::runtime_error naming the file that could not be read or written
GroundTruthCounts writeGroundTruth(const BagReader& bag, const std::string& folder);

/// Writes the poses that a bag's `odom` tells as wheel_odometry.tum, for runs whose odometry is
/// another, to compare with. Files and poses are left out as above. @throw as above
void writeWheelOdometry(const BagReader& bag, const std::string& folder);

}  // namespace slam_ros
