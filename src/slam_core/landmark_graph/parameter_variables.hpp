// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/graph/calibrated_factors.hpp"
#include "slam_core/graph/optimizer.hpp"
#include "slam_core/models/calibration.hpp"

namespace slam::landmark_graph {

/// The parameters of wheels and landmark sensor as variables of a graph, two of them in the place
/// of a point. They are eliminated last, since nearly all factors depend on them: so they are in
/// the root of the tree, and a step costs what it costs without them but for the rows that each
/// clique has more.
class ParameterVariables {
 public:
  /// Adds them to a graph, with what is known of them. Of those in `prior` only range_scale and
  /// time_offset may have no variance; without a variance of range_scale both are left out.
  ParameterVariables(graph::Optimizer& graph, const CalibrationEstimate& prior);
  ParameterVariables() = default;  ///< to be read from an archive

  const std::vector<graph::Key>& keys() const { return keys_; }
  /// @return the number of their rows in a covariance
  Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(keys_.size()); }
  std::vector<graph::Key> ofWheels() const { return {keys_[0], keys_[1]}; }
  std::vector<graph::Key> ofSensor() const { return {keys_.begin() + 1, keys_.end()}; }
  /// The row of a parameter in a covariance of keys(); -1 where it is none of them.
  Eigen::Index row(CalibrationParameter parameter) const;

  CalibrationVector values(const graph::Optimizer& graph) const;
  CalibrationEstimate estimate(const graph::Optimizer& graph) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(keys_);
  }

 private:
  std::vector<graph::Key> keys_;  ///< in the order of their pairs (parameter_variables.cpp)
};

/// The parameters on which a sighting depends.
graph::CalibratedSighting::At sensorPart(const CalibrationVector& parameters);

}  // namespace slam::landmark_graph
