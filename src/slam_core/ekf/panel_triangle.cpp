// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/panel_triangle.hpp"

#include "slam_core/ekf/symmetric_update.hpp"

namespace slam::ekf {

PanelTriangle::PanelTriangle(const Eigen::MatrixXd& full) {
  static_assert(kRows == kPanelRows);
  grow(full.rows());
  for (Eigen::Index column = 0; column < size_; ++column)
    for (Eigen::Index row = column; row < size_; ++row) at(row, column) = full(row, column);
}

void PanelTriangle::grow(Eigen::Index size) {
  while (static_cast<Eigen::Index>(panels_.size()) * kRows < size)
    panels_.emplace_back((panels_.size() + 1) * static_cast<std::size_t>(kRows * kRows), 0.0);
  size_ = size;
}

Eigen::MatrixXd PanelTriangle::full() const {
  Eigen::MatrixXd full(size_, size_);
  for (Eigen::Index column = 0; column < size_; ++column)
    for (Eigen::Index row = column; row < size_; ++row)
      full(row, column) = full(column, row) = at(row, column);
  return full;
}

void PanelTriangle::subtractProduct(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                    const std::vector<Eigen::Index>& rows) {
  std::vector<double*> panels;
  for (auto& panel : panels_) panels.push_back(panel.data());
  subtractProductLower(A, B, rows, panels);
}

}  // namespace slam::ekf
