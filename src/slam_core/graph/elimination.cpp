// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/elimination.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

#include "slam_core/common/sorted_unique.hpp"
#include "slam_core/graph/elimination_order.hpp"

namespace slam::graph {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Puts the Cholesky factor into the lower triangle. @return whether there is one that can be
/// divided by
bool isFactorized(Eigen::Ref<Eigen::MatrixXd> matrix) {
  constexpr double kLeastPivot = 1e-15;  // far below the weight of what is held
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(matrix);
  return llt.info() == Eigen::Success && matrix.diagonal().minCoeff() > kLeastPivot;
}

/// @param lower lower triangle of a symmetric matrix
/// @return the largest sum of the absolute values of a row, which no eigenvalue exceeds
double largestRow(const Eigen::MatrixXd& lower) {
  const Eigen::MatrixXd whole = lower.selfadjointView<Eigen::Lower>();
  return whole.cwiseAbs().rowwise().sum().maxCoeff();
}

}  // namespace

Elimination::Elimination(BayesTree& tree, const std::vector<Key>& last, const Vicinity& vicinity)
    : tree_(tree),
      places_(tree.rows_.size(), -1),
      columns_(tree.open_.size()),
      members_(tree.open_.size()) {
  const auto& open = tree_.open_;
  for (std::size_t i = 0; i < open.size(); ++i) places_[at(open[i])] = static_cast<int>(i);
  order(groupsOf(last, vicinity));
}

void Elimination::run() {
  assign();
  findStructure();
  formCliques();
  tree_.eliminated_rows_ = tree_.undetermined_ = 0;
  for (std::size_t j = 0; j < columns_.size(); ++j)
    if (!members_[j].empty()) eliminate(j);
}

/// The group of each open variable: shells from the outermost one to the innermost one, then the
/// variables that come last.
std::vector<int> Elimination::groupsOf(const std::vector<Key>& last,
                                       const Vicinity& vicinity) const {
  std::vector<int> groups;
  for (const Key key : tree_.open_) groups.push_back(vicinity.shell ? -vicinity.shell(key) : 0);
  for (const Key key : last)
    if (placeOf(key) >= 0) groups[at(placeOf(key))] = 1;
  const auto present = sortedUnique(groups);
  for (auto& group : groups)
    group =
        static_cast<int>(std::lower_bound(present.begin(), present.end(), group) - present.begin());
  return groups;
}

void Elimination::order(const std::vector<int>& groups) {
  const auto& open = tree_.open_;
  std::vector<std::vector<int>> sets;
  sets.reserve(tree_.open_factors_.size() + tree_.orphans_.size());
  for (const FactorId id : tree_.open_factors_) {
    sets.emplace_back();
    for (const Key key : tree_.factors_[at(id)].factor.keys) sets.back().push_back(placeOf(key));
  }
  for (const int orphan : tree_.orphans_) {
    const auto& clique = tree_.clique(orphan);
    sets.emplace_back();
    for (auto i = at(clique.frontals); i < clique.keys.size(); ++i)
      sets.back().push_back(placeOf(clique.keys[i]));
  }
  const auto order = eliminationOrder(static_cast<int>(open.size()), sets, groups);
  for (std::size_t i = 0; i < order.size(); ++i) {
    columns_[i].key = open[at(order[i])];
    places_[at(columns_[i].key)] = static_cast<int>(i);
  }
}

void Elimination::assign() {
  const auto first = [this](auto begin, auto end) {
    int place = static_cast<int>(columns_.size());
    for (auto key = begin; key != end; ++key) place = std::min(place, placeOf(*key));
    return at(place);
  };
  for (const FactorId id : tree_.open_factors_) {
    const auto& keys = tree_.factors_[at(id)].factor.keys;
    columns_[first(keys.begin(), keys.end())].factors.push_back(id);
  }
  for (const int orphan : tree_.orphans_) {
    const auto& clique = tree_.clique(orphan);
    columns_[first(clique.keys.begin() + clique.frontals, clique.keys.end())].orphans.push_back(
        orphan);
  }
}

void Elimination::findStructure() {
  std::vector<int> mark(columns_.size(), -1);
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    auto& column = columns_[j];
    const auto add = [&](int place) {
      if (place <= static_cast<int>(j) || mark[at(place)] == static_cast<int>(j)) return;
      mark[at(place)] = static_cast<int>(j);
      column.depends.push_back(place);
    };
    for (const FactorId id : column.factors)
      for (const Key key : tree_.factors_[at(id)].factor.keys) add(placeOf(key));
    for (const int orphan : column.orphans) {
      const auto& clique = tree_.clique(orphan);
      for (auto i = at(clique.frontals); i < clique.keys.size(); ++i) add(placeOf(clique.keys[i]));
    }
    for (const int child : column.children)
      for (const int place : columns_[at(child)].depends) add(place);
    std::sort(column.depends.begin(), column.depends.end());
    if (!column.depends.empty())
      columns_[at(column.depends.front())].children.push_back(static_cast<int>(j));
  }
}

/// A variable goes into the clique of a child that depends on the same variables.
void Elimination::formCliques() {
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    auto& column = columns_[j];
    for (const int child : column.children) {
      if (columns_[at(child)].depends.size() != column.depends.size() + 1) continue;
      column.clique = columns_[at(child)].clique;
      members_[j] = std::move(members_[at(child)]);
      members_[at(child)].clear();
      break;
    }
    if (column.clique < 0) column.clique = tree_.newClique();
    members_[j].push_back(static_cast<int>(j));
  }
}

