// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace slam::ekf {

/// Rows that lie together in the update below, and in PanelTriangle.
constexpr Eigen::Index kPanelRows = 16;

/// P <- P - W W^T in the lower triangle of a column-major matrix: the one operation that costs the
/// square of the map. It is compiled for several instruction sets and chosen when the program runs;
/// all of them add in the same order and round alike, so the bits do not depend on the machine.
/// @param W `size` x k
/// @param P lower triangle of `size` rows, columns `stride` apart; the upper one is left alone
void subtractOuterProductLower(const Eigen::MatrixXd& W, double* P, Eigen::Index size,
                               Eigen::Index stride);

/// P <- P - A B^T, where that is symmetric, in a lower triangle cut into panels of kPanelRows rows.
/// @param A, B of the same size
/// @param rows of P to which those of A and B belong, rising; the others are left as they are
/// @param panels each column-major, kPanelRows high and complete up to the block on the diagonal
void subtractProductLower(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const std::vector<Eigen::Index>& rows,
                          const std::vector<double*>& panels);

/// A B^T, by the same means.
Eigen::MatrixXd timesTransposed(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                const Eigen::Ref<const Eigen::MatrixXd>& B);

/// W <- W L^-T for a lower triangle L.
void solveTransposedFromRight(const Eigen::Ref<const Eigen::MatrixXd>& L, Eigen::MatrixXd& W);

}  // namespace slam::ekf
