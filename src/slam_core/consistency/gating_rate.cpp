// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/gating_rate.hpp"

#include <algorithm>
#include <cmath>

namespace slam {
namespace {

/// The probability that at least so many of the trials succeed.
double binomialTail(int trials, int successes, double probability) {
  if (probability >= 1.0) return 1.0;
  double sum = 0.0;
  for (int k = successes; k <= trials; ++k) {
    const double combinations =
        std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0);
    sum += std::exp(combinations + k * std::log(probability) +
                    (trials - k) * std::log1p(-probability));
  }
  return sum;
}

}  // namespace

void GatingRate::add(const UpdateStatistics& statistics) {
  if (statistics.innovations.empty()) return;
  gate_probability_ = statistics.gate_probability;
  Step step;
  for (const auto& innovation : statistics.innovations)
    step.push_back({innovation.id, innovation.used});
  count(step, 1);
  steps_.push_back(std::move(step));
  if (steps_.size() <= window_) return;
  count(steps_.front(), -1);
  steps_.pop_front();
}

GatingRate::Count GatingRate::countOf(const Step& step) {
  const auto used = std::count_if(step.begin(), step.end(), [](auto& seen) { return seen.used; });
  const auto seen = static_cast<int>(step.size());
  return {seen, seen - static_cast<int>(used)};
}

void GatingRate::count(const Step& step, int sign) {
  for (const auto& observation : step) {
    auto& landmark = landmarks_[observation.id];
    landmark.seen += sign;
    landmark.gated += observation.used ? 0 : sign;
    if (landmark.seen == 0) landmarks_.erase(observation.id);
  }
  const auto of_step = countOf(step);
  all_.seen += sign * of_step.seen;
  all_.gated += sign * of_step.gated;
  doubtful_steps_ += of_step.isMostlyGated() ? sign : 0;
}

double GatingRate::probability() const {
  int trials = 0;
  double gated = 0.0;
  for (const auto& [id, landmark] : landmarks_) {
    const int counted = std::min(landmark.seen, kMostOfOne);
    trials += counted;
    gated += static_cast<double>(counted * landmark.gated) / landmark.seen;
  }
  constexpr double kRounding = 1e-9;
  return binomialTail(trials, static_cast<int>(gated + kRounding),
                      1.0 - (1.0 - kOutliers) * gate_probability_);
}

bool GatingRate::isExcessive() const {
  const auto steps = static_cast<int>(steps_.size());
  return steps >= kFewestSteps && all_.isMostlyGated() && 2 * doubtful_steps_ > steps &&
         probability() < kFalseAlarm;
}

}  // namespace slam
