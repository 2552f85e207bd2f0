// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include "slam_core/graph/factor.hpp"

namespace slam::graph {

/// What a piece of the way says of the map: a Gaussian over some poses and points, as they lie in
/// the frame of a pose on that way, the base.
struct LocalMap {
  std::vector<Pose2> poses;             ///< T_base_pose
  std::vector<Eigen::Vector2d> points;  ///< in the base's frame [m]
  /// of the poses' errors (x, y, theta), each in its own frame, then of the points
  Eigen::MatrixXd covariance;

  template <class Archive>
  void persist(Archive& archive) {
    archive(poses, points, covariance);
  }
};

/// The same without some of its points: the marginal of the others.
/// @param keeps by point
LocalMap marginal(const LocalMap& map, const std::vector<bool>& keeps);

/// A local map whose base is a variable: r = W e, where e has the errors of the poses and points in
/// the base's frame.
class BasedMap final : public Factor {
 public:
  /// @param keys of the base, the poses and the points
  BasedMap(std::vector<Key> keys, LocalMap map);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  /// The same by the base alone. @param others the poses and points
  LinearFactor byBase(const Pose2& base, const std::vector<Pose2>& others) const;
  const LocalMap& map() const { return map_; }

 private:
  struct Errors {
    Eigen::VectorXd e;
    Eigen::MatrixX3d J_base;
  };
  Errors errors(const Pose2& base, const Pose2* at) const;

  LocalMap map_;
  Eigen::MatrixXd W_;
};

/// A local map whose base nothing else is known of: it is marginalised. What is left says how the
/// points, and the poses if any, lie relative to one another, and is the same wherever in the map
/// that is. The base is where it fits best, so that the residual is what no base explains (variable
/// projection: Golub, Pereyra 1973).
class FreeMap final : public Factor {
 public:
  /// @param keys of the poses and the points, which are two at least where there is no pose
  FreeMap(std::vector<Key> keys, LocalMap map);
  LinearFactor linearized(const std::vector<Pose2>& at) const override;
  /// For a map without poses this returns the longest way that a point has moved relative to the
  /// middle of all points, divided by the map's radius [1]. If the points have turned together,
  /// that is the angle by which the Jacobian turns. If they have moved together, it is 0, since
  /// neither residual nor Jacobian has changed. A radius below 1 m counts as 1 m, so that
  /// millimetres do not count, and one above 30 m as 30 m, since the same angle leaves an error
  /// that grows with the radius.
  double moved(const std::vector<Pose2>& then, const std::vector<Pose2>& now) const override;
  const LocalMap& map() const { return based_.map(); }
  /// @return the pose of the base at which the map fits best
  Pose2 base(const std::vector<Pose2>& at) const;

 private:
  Pose2 firstBase(const std::vector<Pose2>& at) const;

  BasedMap based_;  ///< its base has no key
};

}  // namespace slam::graph
