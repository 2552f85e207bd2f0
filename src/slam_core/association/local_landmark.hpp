// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::association {

/// A landmark as the robot has seen it lately, whatever map it belongs to.
struct LocalLandmark {
  LandmarkId id = kUnknownId;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    ///< in the robot's frame [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the position [m^2]
  Descriptor descriptor = {};                            ///< empty where nothing is known

  template <class Archive>
  void persist(Archive& archive) {
    archive(id, position, covariance, descriptor);
  }
};

}  // namespace slam::association
