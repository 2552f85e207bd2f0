// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "horizontal_reading.hpp"

#include <cmath>

namespace slam::eval {

HorizontalReading toHorizontal(const Eigen::Matrix3d& level_sensor,
                               const Eigen::Vector3d& spherical,
                               const Eigen::Matrix3d& covariance) {
  const double r = spherical[0];
  const double cy = std::cos(spherical[1]), sy = std::sin(spherical[1]);
  const double cp = std::cos(spherical[2]), sp = std::sin(spherical[2]);
  const Eigen::Vector3d point = level_sensor * (r * Eigen::Vector3d(cp * cy, cp * sy, -sp));
  Eigen::Matrix3d J_point_spherical;
  J_point_spherical << cp * cy, -r * cp * sy, -r * sp * cy,  //
      cp * sy, r * cp * cy, -r * sp * sy,                    //
      -sp, 0.0, -r * cp;

  HorizontalReading reading;
  reading.range = std::hypot(point.x(), point.y());
  reading.bearing = std::atan2(point.y(), point.x());
  const double c = std::cos(reading.bearing), s = std::sin(reading.bearing);
  Eigen::Matrix<double, 2, 3> J_reading_point;
  J_reading_point << c, s, 0.0, -s / reading.range, c / reading.range, 0.0;
  const Eigen::Matrix<double, 2, 3> J = J_reading_point * level_sensor * J_point_spherical;
  reading.covariance = J * covariance * J.transpose();
  return reading;
}

}  // namespace slam::eval
