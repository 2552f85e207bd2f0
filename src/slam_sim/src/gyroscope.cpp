// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/gyroscope.hpp"

#include <cmath>

#include "gaussian_vector.hpp"

namespace slam::sim {

Eigen::Vector3d Gyroscope::measure(double turn_rate, RandomStream& random) {
  const double rate = imu_.pace.rate;
  const Eigen::Vector3d about_up = imu_.T_base_imu.linear().row(2) * turn_rate;
  bias_ += imu_.gyro_bias_random_walk / std::sqrt(rate) * gaussianVector(random);
  return imu_.gyro_scale * about_up + bias_ +
         imu_.gyro_noise * std::sqrt(rate) * gaussianVector(random);
}

double turnRate(const BasePath& T_world_base) {
  constexpr double kStep = 0.002;  // [s]
  return T_world_base(-kStep).between(T_world_base(kStep)).theta() / (2.0 * kStep);
}

}  // namespace slam::sim
