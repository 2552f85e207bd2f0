// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/landmarks/fit_monitor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace slam::particle_filter {
namespace {

/// The weight of the observations so far, when the next one has come: about the last 20 matter.
constexpr double kMemory = 0.95;
/// As many degrees of freedom must have been seen before the monitor says anything.
constexpr double kEnough = 12.0;
/// When this many established landmarks in a row are off, they are no chance outliers.
constexpr int kAstray = 3;

/// The moments of the mixture of what several particles predicted.
struct Mixture {
  double weight = 0.0;
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Prediction& prediction, double w) {
    weight += w;
    nu += w * prediction.nu;
    second += w * (prediction.S + prediction.nu * prediction.nu.transpose());
  }
};

/// What the particles on the heavier side, of those that gate the observation and those that do
/// not, make of it together; nothing where most take it for no landmark of their map.
std::optional<ObservationInnovation> innovationOf(const LandmarkObservation& z,
                                                  const Prediction* prediction, std::size_t stride,
                                                  const std::vector<double>& weights) {
  Mixture fitting, gating;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto& of_particle = prediction[i * stride];
    if (of_particle.matched) (of_particle.gated ? gating : fitting).add(of_particle, weights[i]);
  }
  if (fitting.weight + gating.weight < 0.5) return std::nullopt;
  ObservationInnovation innovation;
  innovation.id = z.id;
  innovation.used = fitting.weight > gating.weight;
  const auto& mixture = innovation.used ? fitting : gating;
  innovation.nu = mixture.nu / mixture.weight;
  innovation.S = mixture.second / mixture.weight - innovation.nu * innovation.nu.transpose();
  innovation.R = z.covariance;
  return innovation;
}

/// Each innovation is given those before it, which makes them independent.
JointInnovation stacked(const std::vector<ObservationInnovation>& innovations) {
  std::vector<const ObservationInnovation*> used;
  for (const auto& innovation : innovations)
    if (innovation.used && used.size() < UpdateStatistics::kJoint) used.push_back(&innovation);
  const auto size = 2 * static_cast<Eigen::Index>(used.size());
  JointInnovation joint{Eigen::VectorXd(size),
                        Eigen::MatrixXd::Zero(size, size),
                        Eigen::MatrixXd::Zero(size, size),
                        {}};
  for (Eigen::Index row = 0; row < size; row += 2) {
    const auto& innovation = *used[static_cast<std::size_t>(row / 2)];
    joint.nu.segment<2>(row) = innovation.nu;
    joint.S.block<2, 2>(row, row) = innovation.S;
    joint.R.block<2, 2>(row, row) = innovation.R;
  }
  return joint;
}

/// Whether the landmark is established for most of the weight.
bool isEstablished(const Prediction* prediction, std::size_t stride,
                   const std::vector<double>& weights) {
  double established = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (prediction[i * stride].established) established += weights[i];
  return established > 0.5;
}

/// Bayes' rule for the weights, in place.
/// @return the logarithm of how likely the observation was
double condition(std::vector<double>& weights, const Prediction* prediction, std::size_t stride) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < weights.size(); ++i)
    largest = std::max(largest, prediction[i * stride].log_likelihood);
  if (!std::isfinite(largest)) return 0.0;  // nothing can be learned from it
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    sum += weights[i] *= std::exp(prediction[i * stride].log_likelihood - largest);
  if (!(sum > 0.0)) return 0.0;
  for (auto& weight : weights) weight /= sum;
  return largest + std::log(sum);
}

}  // namespace

std::vector<bool> FitMonitor::judge(const std::vector<Prediction>& predictions,
                                    const std::vector<LandmarkObservation>& seen,
                                    std::vector<double> weights, UpdateStatistics& statistics) {
  std::vector<bool> is_used(seen.size());
  Established established;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const auto* const prediction = predictions.data() + k;
    const auto innovation = innovationOf(seen[k], prediction, seen.size(), weights);
    const bool is_established = isEstablished(prediction, seen.size(), weights);
    const double log_likelihood = condition(weights, prediction, seen.size());
    if (!innovation) continue;
    statistics.log_likelihood += log_likelihood;
    statistics.innovations.push_back(*innovation);
    const double nis = count(*innovation, statistics);
    is_used[k] = innovation->used;
    if (!is_established) continue;
    ++established.seen;
    established.gated += !innovation->used;
    remember(std::min(nis, gate_));
  }
  statistics.joint = stacked(statistics.innovations);
  conclude(established);
  return is_used;
}

/// @return its normalised innovation squared; on the edge of the gate where it was gated
double FitMonitor::count(const ObservationInnovation& innovation,
                         UpdateStatistics& statistics) const {
  if (!innovation.used) {
    ++statistics.gated;
    return gate_;
  }
  const double nis = innovation.nu.dot(innovation.S.inverse() * innovation.nu);
  ++statistics.used;
  statistics.nis += nis;
  statistics.nis_dof += 2;
  return nis;
}

void FitMonitor::remember(double nis) {
  nis_ = kMemory * nis_ + nis;
  dof_ = kMemory * dof_ + 2.0;
}

void FitMonitor::conclude(const Established& established) {
  is_step_doubtful_ = 2 * established.gated > established.seen;
  if (is_step_doubtful_)
    gated_in_a_row_ = std::min(gated_in_a_row_ + established.gated, kAstray);
  else if (established.seen > 0)
    gated_in_a_row_ = 0;
}

bool FitMonitor::hasGoneAstray() const { return gated_in_a_row_ >= kAstray; }

bool FitMonitor::isLost() const {
  return hasGoneAstray() || (dof_ > kEnough && nis_ > lost_nis_ * dof_);
}

void FitMonitor::forget() {
  nis_ = dof_ = 0.0;
  is_step_doubtful_ = false;
  gated_in_a_row_ = 0;
}

}  // namespace slam::particle_filter
