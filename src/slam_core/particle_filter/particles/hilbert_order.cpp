// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/hilbert_order.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "slam_core/geometry/angle.hpp"

namespace slam::particle_filter {
namespace {

constexpr unsigned kBits = 10;  // 1024 cells along each axis
constexpr double kReach = 4.0;  // [standard deviations] that the cells cover

std::uint32_t cellOf(double deviation) {
  const double cells = static_cast<double>(1u << kBits);
  const double cell = (deviation + kReach) / (2.0 * kReach) * cells;
  if (!(cell > 0.0)) return 0;  // also where it is no number
  return static_cast<std::uint32_t>(std::min(cell, cells - 1.0));
}

}  // namespace

std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned bits) {
  std::array<std::uint32_t, 3> axes{x, y, z};
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1) {  // undo the curve's turns
    for (auto& axis : axes) {
      const std::uint32_t low = q - 1;
      if ((axis & q) != 0) {
        axes[0] ^= low;
      } else {
        const std::uint32_t exchanged = (axes[0] ^ axis) & low;
        axes[0] ^= exchanged;
        axis ^= exchanged;
      }
    }
  }
  axes[1] ^= axes[0];  // Gray code
  axes[2] ^= axes[1];
  std::uint32_t flips = 0;
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
    if ((axes[2] & q) != 0) flips ^= q - 1;
  std::uint64_t index = 0;
  for (unsigned bit = bits; bit-- > 0;)
    for (const auto axis : axes) index = index << 1 | ((axis ^ flips) >> bit & 1u);
  return index;
}

std::vector<std::uint32_t> hilbertOrder(const std::vector<Pose2>& poses,
                                        const PoseEstimate& estimate) {
  const Eigen::LLT<Eigen::Matrix3d> L(estimate.covariance);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(poses.size());
  for (const auto& pose : poses) {
    Eigen::Vector3d d = pose.vector() - estimate.pose.vector();
    d.z() = wrapAngle(d.z());
    L.matrixL().solveInPlace(d);
    const auto key = hilbertIndex(cellOf(d.x()), cellOf(d.y()), cellOf(d.z()), kBits);
    keys.emplace_back(key, static_cast<std::uint32_t>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace slam::particle_filter
