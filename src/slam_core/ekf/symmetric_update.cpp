// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/symmetric_update.hpp"

#include <algorithm>
#include <vector>

namespace slam::ekf {
namespace {

using Index = Eigen::Index;

constexpr Index kPanel = kPanelRows;  ///< rows of W that are packed together
constexpr Index kGroup = 4;           ///< columns of P whose sums stay in registers

/// C <- C - A B^T. A and B point into packed panels, kPanel doubles for each of the k columns of W;
/// C is kPanel x kGroup, column-major, its columns `stride` apart.
using BlockUpdate = void (*)(const double* A, const double* B, Index k, double* C, Index stride);

/// Vector registers of three sizes; memory need not be aligned.
struct Register128 {
  typedef double Lanes __attribute__((vector_size(16), aligned(8)));
};
struct Register256 {
  typedef double Lanes __attribute__((vector_size(32), aligned(8)));
};
struct Register512 {
  typedef double Lanes __attribute__((vector_size(64), aligned(8)));
};

/// Two registers of rows times kGroup columns are summed at a time.
template <class Register>
[[gnu::always_inline]] inline void subtractBlock(const double* A, const double* B, Index k,
                                                 double* C, Index stride) {
  using Lanes = typename Register::Lanes;
  constexpr Index kLanes = sizeof(Lanes) / sizeof(double);
  for (Index row = 0; row < kPanel; row += 2 * kLanes) {
    Lanes sum[kGroup][2] = {};
    for (Index i = 0; i < k; ++i) {
      const Lanes* a = reinterpret_cast<const Lanes*>(A + i * kPanel + row);
      for (Index column = 0; column < kGroup; ++column) {
        sum[column][0] += a[0] * B[i * kPanel + column];
        sum[column][1] += a[1] * B[i * kPanel + column];
      }
    }
    for (Index column = 0; column < kGroup; ++column) {
      Lanes* c = reinterpret_cast<Lanes*>(C + column * stride + row);
      c[0] -= sum[column][0];
      c[1] -= sum[column][1];
    }
  }
}

#ifdef __x86_64__
[[gnu::target("avx512f")]] void subtractBlock512(const double* A, const double* B, Index k,
                                                 double* C, Index stride) {
  subtractBlock<Register512>(A, B, k, C, stride);
}
[[gnu::target("avx2")]] void subtractBlock256(const double* A, const double* B, Index k, double* C,
                                              Index stride) {
  subtractBlock<Register256>(A, B, k, C, stride);
}
#endif
void subtractBlock128(const double* A, const double* B, Index k, double* C, Index stride) {
  subtractBlock<Register128>(A, B, k, C, stride);
}

BlockUpdate fastestBlockUpdate() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return subtractBlock512;
  if (__builtin_cpu_supports("avx2")) return subtractBlock256;
#endif
  return subtractBlock128;
}

/// W cut into panels of kPanel rows, each contiguous, the last one filled up with zeros.
std::vector<double> packPanels(const Eigen::Ref<const Eigen::MatrixXd>& W) {
  const Index size = W.rows(), panels = (size + kPanel - 1) / kPanel, k = W.cols();
  std::vector<double> packed(static_cast<std::size_t>(panels * k * kPanel), 0.0);
  for (Index panel = 0; panel < panels; ++panel) {
    const Index row = panel * kPanel, rows = std::min(kPanel, size - row);
    double* out = packed.data() + panel * k * kPanel;
    for (Index column = 0; column < k; ++column, out += kPanel)
      std::copy_n(W.data() + column * W.outerStride() + row, rows, out);
  }
  return packed;
}

/// The same of a matrix of which only the given rows are not 0.
std::vector<double> packPanels(const Eigen::Ref<const Eigen::MatrixXd>& W,
                               const std::vector<Index>& rows, std::size_t panels) {
  const Index k = W.cols();
  std::vector<double> packed(panels * static_cast<std::size_t>(k * kPanel), 0.0);
  for (Index column = 0; column < k; ++column)
    for (Index i = 0; i < W.rows(); ++i) {
      const Index row = rows[static_cast<std::size_t>(i)];
      packed[static_cast<std::size_t>((row / kPanel * k + column) * kPanel + row % kPanel)] =
          W(i, column);
    }
  return packed;
}

/// So many columns of A and B at a time, for two panels of them to stay in the fastest cache.
constexpr Index kDepth = 96;

}  // namespace

