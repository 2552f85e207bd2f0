// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/robust_loops.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam::graph {
namespace {

/// Quantiles of the chi-square distribution: 0.999 with three and with six degrees of freedom, 0.9
/// and 0.5 with three.
constexpr double kGate = 16.27, kGateOfTwo = 22.46, kUsual = 6.25, kMedian = 2.366;
constexpr double kChange = 0.05, kRejected = 0.1;
/// Where the graph's variance is larger than so many times a loop's own, one loop alone is not
/// believed.
constexpr double kHeavy = 10.0;

/// The graph's variance in the mean over all directions, relative to the loop's own.
double doubtOf(const Eigen::MatrixXd& S) { return S.trace() / static_cast<double>(S.rows()) - 1.0; }

/// That of the scaled covariance: s^2 with s = 2 kUsual / (kUsual + chi2).
double weightOf(double chi2) {
  const double s = std::min(1.0, 2.0 * kUsual / (kUsual + chi2));
  return s * s;
}

bool joins(const std::shared_ptr<const Factor>& loop, Key pose) {
  const auto& keys = loop->keys();
  return std::find(keys.begin(), keys.end(), pose) != keys.end();
}

}  // namespace

void RobustLoops::believe(Loop& loop) {
  loop.id = graph_.add(loop.factor);
  loop.weight = 1.0;
  loop.is_alone = false;
  has_new_ = true;
  ++changes_.believed;
}

/// The median follows each loop by a small step (Robbins and Monro 1951).
void RobustLoops::learnNoise(double nis) {
  constexpr double kStep = 0.05, kLeast = 0.05;
  if (!learns_) return;
  ++taught_;
  noise_ *= std::exp(nis > kMedian * noise_ ? kStep : -kStep);
  noise_ = std::clamp(noise_, kLeast, 1.0);
}

/// Two loops say the same where they fit together and the one leaves little doubt of the other.
bool RobustLoops::isConfirmed(const Loop& loop, const Loop& by) const {
  constexpr double kLeft = 0.5;
  const auto both = graph_.innovation({loop.factor.get(), by.factor.get()});
  const auto n = both.S.rows() / 2;
  const Eigen::MatrixXd A = both.S.topLeftCorner(n, n), C = both.S.topRightCorner(n, n);
  const Eigen::MatrixXd left = A - C * both.S.bottomRightCorner(n, n).llt().solve(C.transpose());
  return doubtOf(left) <= kLeft * doubtOf(A) && both.nis() <= kGateOfTwo * noise_;
}

bool RobustLoops::add(std::shared_ptr<const Factor> factor) {
  loops_.push_back({std::move(factor), std::nullopt, 1.0, false});
  auto& loop = loops_.back();
  const auto innovation = graph_.innovation({loop.factor.get()});
  const double nis = innovation.nis();
  if (nis > kGate * noise_) return false;
  if (doubtOf(innovation.S) <= kHeavy) {
    learnNoise(nis);
    believe(loop);
    return true;
  }
  const auto other = std::find_if(loops_.begin(), loops_.end() - 1, [&](const Loop& each) {
    return each.is_alone && isConfirmed(loop, each);
  });
  loop.is_alone = true;
  if (other == loops_.end() - 1) return false;
  believe(*other);
  believe(loop);
  return true;
}

void RobustLoops::judge(const Settle& settle) {
  if (!std::exchange(has_new_, false)) return;
  settle();
  if (weigh()) settle();
  if (reconsider()) settle();
  has_new_ = false;
  if (hasLearnt()) judgeAnew(settle);
}

bool RobustLoops::hasLearnt() const {
  constexpr int kEnough = 100;
  constexpr double kMuchLess = 0.5;  // than was assumed
  return taught_ == kEnough && noise_ < kMuchLess;
}

/// Judges the loops one by one in their order, as if they came now. They do not teach again.
void RobustLoops::judgeAnew(const Settle& settle) {
  ++taught_;
  const bool learns = std::exchange(learns_, false);
  const auto before = std::exchange(loops_, {});
  auto changes = changes_;
  for (const auto& loop : before)
    if (loop.id) graph_.remove(*loop.id);
  settle();
  for (const auto& loop : before) {
    add(loop.factor);
    judge(settle);
  }
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    if (before[i].id && !loops_[i].id) ++changes.taken_back;
    if (!before[i].id && loops_[i].id) ++changes.believed;
  }
  changes_ = changes;
  learns_ = learns;
}

bool RobustLoops::weigh() {
  bool has_changed = false;
  for (auto& loop : loops_) {
    if (!loop.id) continue;
    const double next = weightOf(graph_.chi2(*loop.factor) / noise_);
    if (std::abs(next - loop.weight) <= kChange) continue;
    has_changed = true;
    loop.weight = next;
    if (next < kRejected) {
      graph_.remove(*loop.id);
      loop.id.reset();
      ++changes_.taken_back;
    } else {
      graph_.set(*loop.id, loop.weight);
    }
  }
  return has_changed;
}

bool RobustLoops::reconsider() {
  constexpr double kFar = 10.0;  // a loop further away than this has been tried often enough
  constexpr double kLoneNoise = 0.25;
  constexpr std::size_t kManyLater = 100;
  bool has_changed = false;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    auto& loop = loops_[i];
    if (loop.id) continue;
    const bool is_far = graph_.chi2(*loop.factor) > kFar * kGate * noise_;
    if (is_far && !loop.is_alone) continue;
    const auto innovation = graph_.innovation({loop.factor.get()});
    const bool is_too_early = doubtOf(innovation.S) > kHeavy && i + kManyLater > loops_.size();
    // how noisy the way to a lone loop is, others do not tell
    const double noise = loop.is_alone ? std::max(noise_, kLoneNoise) : noise_;
    if (innovation.nis() > kGate * noise || is_too_early) continue;
    believe(loop);
    has_changed = true;
  }
  return has_changed;
}

std::vector<RobustLoops::State> RobustLoops::states() const {
  std::vector<State> states;
  states.reserve(loops_.size());
  for (const auto& loop : loops_)
    states.push_back({loop.factor, loop.id.has_value(), loop.weight, loop.is_alone});
  return states;
}

void RobustLoops::restore(const std::vector<State>& states) {
  for (const auto& [factor, is_believed, weight, is_alone] : states) {
    loops_.push_back({factor, std::nullopt, weight, is_alone});
    if (!is_believed) continue;
    const auto id = graph_.add(factor);
    graph_.set(id, weight);
    loops_.back().id = id;
  }
}

bool RobustLoops::believesOneOf(Key pose) const {
  return std::any_of(loops_.begin(), loops_.end(),
                     [pose](const Loop& loop) { return loop.id && joins(loop.factor, pose); });
}

void RobustLoops::forget(Key pose) {
  for (const auto& loop : loops_)
    if (loop.id && joins(loop.factor, pose)) graph_.remove(*loop.id);
  const auto is_gone = [pose](const Loop& loop) { return joins(loop.factor, pose); };
  loops_.erase(std::remove_if(loops_.begin(), loops_.end(), is_gone), loops_.end());
}

std::size_t RobustLoops::rejected() const {
  return static_cast<std::size_t>(
      std::count_if(loops_.begin(), loops_.end(), [](const Loop& loop) { return !loop.id; }));
}

}  // namespace slam::graph
