// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/base_controller.hpp"

#include "gaussian_vector.hpp"

namespace slam::sim {
namespace {

Eigen::Vector3d twistAt(const BasePath& path, double time) {
  constexpr double kStep = 0.002;  // [s]
  return path(time - kStep).between(path(time + kStep)).log() / (2.0 * kStep);
}

}  // namespace

Eigen::Vector3d commandFor(const BasePath& T_world_base, const CommandModel& model,
                           RandomStream& random) {
  const double interval = 1.0 / model.pace.rate;
  const Eigen::Vector3d mean = T_world_base(0.0).between(T_world_base(interval)).log() / interval;
  const Eigen::Vector3d change =
      (twistAt(T_world_base, interval) - twistAt(T_world_base, 0.0)) / interval;
  const Eigen::Vector3d scale(model.speed_scale, model.speed_scale, model.turn_scale);
  const Eigen::Vector3d error =
      Eigen::Vector3d::Ones() + model.relative_noise * gaussianVector(random);
  return (mean + model.time_constant * change).cwiseQuotient(scale).cwiseProduct(error);
}

}  // namespace slam::sim
