// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/joint_search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/association/gate.hpp"

namespace slam::association {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostPairings = JointSearch::kMostObservations * JointSearch::kMostOptions;

Eigen::Index rowOf(std::size_t depth) { return 2 * static_cast<Eigen::Index>(depth); }

}  // namespace

void JointSearch::configure(double probability, double margin, int nodes) {
  margin_ = margin;
  nodes_ = nodes;
  gates_.assign(1, 0.0);
  for (std::size_t i = 1; i <= kMostObservations; ++i)
    gates_.push_back(jointGateOf(probability, i));
  cross_.resize(kMostPairings * kMostPairings);
}

const std::vector<JointSearch::Choice>& JointSearch::search(
    const std::vector<std::size_t>& observations, const Options& options,
    const CandidateSource& source, const std::vector<std::size_t>& taken) {
  options_ = &options;
  source_ = &source;
  begin(observations, taken);
  visit(0);
  conclude();
  return choices_;
}

void JointSearch::begin(const std::vector<std::size_t>& observations,
                        const std::vector<std::size_t>& taken) {
  levels_.clear();
  for (const auto observation : observations) {
    const auto count = std::min(options_->of(observation).size(), kMostOptions);
    levels_.push_back({observation, count, -1, -1, {}});
  }
  std::stable_sort(levels_.begin(), levels_.end(),
                   [](const Level& a, const Level& b) { return a.options < b.options; });
  for (auto& level : levels_) level.costs.assign(level.options + 1, kNever);
  taken_ = taken;
  branch_.clear();
  nis_.assign(1, 0.0);
  costs_.assign(1, 0.0);
  best_pairings_ = 0;
  best_cost_ = kNever;
  nodes_left_ = nodes_;
  has_cross_.assign(kMostPairings * levels_.size() * kMostOptions, 0);
}

const Option& JointSearch::optionOf(std::size_t pairing) const {
  const auto& level = levels_[pairing / kMostOptions];
  return options_->of(level.observation)[pairing % kMostOptions];
}

bool JointSearch::isTaken(std::size_t landmark) const {
  return std::find(taken_.begin(), taken_.end(), landmark) != taken_.end();
}

void JointSearch::visit(std::size_t level) {
  if (level == levels_.size()) return finishBranch();
  for (int option = 0; option < static_cast<int>(levels_[level].options); ++option) {
    if (isTaken(optionOf(pairingOf(level, option)).landmark)) continue;
    if (--nodes_left_ < 0) return cutOff(level);
    tryOption(level, option);
  }
  levels_[level].choice = -1;
  if (mayBeBest(level + 1)) visit(level + 1);
}

/// What has been paired so far counts, the rest being clutter.
void JointSearch::cutOff(std::size_t level) {
  for (auto rest = level; rest < levels_.size(); ++rest) levels_[rest].choice = -1;
  finishBranch();
}

void JointSearch::tryOption(std::size_t level, int option) {
  const auto pairing = pairingOf(level, option);
  if (!push(pairing)) return;
  levels_[level].choice = option;
  if (mayBeBest(level + 1)) visit(level + 1);
  pop();
}

/// Costs only grow, so that a branch with no more pairings than the best one has to stay below its
/// cost and the margin.
bool JointSearch::mayBeBest(std::size_t next_level) const {
  const auto most = branch_.size() + levels_.size() - next_level;
  if (most != best_pairings_) return most > best_pairings_;
  return costs_.back() < best_cost_ + margin_;
}

const Eigen::Matrix2d& JointSearch::crossCovariance(std::size_t first, std::size_t second) {
  const auto place = first * kMostPairings + second;
  if (!has_cross_[place]) {
    const auto pairing = [this](std::size_t number) {
      return Pairing{levels_[number / kMostOptions].observation, optionOf(number).landmark};
    };
    cross_[place] = source_->crossCovariance(pairing(first), pairing(second));
    has_cross_[place] = 1;
  }
  return cross_[place];
}

/// Fills the two rows of the factor that hold what the pairing has in common with the branch.
void JointSearch::solveRows(std::size_t pairing) {
  const auto row = rowOf(branch_.size());
  for (std::size_t i = 0; i < branch_.size(); ++i) {
    const auto before = rowOf(i);
    Eigen::Matrix2d y = crossCovariance(pairing, branch_[i]);
    y -= L_.block(row, 0, 2, before).lazyProduct(L_.block(before, 0, 2, before).transpose());
    const Eigen::Matrix2d root = L_.block<2, 2>(before, before);
    L_.block<2, 2>(row, before) =
        root.triangularView<Eigen::Lower>().solve(y.transpose()).transpose();
  }
}

/// Adds a pairing by its innovation and its covariance given the branch.
/// @return whether the branch passes the joint test with it
bool JointSearch::push(std::size_t pairing) {
  const auto& option = optionOf(pairing);
  const auto row = rowOf(branch_.size());
  solveRows(pairing);
  const auto known = L_.block(row, 0, 2, row);
  const Eigen::Matrix2d S = option.S - known.lazyProduct(known.transpose());
  const Eigen::Vector2d nu = option.nu - known.lazyProduct(whitened_.head(row));
  const Eigen::LLT<Eigen::Matrix2d> root(S);
  if (root.info() != Eigen::Success) return false;
  const Eigen::Vector2d whitened = root.matrixL().solve(nu);
  const double nis = whitened.squaredNorm();
  if (!(nis_.back() + nis <= gates_[branch_.size() + 1])) return false;
  L_.block<2, 2>(row, row) = root.matrixL();
  whitened_.segment<2>(row) = whitened;
  const double spread = std::max(0.0, std::log(S.determinant()) - option.log_noise);
  branch_.push_back(pairing);
  taken_.push_back(option.landmark);
  nis_.push_back(nis_.back() + nis);
  costs_.push_back(costs_.back() + nis + spread + option.descriptor_cost);
  return true;
}

void JointSearch::pop() {
  branch_.pop_back();
  taken_.pop_back();
  nis_.pop_back();
  costs_.pop_back();
}

/// Of each observation the lowest cost of each choice is kept, among all with the most pairings.
void JointSearch::finishBranch() {
  if (branch_.size() < best_pairings_) return;
  const bool is_longer = branch_.size() > best_pairings_;
  const bool is_better = is_longer || costs_.back() < best_cost_;
  for (auto& level : levels_) {
    if (is_longer) std::fill(level.costs.begin(), level.costs.end(), kNever);
    const auto choice = level.choice < 0 ? level.options : static_cast<std::size_t>(level.choice);
    level.costs[choice] = std::min(level.costs[choice], costs_.back());
    if (is_better) level.best = level.choice;
  }
  best_pairings_ = branch_.size();
  if (is_better) best_cost_ = costs_.back();
}

void JointSearch::conclude() {
  choices_.clear();
  for (const auto& level : levels_) {
    const auto best = level.best < 0 ? level.options : static_cast<std::size_t>(level.best);
    bool is_ambiguous = isCutOff() && options_->isAmbiguous(level.observation, margin_);
    for (std::size_t i = 0; i < level.costs.size(); ++i)
      is_ambiguous |= i != best && level.costs[i] < best_cost_ + margin_;
    choices_.push_back({level.observation, level.best, is_ambiguous});
  }
}

}  // namespace slam::association