void Elimination::eliminate(std::size_t last) {
  const int id = columns_[last].clique;
  auto& clique = tree_.clique(id);
  gather(clique, last);
  adopt(id, members_[last]);
  Eigen::MatrixXd matrix = front(clique);
  const int f = clique.frontal_rows, s = clique.rows - f;
  factorize(matrix.topLeftCorner(f, f));
  Eigen::Ref<Eigen::MatrixXd> triangle = matrix.topLeftCorner(f, f);
  auto below = matrix.bottomLeftCorner(s, f);
  triangle.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
  matrix.bottomRightCorner(s, s).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  clique.columns = matrix.leftCols(f);
  clique.schur = matrix.bottomRightCorner(s, s);
  tree_.substitute(clique);
  tree_.eliminated_rows_ += f;
  if (columns_[last].depends.empty()) tree_.roots_.push_back(id);
}

/// Puts the Cholesky factor into the lower triangle. Where the factors of the graph do not
/// determine the variables, they are held where they are with a little weight, or with more than
/// the sum of each row where rounding has left less than nothing of what determined them.
void Elimination::factorize(Eigen::Ref<Eigen::MatrixXd> matrix) {
  constexpr double kLeast = 1e-12, kStep = 100.0;
  constexpr int kTries = 8;
  const auto fail = [] { throw std::domain_error("the graph holds values that are not finite"); };
  if (!matrix.allFinite()) fail();
  const Eigen::MatrixXd H = matrix;
  const double largest = H.diagonal().cwiseAbs().maxCoeff();
  double weight = kLeast * std::max(1.0, largest);
  for (int i = 0; i < kTries; ++i) {
    if (isFactorized(matrix)) return;
    if (i == 0) ++tree_.undetermined_;
    matrix = H;
    matrix.diagonal().array() += weight;
    weight *= kStep;
  }
  matrix = H;
  matrix.diagonal().array() += std::max(1.0, 2.0 * largestRow(H));
  if (!isFactorized(matrix)) fail();
}

/// The clique of some columns, the last of which is given.
void Elimination::gather(BayesTree::Clique& clique, std::size_t last) {
  clique.keys.clear();
  for (const int member : members_[last]) clique.keys.push_back(columns_[at(member)].key);
  for (const int place : columns_[last].depends) clique.keys.push_back(columns_[at(place)].key);
  clique.frontals = static_cast<int>(members_[last].size());
  clique.rows = clique.frontal_rows = 0;
  for (std::size_t i = 0; i < clique.keys.size(); ++i) {
    tree_.row_of_[at(clique.keys[i])] = clique.rows;
    clique.rows += tree_.rows(clique.keys[i]);
    if (i + 1 == at(clique.frontals)) clique.frontal_rows = clique.rows;
  }
  clique.is_open = false;
  clique.parent = -1;  // until the parent adopts it
}

/// Gives the clique the factors and children of its columns.
void Elimination::adopt(int id, const std::vector<int>& members) {
  auto& clique = tree_.clique(id);
  clique.factors.clear();
  clique.children.clear();
  for (const int member : members) {
    const auto& column = columns_[at(member)];
    tree_.clique_of_[at(column.key)] = id;
    for (const FactorId factor : column.factors) {
      tree_.factors_[at(factor)].clique = id;
      clique.factors.push_back(factor);
    }
    clique.children.insert(clique.children.end(), column.orphans.begin(), column.orphans.end());
    for (const int child : column.children)
      if (columns_[at(child)].clique != id) clique.children.push_back(columns_[at(child)].clique);
  }
  for (const int child : clique.children) tree_.clique(child).parent = id;
}

/// The sum of what the clique's factors and its children say of its variables.
Eigen::MatrixXd Elimination::front(const BayesTree::Clique& clique) {
  Eigen::MatrixXd front = Eigen::MatrixXd::Zero(clique.rows, clique.rows);
  for (const FactorId id : clique.factors) addFactor(tree_.factors_[at(id)].factor, front);
  for (const int child : clique.children) addSchur(tree_.clique(child), front);
  return front;
}

void Elimination::addFactor(const QuadraticFactor& factor, Eigen::MatrixXd& front) const {
  int row = 0;
  for (const Key a : factor.keys) {
    const int rows = tree_.rows(a), to = tree_.row_of_[at(a)];
    int column = 0;
    for (const Key b : factor.keys) {
      const int columns = tree_.rows(b), from = tree_.row_of_[at(b)];
      if (from <= to)
        front.block(to, from, rows, columns) += factor.H.block(row, column, rows, columns);
      column += columns;
    }
    row += rows;
  }
}

void Elimination::addSchur(const BayesTree::Clique& child, Eigen::MatrixXd& front) const {
  struct Part {
    int row, to, rows;
  };
  std::vector<Part> parts;
  int row = 0;
  for (auto i = at(child.frontals); i < child.keys.size(); ++i) {
    const int rows = tree_.rows(child.keys[i]);
    parts.push_back({row, tree_.row_of_[at(child.keys[i])], rows});
    row += rows;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const auto &a = parts[i], &b = parts[j];
      if (i == j) {
        for (int c = 0; c < a.rows; ++c)
          front.col(a.to + c).segment(a.to + c, a.rows - c) +=
              child.schur.col(a.row + c).segment(a.row + c, a.rows - c);
      } else if (a.to > b.to) {
        front.block(a.to, b.to, a.rows, b.rows) += child.schur.block(a.row, b.row, a.rows, b.rows);
      } else {
        front.block(b.to, a.to, b.rows, a.rows) +=
            child.schur.block(a.row, b.row, a.rows, b.rows).transpose();
      }
    }
}

}  // namespace slam::graph
