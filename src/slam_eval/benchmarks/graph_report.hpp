// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>

#include "ceres_batch.hpp"
#include "incremental_solve.hpp"
#include "pose_graph.hpp"

namespace slam::eval {

/// A graph, solved in steps and at once.
struct SolvedGraph {
  bool is_robust = false;  ///< any loop may be false; then there is no batch
  IncrementalResult steps;
  double memory_mb = 0.0;  ///< largest resident memory of the process up to the end of the steps
  BatchResult batch;       ///< from dead reckoning on
  BatchResult polished;    ///< from the result of the steps on
};

/// What the program prints: sizes, CPU times, chi2 of the steps and of Ceres, errors [m].
nlohmann::json summary(const PoseGraph& graph, const SolvedGraph& solved);

/// What a picture needs: poses, loops as [a, b, whether it is false], CPU time of each step [ms],
/// and true positions in the frame of the poses where they are known.
nlohmann::json details(const PoseGraph& graph, const SolvedGraph& solved);

}  // namespace slam::eval