void subtractProductLower(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const std::vector<Index>& rows, const std::vector<double*>& panels) {
  static const BlockUpdate subtract = fastestBlockUpdate();
  for (Index first = 0; first < A.cols(); first += kDepth) {
    const Index k = std::min(kDepth, A.cols() - first);
    const auto packed_A = packPanels(A.middleCols(first, k), rows, panels.size());
    const auto packed_B = packPanels(B.middleCols(first, k), rows, panels.size());
    for (std::size_t panel = 0; panel < panels.size(); ++panel) {
      const Index columns = static_cast<Index>(panel + 1) * kPanel;
      const double* a = packed_A.data() + static_cast<Index>(panel) * k * kPanel;
      for (Index column = 0; column < columns; column += kGroup)
        subtract(a, packed_B.data() + column / kPanel * k * kPanel + column % kPanel, k,
                 panels[panel] + column * kPanel, kPanel);
    }
  }
}

Eigen::MatrixXd timesTransposed(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                const Eigen::Ref<const Eigen::MatrixXd>& B) {
  static const BlockUpdate subtract = fastestBlockUpdate();
  const Index k = A.cols(), panels = (B.rows() + kPanel - 1) / kPanel;
  const auto packed_A = packPanels(A), packed_B = packPanels(B);
  Eigen::MatrixXd product(A.rows(), B.rows());
  std::vector<double> negative(static_cast<std::size_t>(panels * kPanel * kPanel));
  for (Index row = 0; row < A.rows(); row += kPanel) {
    std::fill(negative.begin(), negative.end(), 0.0);
    for (Index column = 0; column < panels * kPanel; column += kGroup)
      subtract(packed_A.data() + row * k,
               packed_B.data() + column / kPanel * k * kPanel + column % kPanel, k,
               negative.data() + column * kPanel, kPanel);
    const Index rows = std::min(kPanel, A.rows() - row);
    for (Index column = 0; column < B.rows(); ++column)
      for (Index r = 0; r < rows; ++r)
        product(row + r, column) = -negative[static_cast<std::size_t>(column * kPanel + r)];
  }
  return product;
}

void solveTransposedFromRight(const Eigen::Ref<const Eigen::MatrixXd>& L, Eigen::MatrixXd& W) {
  constexpr Index kBlock = 32;
  for (Index first = 0; first < L.rows(); first += kBlock) {
    const Index size = std::min(kBlock, L.rows() - first);
    auto columns = W.middleCols(first, size);
    if (first > 0) columns -= timesTransposed(W.leftCols(first), L.block(first, 0, size, first));
    L.block(first, first, size, size)
        .triangularView<Eigen::Lower>()
        .transpose()
        .solveInPlace<Eigen::OnTheRight>(columns);
  }
}

void subtractOuterProductLower(const Eigen::MatrixXd& W, double* P, Index size, Index stride) {
  static const BlockUpdate subtract = fastestBlockUpdate();
  const Index k = W.cols();
  const auto packed = packPanels(W);
  const auto panelOf = [&](Index row) { return packed.data() + row / kPanel * k * kPanel; };
  for (Index column = 0; column < size; column += kGroup) {
    const double* B = panelOf(column) + column % kPanel;
    for (Index row = column / kPanel * kPanel; row < size; row += kPanel) {
      const bool inside = row > column && row + kPanel <= size && column + kGroup <= size;
      if (inside) {
        subtract(panelOf(row), B, k, P + column * stride + row, stride);
        continue;
      }
      // Over the diagonal or the end only what lies in the lower triangle is written.
      double C[kPanel * kGroup] = {};
      subtract(panelOf(row), B, k, C, kPanel);
      for (Index c = column; c < std::min(column + kGroup, size); ++c)
        for (Index r = std::max(row, c); r < std::min(row + kPanel, size); ++r)
          P[c * stride + r] += C[(c - column) * kPanel + r - row];
    }
  }
}

}  // namespace slam::ekf
