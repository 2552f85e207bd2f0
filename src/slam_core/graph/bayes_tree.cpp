// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/bayes_tree.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "slam_core/graph/elimination.hpp"

// Symbols: a clique with frontal variables f and separator s holds L_ff and L_sf of the Cholesky
// factor L, y_f = L_ff^-1 (g_f + what its children leave), and leaves g_s - L_sf y_f to its parent.
// The solution follows from the root down: L_ff^T x_f = y_f - L_sf^T x_s.

namespace slam::graph {

Key BayesTree::addVariable(int rows) {
  const auto has_rows = [&](Key key) { return rows_[index(key)] == rows; };
  const auto free = std::find_if(free_keys_.begin(), free_keys_.end(), has_rows);
  if (free != free_keys_.end()) {
    const Key key = *free;
    free_keys_.erase(free);
    open_.push_back(key);
    return key;
  }
  const auto key = static_cast<Key>(rows_.size());
  offsets_.push_back(static_cast<int>(solution_.size()));
  rows_.push_back(rows);
  clique_of_.push_back(-1);
  row_of_.push_back(-1);
  open_.push_back(key);
  const auto size = solution_.size() + rows;
  solution_.conservativeResizeLike(Eigen::VectorXd::Zero(size));
  spread_.conservativeResizeLike(Eigen::VectorXd::Zero(size));
  return key;
}

void removeVariable(BayesTree& tree, Key key) {
  tree.moveOrigin(key);
  tree.touched_.push_back(key);
  tree.removed_.push_back(key);
}

FactorId BayesTree::addFactor(QuadraticFactor factor) {
  touched_.insert(touched_.end(), factor.keys.begin(), factor.keys.end());
  FactorId id = static_cast<FactorId>(factors_.size());
  if (free_factors_.empty()) {
    factors_.emplace_back();
  } else {
    id = free_factors_.back();
    free_factors_.pop_back();
  }
  factors_[index(id)] = {std::move(factor), -1};
  open_factors_.push_back(id);
  return id;
}

void BayesTree::replace(FactorId id, const Eigen::MatrixXd& H, const Eigen::VectorXd& g) {
  auto& stored = factors_[index(id)];
  stored.factor.H = H;
  stored.factor.g = g;
  if (stored.clique >= 0) changed_.push_back(stored.clique);
}

void BayesTree::removeFactor(FactorId id) {
  const int holder = factors_[index(id)].clique;
  auto& holders = holder >= 0 ? clique(holder).factors : open_factors_;
  holders.erase(std::find(holders.begin(), holders.end(), id));
  if (holder >= 0) changed_.push_back(holder);
  factors_[index(id)] = {};
  free_factors_.push_back(id);
}

int BayesTree::newClique() {
  if (free_.empty()) {
    cliques_.emplace_back();
    return static_cast<int>(cliques_.size()) - 1;
  }
  const int i = free_.back();
  free_.pop_back();
  return i;
}

/// Takes a clique off, and all above it.
void BayesTree::open(int i) {
  while (i >= 0 && !clique(i).is_open) {
    auto& taken = clique(i);
    for (std::size_t k = 0; k < index(taken.frontals); ++k) {
      clique_of_[index(taken.keys[k])] = -1;
      open_.push_back(taken.keys[k]);
    }
    for (const FactorId id : taken.factors) factors_[index(id)].clique = -1;
    open_factors_.insert(open_factors_.end(), taken.factors.begin(), taken.factors.end());
    orphans_.insert(orphans_.end(), taken.children.begin(), taken.children.end());
    taken.factors.clear();
    taken.children.clear();
    taken.is_open = true;
    free_.push_back(i);
    i = std::exchange(taken.parent, -1);
  }
}

void BayesTree::openAll() {
  for (const int i : changed_) open(i);
  for (const Key key : touched_) open(clique_of_[index(key)]);
  changed_.clear();
  touched_.clear();
  const auto is_open = [this](int i) { return clique(i).is_open; };
  orphans_.erase(std::remove_if(orphans_.begin(), orphans_.end(), is_open), orphans_.end());
  roots_.erase(std::remove_if(roots_.begin(), roots_.end(), is_open), roots_.end());
  std::sort(open_.begin(), open_.end());
  freeRemoved();
}

/// Every clique with a removed variable lay between one of its factors and the root, and is open.
void BayesTree::freeRemoved() {
  std::sort(removed_.begin(), removed_.end());
  std::vector<Key> left;
  std::set_difference(open_.begin(), open_.end(), removed_.begin(), removed_.end(),
                      std::back_inserter(left));
  open_ = std::move(left);
  free_keys_.insert(free_keys_.end(), removed_.begin(), removed_.end());
  removed_.clear();
}

/// Cliques that are not in use keep no matrices.
void BayesTree::giveMemoryBack() {
  for (const int i : free_) {
    auto& unused = clique(i);
    if (unused.columns.size() == 0) continue;
    const bool is_waiting = unused.is_waiting;  // its number stays in the queue
    unused = {};
    unused.is_open = true;
    unused.is_waiting = is_waiting;
  }
}

void BayesTree::update(const std::vector<Key>& last, const Vicinity& vicinity) {
  touched_.insert(touched_.end(), vicinity.gathered.begin(), vicinity.gathered.end());
  openAll();
  if (!open_.empty()) Elimination(*this, last, vicinity).run();
  open_.clear();
  open_factors_.clear();
  orphans_.clear();
  giveMemoryBack();
}

void BayesTree::substitute(Clique& c) {
  int rows = 0;
  for (const Key key : c.keys) {
    row_of_[index(key)] = rows;
    rows += rows_[index(key)];
  }
  Eigen::VectorXd g = Eigen::VectorXd::Zero(rows);
  const auto add = [&](const Key* keys, std::size_t size, const Eigen::VectorXd& part) {
    int row = 0;
    for (const Key* key = keys; key != keys + size; ++key) {
      const int n = rows_[index(*key)];
      for (int k = 0; k < n; ++k) g[row_of_[index(*key)] + k] += part[row + k];
      row += n;
    }
  };
  for (const FactorId id : c.factors) {
    const auto& factor = factors_[index(id)].factor;
    add(factor.keys.data(), factor.keys.size(), factor.g);
  }
  for (const int i : c.children) {
    const auto& child = clique(i);
    add(child.keys.data() + child.frontals, child.keys.size() - index(child.frontals),
        child.schur_rhs);
  }
  const int f = c.frontal_rows;
  c.rhs = c.columns.topRows(f).triangularView<Eigen::Lower>().solve(g.head(f));
  c.schur_rhs = g.tail(rows - f);
  c.schur_rhs.noalias() -= c.columns.bottomRows(rows - f) * c.rhs;
  c.is_due = true;
}

const std::vector<Key>& BayesTree::solve(double threshold, std::size_t most) {
  moved_.clear();
  std::vector<int> below;
  solveNew(below, threshold);
  std::size_t left = most / 2;
  solveBelow(below, threshold, left);
  left += most - most / 2;
  solveWaiting(threshold, left);
  wait(below);
  return moved_;
}

/// Solves the cliques that were eliminated since the last time, which are at the top.
/// @param below the cliques below them
void BayesTree::solveNew(std::vector<int>& below, double threshold) {
  std::vector<int> next = roots_;
  while (!next.empty()) {
    const int i = next.back();
    next.pop_back();
    if (!std::exchange(clique(i).is_due, false)) {
      below.push_back(i);
      continue;
    }
    solve(clique(i), threshold);
    next.insert(next.end(), clique(i).children.begin(), clique(i).children.end());
  }
}

/// Solves a clique if it is outdated. @return whether it was
bool BayesTree::isRenewed(Clique& c, double threshold, std::size_t& left) {
  if (!isOutdated(c)) return false;
  solve(c, threshold);
  left -= std::min(left, index(c.frontal_rows) * index(c.rows));
  return true;
}

/// Solves outdated cliques and those below them, the uppermost ones first.
/// @param cliques those that are left when so many numbers have been read
void BayesTree::solveBelow(std::vector<int>& cliques, double threshold, std::size_t& left) {
  std::size_t done = 0;
  for (; done < cliques.size() && left > 0; ++done) {
    auto& c = clique(cliques[done]);
    if (!isRenewed(c, threshold, left)) continue;
    cliques.insert(cliques.end(), c.children.begin(), c.children.end());
  }
  cliques.erase(cliques.begin(), cliques.begin() + static_cast<std::ptrdiff_t>(done));
}

/// Solves the cliques that have waited longest, until so many numbers have been read. The step
/// looks at no other one that waits.
void BayesTree::solveWaiting(double threshold, std::size_t left) {
  std::size_t done = 0;
  for (; done < waiting_.size() && left > 0; ++done) {
    auto& c = clique(waiting_[done]);
    c.is_waiting = false;
    if (isRenewed(c, threshold, left)) wait(c.children);
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(done));
}

void BayesTree::wait(const std::vector<int>& cliques) {
  for (const int i : cliques) {
    if (clique(i).is_waiting || !isOutdated(clique(i))) continue;
    clique(i).is_waiting = true;
    waiting_.push_back(i);
  }
}

/// Whether what the clique depends on has moved since its part of the solution was computed.
bool BayesTree::isOutdated(const Clique& c) const {
  if (c.is_open) return false;
  int row = 0;
  for (auto i = index(c.frontals); i < c.keys.size(); ++i) {
    const auto k = index(c.keys[i]);
    if (c.separator.segment(row, rows_[k]) != spread_.segment(offsets_[k], rows_[k])) return true;
    row += rows_[k];
  }
  return false;
}

Eigen::VectorXd BayesTree::onSeparator(const Clique& c, const Eigen::VectorXd& x) const {
  Eigen::VectorXd separator(c.rows - c.frontal_rows);
  int row = 0;
  for (auto i = index(c.frontals); i < c.keys.size(); ++i) {
    const auto k = index(c.keys[i]);
    separator.segment(row, rows_[k]) = x.segment(offsets_[k], rows_[k]);
    row += rows_[k];
  }
  return separator;
}

/// A solution that no graph can mean holds variables where they are.
Eigen::VectorXd BayesTree::onFrontals(const Clique& c, const Eigen::VectorXd& separator) const {
  constexpr double kFarthest = 1e9;  // [m], [rad]
  const int f = c.frontal_rows;
  Eigen::VectorXd x = c.rhs;
  x.noalias() -= c.columns.bottomRows(c.rows - f).transpose() * separator;
  c.columns.topRows(f).triangularView<Eigen::Lower>().transpose().solveInPlace(x);
  if (!(x.array().abs() <= kFarthest).all()) x.setZero();
  return x;
}

void BayesTree::solve(Clique& c, double threshold) {
  c.separator = onSeparator(c, spread_);
  const Eigen::VectorXd x = onFrontals(c, c.separator);
  if (x.isZero(0.0) && !c.rhs.isZero(0.0)) ++undetermined_;
  int row = 0;
  for (std::size_t i = 0; i < index(c.frontals); ++i) {
    const auto k = index(c.keys[i]);
    const auto now = x.segment(row, rows_[k]);
    row += rows_[k];
    solution_.segment(offsets_[k], rows_[k]) = now;
    auto spread = spread_.segment(offsets_[k], rows_[k]);
    if ((now - spread).cwiseAbs().maxCoeff() <= threshold) continue;
    spread = now;
    moved_.push_back(c.keys[i]);
  }
}

Eigen::VectorXd solved(const BayesTree& tree) {
  Eigen::VectorXd x = tree.solution_;
  std::vector<int> next = tree.roots_;
  while (!next.empty()) {
    const auto& c = tree.clique(next.back());
    next.pop_back();
    const Eigen::VectorXd part = tree.onFrontals(c, tree.onSeparator(c, x));
    int row = 0;
    for (std::size_t i = 0; i < BayesTree::index(c.frontals); ++i) {
      const auto k = BayesTree::index(c.keys[i]);
      x.segment(tree.offsets_[k], tree.rows_[k]) = part.segment(row, tree.rows_[k]);
      row += tree.rows_[k];
    }
    next.insert(next.end(), c.children.begin(), c.children.end());
  }
  return x;
}

void BayesTree::moveOrigin(Key key) {
  solution_.segment(offsets_[index(key)], rows(key)).setZero();
  spread_.segment(offsets_[index(key)], rows(key)).setZero();
}

std::vector<BayesTree::ForwardRows> BayesTree::forward(Key key) const {
  std::vector<ForwardRows> result;
  std::vector<std::pair<Key, Eigen::MatrixXd>> b = {
      {key, Eigen::MatrixXd::Identity(rows(key), rows(key))}};  // what is left to substitute
  for (int i = clique_of_[index(key)]; i >= 0; i = clique(i).parent) {
    const auto& c = clique(i);
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(c.rows, rows(key));
    int row = 0;
    for (const Key k : c.keys) {
      row_of_[index(k)] = row;
      row += rows(k);
    }
    for (const auto& [k, values] : b) part.middleRows(row_of_[index(k)], rows(k)) = values;
    const int f = c.frontal_rows;
    auto y = part.topRows(f);
    c.columns.topRows(f).triangularView<Eigen::Lower>().solveInPlace(y);
    part.bottomRows(c.rows - f).noalias() -= c.columns.bottomRows(c.rows - f) * y;
    b.clear();
    for (auto k = index(c.frontals); k < c.keys.size(); ++k)
      b.emplace_back(c.keys[k], part.middleRows(row_of_[index(c.keys[k])], rows(c.keys[k])));
    result.push_back({i, y});
  }
  return result;
}

/// With L y = e, that of a and b is y_a^T y_b: the paths of two variables to the root have the
/// cliques above their first common one in common.
Eigen::MatrixXd BayesTree::covariance(const std::vector<Key>& keys) const {
  std::vector<std::vector<ForwardRows>> paths;
  std::vector<int> offsets = {0};
  for (const Key key : keys) {
    paths.push_back(forward(key));
    offsets.push_back(offsets.back() + rows(key));
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(offsets.back(), offsets.back());
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      auto block = covariance.block(offsets[i], offsets[j], rows(keys[i]), rows(keys[j]));
      auto a = paths[i].rbegin();
      auto b = paths[j].rbegin();
      for (; a != paths[i].rend() && b != paths[j].rend() && a->clique == b->clique; ++a, ++b)
        block.noalias() += a->rows.transpose() * b->rows;
    }
  covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
  return covariance;
}

BayesTree::Cost BayesTree::cost() const {
  Eigen::Index numbers = 0;
  for (const auto& c : cliques_)
    numbers += c.columns.size() + c.schur.size() + c.rhs.size() + c.schur_rhs.size();
  for (const auto& stored : factors_) numbers += stored.factor.H.size() + stored.factor.g.size();
  return {static_cast<std::size_t>(numbers) * sizeof(double), eliminated_rows_, undetermined_};
}

}  // namespace slam::graph
