// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ceres_batch.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>

#include "cpu_time.hpp"

namespace slam::eval {
namespace {

/// r = W z^-1 a^-1 b as (x, y, theta), theta wrapped.
class PoseEdgeError {
 public:
  explicit PoseEdgeError(const PoseEdge& edge)
      : z_(edge.z.vector()), W_(edge.information.llt().matrixU()) {}

  template <class T>
  bool operator()(const T* a, const T* b, T* r) const {
    const T c = cos(a[2]), s = sin(a[2]), x = b[0] - a[0], y = b[1] - a[1];
    const T along = c * x + s * y - z_.x(), across = c * y - s * x - z_.y();
    const double c_z = std::cos(z_.z()), s_z = std::sin(z_.z());
    const T turn = b[2] - a[2] - z_.z();
    const Eigen::Matrix<T, 3, 1> e(c_z * along + s_z * across, c_z * across - s_z * along,
                                   atan2(sin(turn), cos(turn)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> residual(r);
    residual = W_.cast<T>() * e;
    return true;
  }

 private:
  Eigen::Vector3d z_;
  Eigen::Matrix3d W_;
};

using Blocks = std::vector<std::array<double, 3>>;  // a pose each

ceres::Solver::Options solverOptions() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-9;
  options.logging_type = ceres::SILENT;
  return options;
}

ceres::Solver::Summary solve(const PoseGraph& graph, Blocks& blocks) {
  using Cost = ceres::AutoDiffCostFunction<PoseEdgeError, 3, 3, 3>;
  ceres::Problem problem;
  for (const auto& edge : graph.edges)
    problem.AddResidualBlock(new Cost(new PoseEdgeError(edge)), nullptr,
                             blocks[static_cast<std::size_t>(edge.a)].data(),
                             blocks[static_cast<std::size_t>(edge.b)].data());
  problem.SetParameterBlockConstant(blocks.front().data());
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions(), &problem, &summary);
  return summary;
}

}  // namespace

BatchResult solveByCeres(const PoseGraph& graph, const std::vector<Pose2>& start) {
  const double begin = cpuMilliseconds();
  Blocks blocks;
  for (const auto& pose : start) blocks.push_back({pose.x(), pose.y(), pose.theta()});
  const auto summary = solve(graph, blocks);
  BatchResult result;
  for (const auto& block : blocks) result.poses.emplace_back(block[0], block[1], block[2]);
  result.cpu_s = 1e-3 * (cpuMilliseconds() - begin);
  result.chi2 = chi2(graph, result.poses);
  result.iterations = static_cast<int>(summary.iterations.size());
  result.has_converged = summary.termination_type == ceres::CONVERGENCE;
  return result;
}

}  // namespace slam::eval
