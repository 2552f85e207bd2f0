// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <map>

#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::test {

/// EKF-SLAM as the textbook has it (Thrun, Burgard, Fox 2005, table 10.1): full matrices, full
/// Jacobians, all formulas written out. Slow, and sharing no code with what it checks.
class ReferenceEkf {
 public:
  explicit ReferenceEkf(const Eigen::Matrix3d& P0) : x(Eigen::Vector3d::Zero()), P(P0) {}

  void predict(const Motion& motion) {
    const double c = std::cos(x(2)), s = std::sin(x(2));
    const double ux = motion.increment.x(), uy = motion.increment.y();
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(x.size(), x.size());
    F(0, 2) = -s * ux - c * uy;
    F(1, 2) = c * ux - s * uy;
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(x.size(), 3);
    G.topRows<3>() << c, -s, 0, s, c, 0, 0, 0, 1;
    x(0) += c * ux - s * uy;
    x(1) += s * ux + c * uy;
    x(2) += motion.increment.theta();
    P = F * P * F.transpose() + G * motion.covariance * G.transpose();
  }

  void update(const LandmarkObservationArray& array) {
    std::vector<LandmarkObservation> known;
    for (const auto& z : array.observations)
      if (row.count(z.id) > 0) known.push_back(z);
    if (!known.empty()) updateKnown(known, array.sensor_pose);
    for (const auto& z : array.observations)
      if (row.count(z.id) == 0) append(z, array.sensor_pose);
  }

  Eigen::VectorXd x;
  Eigen::MatrixXd P;
  std::map<LandmarkId, Eigen::Index> row;
  double nis = 0.0;

 private:
  Eigen::Vector2d sensorPosition(const Pose2& sensor) const {
    const double c = std::cos(x(2)), s = std::sin(x(2));
    return {x(0) + c * sensor.x() - s * sensor.y(), x(1) + s * sensor.x() + c * sensor.y()};
  }

  void updateKnown(const std::vector<LandmarkObservation>& known, const Pose2& sensor) {
    const auto size = 2 * Eigen::Index(known.size());
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, x.size());
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd nu(size);
    const Eigen::Vector2d p = sensorPosition(sensor);
    for (Eigen::Index i = 0; i < size; i += 2) {
      const auto& z = known[std::size_t(i / 2)];
      const auto m = row.at(z.id);
      const double dx = x(m) - p.x(), dy = x(m + 1) - p.y(), q = dx * dx + dy * dy,
                   r = std::sqrt(q);
      const double lever_x = -(p.y() - x(1)),
                   lever_y = p.x() - x(0);  // of the sensor about the base
      H(i, 0) = -dx / r;
      H(i, 1) = -dy / r;
      H(i, 2) = -(dx * lever_x + dy * lever_y) / r;
      H(i + 1, 0) = dy / q;
      H(i + 1, 1) = -dx / q;
      H(i + 1, 2) = (dy * lever_x - dx * lever_y) / q - 1;
      H.block<2, 2>(i, m) << dx / r, dy / r, -dy / q, dx / q;
      R.block<2, 2>(i, i) = z.covariance;
      const double bearing = std::atan2(dy, dx) - x(2) - sensor.theta();
      nu(i) = z.range - r;
      nu(i + 1) = std::remainder(z.bearing - bearing, 2 * M_PI);
    }
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
    nis = nu.dot(S.inverse() * nu);
    x += K * nu;
    P = ((Eigen::MatrixXd::Identity(x.size(), x.size()) - K * H) * P).eval();
  }

  void append(const LandmarkObservation& z, const Pose2& sensor) {
    const auto n = x.size();
    const double angle = x(2) + sensor.theta() + z.bearing;
    const double c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector2d m = sensorPosition(sensor) + z.range * Eigen::Vector2d(c, s);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n + 2, n + 2);  // of (x, z) -> (x, m)
    J.topLeftCorner(n, n).setIdentity();
    J.block<2, 3>(n, 0) << 1, 0, -(m.y() - x(1)), 0, 1, m.x() - x(0);
    J.bottomRightCorner<2, 2>() << c, -z.range * s, s, z.range * c;
    Eigen::MatrixXd joint = Eigen::MatrixXd::Zero(n + 2, n + 2);
    joint.topLeftCorner(n, n) = P;
    joint.bottomRightCorner<2, 2>() = z.covariance;
    P = J * joint * J.transpose();
    x.conservativeResize(n + 2);
    x.tail<2>() = m;
    row[z.id] = n;
  }
};

}  // namespace slam::test
