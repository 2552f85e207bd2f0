// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/camera/pose_fit.hpp"
#include "slam_core/mono_graph/features.hpp"

namespace slam::mono_graph {

/// A feature of an image and the one of a later image that was taken for it.
struct FeaturePair {
  std::size_t earlier = 0, later = 0;
};

/// The features of an image that a later one shows again.
struct FeaturePairs {
  std::vector<FeaturePair> pairs;
  std::size_t expected = 0;  ///< features that were to be seen again
};

/// Searches for the strongest features of an image where odometry and any depth from 1 m on predict
/// them in a later one; those that look clearly most alike are pairs.
/// @param odometry the pose of the later image in the frame of the earlier one
/// @param most features to search for
FeaturePairs pairFeatures(const Features& earlier, const Features& later, const PosePrior& odometry,
                          std::size_t most);

/// The motion between two images by what both show, without any map: the epipolar constraint
/// (Hartley and Zisserman 2004, 9.2) of a camera that moves on the plane tells the heading. Of the
/// headings that odometry allows, each with the position that goes with it, the one counts that
/// most pairs agree on (as in Scaramuzza 2011).
/// @param odometry the pose of the later image in the frame of the earlier one
/// @return that pose and what is left of odometry's covariance; nothing where the robot stands,
/// where too few pairs agree, or where odometry knows the heading to a pixel
std::optional<PosePrior> motionBetween(const Features& earlier, const Features& later,
                                       const PosePrior& odometry);

}  // namespace slam::mono_graph
