// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include "slam_core/graph/quadratic_factor.hpp"

namespace slam::graph {

/// Tells which variables are near those that the next factors will touch. The near ones are
/// eliminated late, so that the next factors change few cliques; the far ones are eliminated first.
struct Vicinity {
  std::vector<Key> gathered;  ///< these are eliminated again even if none of them has changed
  /// A variable of a larger shell is eliminated before those of smaller ones, which are counted
  /// from 0. Without this all are in one shell.
  std::function<int(Key)> shell;
};

}  // namespace slam::graph
