// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace slam::ekf {

/// A symmetric matrix of which only the lower triangle is kept, cut into panels of 16 rows of which
/// each has its own memory: half of a full matrix, and growing copies nothing.
class PanelTriangle {
 public:
  PanelTriangle() = default;
  /// From a full symmetric matrix.
  explicit PanelTriangle(const Eigen::MatrixXd& full);

  Eigen::Index size() const { return size_; }
  /// New elements are 0.
  void grow(Eigen::Index size);

  /// Row and column in any order.
  double operator()(Eigen::Index row, Eigen::Index column) const {
    return row >= column ? at(row, column) : at(column, row);
  }
  /// The element in the lower triangle, row >= column.
  double& at(Eigen::Index row, Eigen::Index column) {
    return panels_[static_cast<std::size_t>(row / kRows)]
                  [static_cast<std::size_t>(column * kRows + row % kRows)];
  }
  double at(Eigen::Index row, Eigen::Index column) const {
    return const_cast<PanelTriangle*>(this)->at(row, column);
  }
  Eigen::MatrixXd full() const;

  /// P <- P - A B^T, where that product is symmetric, in the given rows and columns, rising.
  void subtractProduct(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                       const std::vector<Eigen::Index>& rows);

  template <class Archive>
  void persist(Archive& archive) {
    archive(panels_, size_);
  }

 private:
  static constexpr Eigen::Index kRows = 16;

  std::vector<std::vector<double>> panels_;  ///< each column-major, up to its diagonal block
  Eigen::Index size_ = 0;
};

}  // namespace slam::ekf
