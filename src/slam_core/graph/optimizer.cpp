// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"

namespace slam::graph {
namespace {

Eigen::MatrixXd hessian(const LinearFactor& linear) { return linear.J.transpose() * linear.J; }

Eigen::VectorXd gradient(const LinearFactor& linear) { return -linear.J.transpose() * linear.r; }

}  // namespace

template <class Value>
Key Optimizer::addVariable(const Value& value, int rows) {
  const Key key = tree_.addVariable(rows);
  variables_.put(key, value);
  terms_of_.resize(variables_.size());
  return key;
}

Key Optimizer::add(const Pose2& pose) { return addVariable(pose, 3); }

Key Optimizer::add(const Eigen::Vector2d& point) { return addVariable(point, 2); }

void removeVariable(Optimizer& graph, Key key) {
  graph.moved_.erase(std::remove(graph.moved_.begin(), graph.moved_.end(), key),
                     graph.moved_.end());
  removeVariable(graph.tree_, key);
}

FactorId Optimizer::add(std::shared_ptr<const Factor> factor) {
  Term term{std::move(factor), 1.0, {}};
  const auto id = tree_.addFactor(linearize(term));
  if (index(id) >= terms_.size()) terms_.resize(index(id) + 1);
  for (const Key key : term.factor->keys()) terms_of_[index(key)].push_back(id);
  terms_[index(id)] = std::move(term);
  return id;
}

void Optimizer::remove(FactorId id) {
  for (const Key key : terms_[index(id)].factor->keys()) {
    auto& terms = terms_of_[index(key)];
    terms.erase(std::find(terms.begin(), terms.end(), id));
  }
  terms_[index(id)] = {};
  for (auto* ids : {&due_, &postponed_})
    ids->erase(std::remove(ids->begin(), ids->end(), id), ids->end());
  tree_.removeFactor(id);
}

void Optimizer::set(FactorId id, double weight) {
  terms_[index(id)].weight = weight;
  refresh(id);
}

void Optimizer::set(Key key, const Eigen::Vector2d& point) {
  variables_.set(key, Pose2(point.x(), point.y(), 0.0));
  tree_.moveOrigin(key);
  for (const FactorId id : terms_of_[index(key)]) refresh(id);
}

void visitFactors(const Optimizer& graph, const FactorVisitor& look) {
  for (const auto& term : graph.terms_)
    if (term.factor) look(*term.factor, term.weight);
}

/// A factor would be linearised now at the origins of its variables; of points that go by the
/// factor at their estimates, to which corrections can be added.
std::vector<Pose2> Optimizer::linearizationOf(const Factor& factor) const {
  std::vector<Pose2> at;
  for (const Key key : factor.keys())
    at.push_back(goesByFactor(key) ? pose(key) : variables_.pose(key));
  return at;
}

LinearFactor Optimizer::atEstimate(const Factor& factor) const {
  std::vector<Pose2> estimates;
  for (const Key key : factor.keys()) estimates.push_back(pose(key));
  return factor.linearized(estimates);
}

/// Linearises a factor. @return its quadratic by corrections from the origins
QuadraticFactor Optimizer::linearize(Term& term) const {
  const auto& keys = term.factor->keys();
  term.at = linearizationOf(*term.factor);
  auto linear = term.factor->linearized(term.at);
  linear.r *= std::sqrt(term.weight);
  linear.J *= std::sqrt(term.weight);
  Eigen::Index column = 0;
  for (const Key key : keys) {
    const auto rows = variables_.rows(key);
    if (goesByFactor(key))
      linear.r.noalias() -= linear.J.middleCols<2>(column) * tree_.solution(key);
    column += rows;
  }
  return {keys, hessian(linear), gradient(linear)};
}

void Optimizer::refresh(FactorId id) {
  const auto quadratic = linearize(terms_[index(id)]);
  tree_.replace(id, quadratic.H, quadratic.g);
}

/// Returns how far a factor is from where it was linearised, divided by what is allowed.
double Optimizer::excess(FactorId id) const {
  const auto& [factor, weight, at] = terms_[index(id)];
  return factor->moved(at, linearizationOf(*factor)) / limits_.correction;
}

/// Looks at the factors of the variables that the last step has moved. The others are as they were.
void Optimizer::findOutdated() {
  std::vector<FactorId> looked_at;
  for (const Key key : moved_)
    looked_at.insert(looked_at.end(), terms_of_[index(key)].begin(), terms_of_[index(key)].end());
  looked_at = sortedUnique(std::move(looked_at));
  std::vector<FactorId> postponed;
  std::set_difference(postponed_.begin(), postponed_.end(), looked_at.begin(), looked_at.end(),
                      std::back_inserter(postponed));
  due_.clear();
  for (const FactorId id : looked_at) {
    const double excess = this->excess(id);
    if (excess <= 1.0) continue;
    const bool waits = excess <= limits_.patience && joinsPointsAlone(*terms_[index(id)].factor);
    (waits ? postponed : due_).push_back(id);
  }
  postponed_ = sortedUnique(std::move(postponed));
}

bool Optimizer::joinsPointsAlone(const Factor& factor) const {
  const auto is_point = [this](Key key) { return variables_.rows(key) == 2; };
  return std::all_of(factor.keys().begin(), factor.keys().end(), is_point);
}

/// Linearises factors again that are too far from where they were linearised, and all factors of a
/// variable that is too far as a whole, also those that were added since the last step.
/// @param with_postponed also those that wait
void Optimizer::relinearize(bool with_postponed) {
  auto factors = std::exchange(due_, {});
  const auto add = [&factors](const std::vector<FactorId>& more) {
    factors.insert(factors.end(), more.begin(), more.end());
  };
  if (with_postponed) add(std::exchange(postponed_, {}));
  for (const Key key : moved_) {
    if (!isFarAsAWhole(key)) continue;
    moveOrigin(key);
    add(terms_of_[index(key)]);
  }
  for (const FactorId id : sortedUnique(std::move(factors))) refresh(id);
}

/// Factors of variables that have moved at all are linearised again.
void Optimizer::relinearizeAll() {
  due_.clear();
  postponed_.clear();
  std::vector<FactorId> factors;
  for (Key key = 0; key < static_cast<Key>(variables_.size()); ++key) {
    if (!isFurther(key, 0.0)) continue;
    moveOrigin(key);
    const auto& terms = terms_of_[index(key)];
    factors.insert(factors.end(), terms.begin(), terms.end());
  }
  for (const FactorId id : sortedUnique(std::move(factors))) refresh(id);
}

void Optimizer::moveOrigin(Key key) {
  variables_.set(key, pose(key));
  tree_.moveOrigin(key);
}

bool Optimizer::update(const std::vector<Key>& last, const Vicinity& vicinity) {
  relinearize(!vicinity.gathered.empty());
  tree_.update(last, vicinity);
  moved_ = tree_.solve(limits_.change, limits_.passed_on);
  findOutdated();
  const auto is_far = [this](Key key) { return isFarAsAWhole(key); };
  return !due_.empty() || std::any_of(moved_.begin(), moved_.end(), is_far);
}

bool Optimizer::optimize(const std::vector<Key>& last, int most_steps) {
  constexpr double kConverged = 1e-4;
  std::vector<Key> all(variables_.size());
  std::iota(all.begin(), all.end(), 0);
  for (int i = 0; i < most_steps; ++i) {
    relinearizeAll();
    tree_.update(last);
    tree_.solve();
    const auto has_moved = [this](Key key) { return isFurther(key, kConverged); };
    if (std::none_of(all.begin(), all.end(), has_moved)) return true;
  }
  return false;
}

std::vector<Pose2> settled(const Optimizer& graph) {
  const Eigen::VectorXd x = solved(graph.tree_);
  std::vector<Pose2> estimates;
  Eigen::Index row = 0;
  for (Key key = 0; key < static_cast<Key>(graph.variables_.size()); ++key) {
    const auto rows = graph.variables_.rows(key);
    estimates.push_back(graph.variables_.corrected(key, x.segment(row, rows)));
    row += rows;
  }
  return estimates;
}

GraphContents contentsOf(const Optimizer& graph) {
  GraphContents contents;
  for (const auto& term : graph.terms_) contents.factors.push_back(term.factor);
  for (Key key = 0; key < static_cast<Key>(graph.variables_.size()); ++key)
    contents.is_pose.push_back(graph.variables_.rows(key) == 3);
  return contents;
}

void eliminate(Optimizer& graph, const std::vector<Key>& last) { graph.tree_.update(last); }

double Optimizer::chi2(const Factor& factor) const { return atEstimate(factor).r.squaredNorm(); }

double Optimizer::chi2() const {
  double sum = 0.0;
  for (const auto& term : terms_)
    if (term.factor) sum += term.weight * chi2(*term.factor);
  return sum;
}

double Innovation::nis() const { return r.dot(S.llt().solve(r)); }

Innovation Optimizer::innovation(const std::vector<const Factor*>& factors) const {
  std::vector<Key> keys;
  std::vector<LinearFactor> linear;
  Eigen::Index rows = 0, columns = 0;
  for (const auto* factor : factors) {
    linear.push_back(atEstimate(*factor));
    keys.insert(keys.end(), factor->keys().begin(), factor->keys().end());
    rows += linear.back().J.rows();
    columns += linear.back().J.cols();
  }
  Innovation innovation{Eigen::VectorXd(rows), {}};
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, columns);
  Eigen::Index row = 0, column = 0;
  for (const auto& each : linear) {
    innovation.r.segment(row, each.r.size()) = each.r;
    J.block(row, column, each.J.rows(), each.J.cols()) = each.J;
    row += each.J.rows();
    column += each.J.cols();
  }
  innovation.S = J * covariance(keys) * J.transpose() + Eigen::MatrixXd::Identity(rows, rows);
  return innovation;
}

}  // namespace slam::graph
