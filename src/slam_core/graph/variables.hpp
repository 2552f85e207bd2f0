// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/graph/quadratic_factor.hpp"

namespace slam::graph {

/// The variables of a graph: poses T_map_base and points [m] in the map frame.
///
/// A correction of a pose is a twist in the robot's frame, x <- x exp(delta). So a rigid motion of
/// a part of the path leaves the Jacobians within it as they are, and the solution of the normal
/// equations describes it without any error of linearisation. A correction of a point is added in
/// the map frame, so that Jacobians by points rotate with the map.
class Variables {
 public:
  /// Puts a pose at a key, which is a new one or that of a pose that was removed.
  void put(Key key, const Pose2& pose) { store(key, {pose, 3}); }
  void put(Key key, const Eigen::Vector2d& point) { store(key, {{point.x(), point.y(), 0.0}, 2}); }

  std::size_t size() const { return variables_.size(); }
  /// 3 for a pose, 2 for a point.
  int rows(Key key) const { return variables_[static_cast<std::size_t>(key)].rows; }
  /// A point is returned as a pose of which only the position is valid.
  const Pose2& pose(Key key) const { return variables_[static_cast<std::size_t>(key)].pose; }

  /// The variable after a correction.
  Pose2 corrected(Key key, const Eigen::Ref<const Eigen::VectorXd>& delta) const {
    const auto& variable = variables_[static_cast<std::size_t>(key)];
    if (variable.rows == 3) return variable.pose * Pose2::exp(delta);
    return {variable.pose.x() + delta.x(), variable.pose.y() + delta.y(), 0.0};
  }
  void set(Key key, const Pose2& value) { variables_[static_cast<std::size_t>(key)].pose = value; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(variables_);
  }

 private:
  struct Variable {
    Pose2 pose;  ///< of a point: its position
    int rows = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(pose, rows);
    }
  };
  void store(Key key, const Variable& variable) {
    const auto i = static_cast<std::size_t>(key);
    if (i >= variables_.size()) variables_.resize(i + 1);
    variables_[i] = variable;
  }

  std::vector<Variable> variables_;
};

}  // namespace slam::graph
