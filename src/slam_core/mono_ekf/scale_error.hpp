// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace slam::mono_ekf {

class MonoState;

/// The error of the map's scale (MapStep::s) as a linear function of the state's errors: the mean
/// of the relative errors of the distances of some features, weighted by the inverse of their
/// variances. Each weighted mean gives the same for an error of the scale alone, so that the
/// choice does not matter to what images cannot show.
class ScaleError {
 public:
  /// @param offsets of the features that an image measures, in the state
  ScaleError(const MonoState& state, const std::vector<int>& offsets);

  /// The error of the scale if the state has these errors.
  double of(const Eigen::VectorXd& errors) const;
  /// The products of matrices with the gradient of this function.
  Eigen::VectorXd columnsOf(const Eigen::MatrixXd& matrix) const;
  Eigen::RowVectorXd rowsOf(const Eigen::MatrixXd& matrix) const;

 private:
  std::vector<std::pair<int, double>> gradient_;  ///< a coordinate, and how much it counts
};

}  // namespace slam::mono_ekf
