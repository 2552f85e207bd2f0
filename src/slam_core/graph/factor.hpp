// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/graph/variables.hpp"

namespace slam::graph {

/// The whitened residual r of a factor, where r^T r is its share of chi2, and its Jacobian J by
/// corrections of the variables (Variables), with columns in the order of the keys.
struct LinearFactor {
  Eigen::VectorXd r;
  Eigen::MatrixXd J;
};

/// What a measurement says about some variables.
class Factor {
 public:
  explicit Factor(std::vector<Key> keys) : keys_(std::move(keys)) {}
  virtual ~Factor() = default;

  const std::vector<Key>& keys() const { return keys_; }
  /// @param at its variables, in the order of the keys
  virtual LinearFactor linearized(const std::vector<Pose2>& at) const = 0;
  /// Measures how wrong its linearisation has become, now that its variables are elsewhere: in
  /// general the largest change of a coordinate [m, rad]; a factor may have a measure of its own.
  /// @param then, now its variables, in the order of the keys
  virtual double moved(const std::vector<Pose2>& then, const std::vector<Pose2>& now) const {
    double most = 0.0;
    for (std::size_t i = 0; i < then.size(); ++i) {
      most = std::max(most, (now[i].position() - then[i].position()).cwiseAbs().maxCoeff());
      most = std::max(most, std::abs(wrapAngle(now[i].theta() - then[i].theta())));
    }
    return most;
  }

 private:
  std::vector<Key> keys_;
};

}  // namespace slam::graph
