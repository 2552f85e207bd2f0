// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "pose_graph.hpp"

namespace slam::eval {

struct BatchResult {
  std::vector<Pose2> poses;
  double chi2 = 0.0;
  double cpu_s = 0.0;
  int iterations = 0;
  bool has_converged = false;
};

/// Solves a graph at once by Ceres (Agarwal, Mierle et al.), another program than ours: automatic
/// derivatives, sparse Cholesky factors, Levenberg-Marquardt, one thread. The first pose stays
/// where it is.
/// @param start of the poses
BatchResult solveByCeres(const PoseGraph& graph, const std::vector<Pose2>& start);

}  // namespace slam::eval
