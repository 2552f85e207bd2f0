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
std::vector<double> packPanels(const Eigen::MatrixXd& W, Index size) {
  const Index panels = (size + kPanel - 1) / kPanel, k = W.cols();
  std::vector<double> packed(static_cast<std::size_t>(panels * k * kPanel), 0.0);
  for (Index panel = 0; panel < panels; ++panel) {
    const Index row = panel * kPanel, rows = std::min(kPanel, size - row);
    double* out = packed.data() + panel * k * kPanel;
    for (Index column = 0; column < k; ++column, out += kPanel)
      std::copy_n(W.data() + column * W.outerStride() + row, rows, out);
  }
  return packed;
}

/// So many columns of A and B at a time, for two panels of them to stay in the fastest cache.
constexpr Index kDepth = 96;

void subtractSlice(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                   const std::vector<double*>& panels) {
  static const BlockUpdate subtract = fastestBlockUpdate();
  const Index size = A.rows(), k = A.cols();
  const auto packed_A = packPanels(A, size), packed_B = packPanels(B, size);
  for (Index panel = 0; panel < static_cast<Index>(panels.size()); ++panel) {
    const double* a = packed_A.data() + panel * k * kPanel;
    double* P = panels[static_cast<std::size_t>(panel)];
    for (Index column = 0; column < (panel + 1) * kPanel; column += kGroup)
      subtract(a, packed_B.data() + column / kPanel * k * kPanel + column % kPanel, k,
               P + column * kPanel, kPanel);
  }
}

}  // namespace

void subtractProductLower(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const std::vector<double*>& panels) {
  for (Index first = 0; first < A.cols(); first += kDepth) {
    const Index depth = std::min(kDepth, A.cols() - first);
    subtractSlice(A.middleCols(first, depth), B.middleCols(first, depth), panels);
  }
}

void subtractOuterProductLower(const Eigen::MatrixXd& W, double* P, Index size, Index stride) {
  static const BlockUpdate subtract = fastestBlockUpdate();
  const Index k = W.cols();
  const auto packed = packPanels(W, size);
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
