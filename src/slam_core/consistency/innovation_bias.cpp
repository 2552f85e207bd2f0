// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/innovation_bias.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace slam {
namespace {

/// The latest steps are judged in windows of this size, of twice this size and so on up to the
/// whole window: an error that has just begun shows in the latest steps only.
constexpr std::size_t kFewestSteps = 10;
constexpr double kMostCorrelated = 0.95;

using DirectionMatrix = Eigen::Matrix<double, Eigen::Dynamic, InnovationBias::kDirections>;

Eigen::Index columnOf(InnovationBias::Direction direction) {
  return static_cast<Eigen::Index>(direction);
}

/// The shift of the innovations by each kind of error, one column each; zero where it is not known.
DirectionMatrix directionsOf(const JointInnovation& group, const PosePrediction& prediction) {
  DirectionMatrix D = DirectionMatrix::Zero(group.nu.size(), InnovationBias::kDirections);
  for (Eigen::Index row = 0; row + 1 < D.rows(); row += 2) {
    D(row, columnOf(InnovationBias::kRange)) = 1.0;
    D(row + 1, columnOf(InnovationBias::kBearing)) = 1.0;
  }
  if (group.H.rows() == 0) return D;
  // F, the Jacobian of the composition with respect to the previous pose, contains the robot's
  // motion
  const Eigen::Vector3d along(prediction.F(1, 2), -prediction.F(0, 2), 0.0);
  const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
  D.col(columnOf(InnovationBias::kAlong)) = group.H * along;
  D.col(columnOf(InnovationBias::kAcross)) = group.H * across;
  return D;
}

struct Moments {
  double mean = 0.0, variance = 0.0;
  double correlation = 0.0;  ///< of a step with the next one
};

Moments momentsOf(const double* y, std::size_t size) {
  const auto n = static_cast<double>(size);
  Moments m;
  m.mean = std::accumulate(y, y + size, 0.0) / n;
  double products = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    m.variance += (y[i] - m.mean) * (y[i] - m.mean);
    if (i > 0) products += (y[i] - m.mean) * (y[i - 1] - m.mean);
  }
  if (m.variance > 0.0) m.correlation = products / m.variance;
  m.variance /= n - 1.0;
  // estimated from few steps, it is biased towards too small values (Kendall 1954)
  m.correlation = std::clamp(m.correlation + (1.0 + 3.0 * m.correlation) / n, 0.0, kMostCorrelated);
  return m;
}

/// The quantile of the normal distribution that corresponds to one of Student's t (Wallace 1959).
double normalQuantileOf(double t, double dof) {
  const double z = std::sqrt(dof * std::log1p(t * t / dof)) * (8.0 * dof + 1.0) / (8.0 * dof + 3.0);
  return std::copysign(z, t);
}

/// Correlated steps count for fewer independent ones, as in a first-order autoregressive process.
InnovationBias::Mean judged(const double* y, std::size_t size) {
  const auto m = momentsOf(y, size);
  const double independent =
      static_cast<double>(size) * (1.0 - m.correlation) / (1.0 + m.correlation);
  const double t = m.mean * std::sqrt(independent / std::max(1.0, m.variance));
  return {m.mean, normalQuantileOf(t, std::max(1.0, independent - 1.0)), static_cast<int>(size)};
}

const char* meaningOf(InnovationBias::Direction direction) {
  static constexpr const char* kMeanings[] = {
      "in range: the ranges may have an offset, as where the radius of landmarks is not set",
      "in bearing: the bearings may have an offset, or the odometry's turns a wrong scale",
      "along the way: ranges or the odometry's way may have a wrong scale",
      "across the way: the bearings may have an offset, or the robot slips sideways"};
  return kMeanings[direction];
}

}  // namespace

void InnovationBias::add(const JointInnovation& group, const PosePrediction& prediction) {
  const DirectionMatrix D = directionsOf(group, prediction);
  const auto S = group.S.llt();
  const DirectionMatrix S_inverse_D = S.solve(D);
  Step step;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double information = D.col(column).dot(S_inverse_D.col(column));
    if (information > 0.0) step[k] = S_inverse_D.col(column).dot(group.nu) / std::sqrt(information);
  }
  steps_.push_back(step);
  if (steps_.size() > window_) steps_.pop_front();
  for (std::size_t k = 0; k < kDirections; ++k) means_[k] = judge(static_cast<Direction>(k));
  worst_ = static_cast<Direction>(std::distance(
      means_.begin(), std::max_element(means_.begin(), means_.end(), [](auto& a, auto& b) {
        return std::abs(a.evidence) < std::abs(b.evidence);
      })));
}

InnovationBias::Mean InnovationBias::judge(Direction direction) const {
  std::vector<double> y;
  for (const auto& step : steps_)
    if (step[direction]) y.push_back(*step[direction]);
  Mean worst;
  for (std::size_t size = kFewestSteps; size <= y.size();
       size = size == y.size() ? size + 1 : std::min(2 * size, y.size())) {
    const auto mean = judged(y.data() + (y.size() - size), size);
    if (std::abs(mean.evidence) > std::abs(worst.evidence)) worst = mean;
  }
  return worst;
}

std::string InnovationBias::finding() const {
  return fmt::format("innovations are biased by {:.1f} standard deviations {} ({} updates)",
                     std::abs(mean().size), meaningOf(worst_), mean().steps);
}

}  // namespace slam
