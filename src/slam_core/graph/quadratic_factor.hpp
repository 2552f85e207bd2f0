// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace slam::graph {

/// The number of a variable of a graph, counted from 0.
using Key = std::int32_t;
/// The number of a factor of a graph, counted from 0.
using FactorId = std::int32_t;

/// A quadratic of some variables: 1/2 x^T H x - g^T x, rows in the order of the keys.
struct QuadraticFactor {
  std::vector<Key> keys;
  Eigen::MatrixXd H;
  Eigen::VectorXd g;

  template <class Archive>
  void persist(Archive& archive) {
    archive(keys, H, g);
  }
};

}  // namespace slam::graph
