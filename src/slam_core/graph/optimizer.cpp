// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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
  const auto linear = factor->linearized(origins(*factor));
  const auto id = tree_.addFactor({factor->keys(), hessian(linear), gradient(linear)});
  if (index(id) >= terms_.size()) terms_.resize(index(id) + 1);
  for (const Key key : factor->keys()) terms_of_[index(key)].push_back(id);
  terms_[index(id)] = {std::move(factor), 1.0};
  return id;
}

void Optimizer::remove(FactorId id) {
  for (const Key key : terms_[index(id)].factor->keys()) {
    auto& terms = terms_of_[index(key)];
    terms.erase(std::find(terms.begin(), terms.end(), id));
  }
  terms_[index(id)] = {};
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
  for (const auto& [factor, weight] : graph.terms_)
    if (factor) look(*factor, weight);
}

std::vector<Pose2> Optimizer::origins(const Factor& factor) const {
  std::vector<Pose2> origins;
  for (const Key key : factor.keys()) origins.push_back(variables_.pose(key));
  return origins;
}

LinearFactor Optimizer::atEstimate(const Factor& factor) const {
  std::vector<Pose2> estimates;
  for (const Key key : factor.keys()) estimates.push_back(pose(key));
  return factor.linearized(estimates);
}

void Optimizer::refresh(FactorId id) {
  const auto& term = terms_[index(id)];
  auto linear = term.factor->linearized(origins(*term.factor));
  linear.r *= std::sqrt(term.weight);
  linear.J *= std::sqrt(term.weight);
  tree_.replace(id, hessian(linear), gradient(linear));
}

/// Factors of variables that are further from where they were linearised are linearised again.
void Optimizer::relinearize(const std::vector<Key>& keys, double limit) {
  std::vector<FactorId> changed;
  for (const Key key : keys) {
    if (!isFurther(key, limit)) continue;
    variables_.set(key, pose(key));
    tree_.moveOrigin(key);
    const auto& terms = terms_of_[index(key)];
    changed.insert(changed.end(), terms.begin(), terms.end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const FactorId id : changed) refresh(id);
}

bool Optimizer::update(const std::vector<Key>& last) {
  relinearize(moved_, limits_.correction);
  tree_.update(last);
  moved_ = tree_.solve(limits_.change);
  return std::any_of(moved_.begin(), moved_.end(),
                     [this](Key key) { return isFurther(key, limits_.correction); });
}

bool Optimizer::optimize(const std::vector<Key>& last, int most_steps) {
  constexpr double kConverged = 1e-4;
  std::vector<Key> all(variables_.size());
  std::iota(all.begin(), all.end(), 0);
  for (int i = 0; i < most_steps; ++i) {
    relinearize(all, 0.0);
    tree_.update(last);
    tree_.solve();
    const auto has_moved = [this](Key key) { return isFurther(key, kConverged); };
    if (std::none_of(all.begin(), all.end(), has_moved)) return true;
  }
  return false;
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
