// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/fit_monitor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace slam::particle_filter {
namespace {

/// What an observation counts for when the next one has come: about the last 20 matter.
constexpr double kMemory = 0.95;
/// Degrees of freedom seen before anything is said.
constexpr double kEnough = 12.0;

/// The moments of the mixture of what those particles that do not gate an observation foresaw.
struct Mixture {
  double weight = 0.0, gated_weight = 0.0;
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Prediction& prediction, double w) {
    if (prediction.gated) {
      gated_weight += w;
      return;
    }
    weight += w;
    nu += w * prediction.nu;
    second += w * (prediction.S + prediction.nu * prediction.nu.transpose());
  }
  bool isGated() const { return !(weight > gated_weight); }
  double nis() const {
    const Eigen::Vector2d mean = nu / weight;
    const Eigen::Matrix2d S = second / weight - mean * mean.transpose();
    return mean.dot(S.inverse() * mean);
  }
};

/// Bayes' rule for the weights, in place.
void condition(std::vector<double>& weights, const Prediction* prediction, std::size_t stride) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < weights.size(); ++i)
    largest = std::max(largest, prediction[i * stride].log_likelihood);
  if (!std::isfinite(largest)) return;  // nothing can be learned from it
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    sum += weights[i] *= std::exp(prediction[i * stride].log_likelihood - largest);
  if (sum > 0.0)
    for (auto& weight : weights) weight /= sum;
}

}  // namespace

void FitMonitor::judge(const std::vector<Prediction>& predictions, std::size_t matches, double gate,
                       std::vector<double> weights, UpdateStatistics& statistics) {
  for (std::size_t k = 0; k < matches; ++k) {
    Mixture mixture;
    for (std::size_t i = 0; i < weights.size(); ++i)
      mixture.add(predictions[i * matches + k], weights[i]);
    condition(weights, predictions.data() + k, matches);
    double nis = gate;
    if (mixture.isGated()) {
      ++statistics.gated;
    } else {
      nis = mixture.nis();
      ++statistics.used;
      statistics.nis += nis;
      statistics.nis_dof += 2;
    }
    nis_ = kMemory * nis_ + std::min(nis, gate);
    dof_ = kMemory * dof_ + 2.0;
  }
}

bool FitMonitor::isLost() const { return dof_ > kEnough && nis_ > lost_nis_ * dof_; }

}  // namespace slam::particle_filter
