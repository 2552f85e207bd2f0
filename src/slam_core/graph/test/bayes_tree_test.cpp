// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/bayes_tree.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "slam_core/common/random.hpp"

namespace slam::graph {
namespace {

/// The same system as a dense matrix.
class DenseSystem {
 public:
  void addVariable(int rows) {
    offsets_.push_back(rows_);
    rows_ += rows;
  }
  void set(FactorId id, const QuadraticFactor& factor) { factors_[id] = factor; }
  void remove(FactorId id) { factors_.erase(id); }

  Eigen::MatrixXd H() const {
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(rows_, rows_);
    for (const auto& [id, factor] : factors_)
      for (Eigen::Index i = 0; i < factor.H.rows(); ++i)
        for (Eigen::Index j = 0; j < factor.H.cols(); ++j)
          H(row(factor, i), row(factor, j)) += factor.H(i, j);
    return H;
  }
  Eigen::VectorXd g() const {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(rows_);
    for (const auto& [id, factor] : factors_)
      for (Eigen::Index i = 0; i < factor.g.size(); ++i) g[row(factor, i)] += factor.g[i];
    return g;
  }
  int offset(Key key) const { return offsets_[static_cast<std::size_t>(key)]; }

 private:
  int rows(Key key) const {
    const auto next = static_cast<std::size_t>(key) + 1;
    return (next < offsets_.size() ? offsets_[next] : rows_) - offset(key);
  }
  Eigen::Index row(const QuadraticFactor& factor, Eigen::Index i) const {
    for (const Key key : factor.keys) {
      if (i < rows(key)) return offset(key) + i;
      i -= rows(key);
    }
    throw std::logic_error("a factor has more rows than its variables");
  }

  std::vector<int> offsets_;
  int rows_ = 0;
  std::map<FactorId, QuadraticFactor> factors_;
};

/// A tree and a dense system that get the same.
class Systems {
 public:
  Key addVariable(int rows) {
    dense.addVariable(rows);
    rows_.push_back(rows);
    return tree.addVariable(rows);
  }
  QuadraticFactor randomFactor(const std::vector<Key>& keys) {
    Eigen::Index rows = 0;
    for (const Key key : keys) rows += rows_[static_cast<std::size_t>(key)];
    Eigen::MatrixXd A(rows, rows);
    for (Eigen::Index i = 0; i < A.size(); ++i) A(i) = random_.gaussian();
    Eigen::VectorXd b(rows);
    for (Eigen::Index i = 0; i < rows; ++i) b[i] = random_.gaussian();
    return {keys, A.transpose() * A, b};
  }
  FactorId addFactor(const std::vector<Key>& keys) {
    const auto factor = randomFactor(keys);
    const FactorId id = tree.addFactor(factor);
    dense.set(id, factor);
    return id;
  }
  void replace(FactorId id, const std::vector<Key>& keys) {
    const auto factor = randomFactor(keys);
    tree.replace(id, factor.H, factor.g);
    dense.set(id, factor);
  }
  void remove(FactorId id) {
    tree.removeFactor(id);
    dense.remove(id);
  }
  int rows(Key key) const { return rows_[static_cast<std::size_t>(key)]; }
  int below(int n) { return static_cast<int>(random_.uniform() * n); }

  void expectSameSolution(Key last) {
    tree.update({last});
    tree.solve();
    const Eigen::VectorXd x = dense.H().ldlt().solve(dense.g());
    for (Key key = 0; key <= last; ++key)
      EXPECT_TRUE(tree.solution(key).isApprox(x.segment(dense.offset(key), rows(key)), 1e-8))
          << "variable " << key;
  }

  BayesTree tree;
  DenseSystem dense;

 private:
  std::vector<int> rows_;
  RandomStream random_{7, 0};
};

/// A chain with points beside it and loops, one variable after the other.
TEST(BayesTree, SolvesAGraphThatGrowsAsADenseSolverDoes) {
  Systems systems;
  systems.addFactor({systems.addVariable(3)});
  std::map<FactorId, std::vector<Key>> loops;
  for (int i = 1; i < 120; ++i) {
    const Key key = systems.addVariable(i % 4 == 0 ? 2 : 3);
    systems.addFactor({key - 1, key});
    if (i % 3 == 0) {
      const std::vector<Key> ends = {systems.below(i), key};
      loops[systems.addFactor(ends)] = ends;
    }
    if (i % 10 == 0) systems.addFactor({systems.below(i - 8), key - 3, key});
    if (i % 17 == 0) systems.replace(loops.begin()->first, loops.begin()->second);
    if (i % 31 == 0) {
      systems.remove(loops.rbegin()->first);
      loops.erase(loops.rbegin()->first);
    }
    systems.expectSameSolution(key);
  }
}

/// Changes that wait come to all variables in the end; solved() has them at once.
TEST(BayesTree, PassesChangesOnInSeveralSteps) {
  constexpr int kVariables = 200, kMostSteps = 2000;
  constexpr std::size_t kNumbers = 40;
  Systems systems;
  systems.addFactor({systems.addVariable(3)});
  for (int i = 1; i < kVariables; ++i) systems.addFactor({i - 1, systems.addVariable(3)});
  systems.expectSameSolution(kVariables - 1);
  systems.addFactor({kVariables - 1});
  systems.tree.update({kVariables - 1});
  const Eigen::VectorXd x = systems.dense.H().ldlt().solve(systems.dense.g());
  systems.tree.solve(0.0, kNumbers);
  EXPECT_TRUE(systems.tree.solution(kVariables - 1).isApprox(x.tail<3>(), 1e-8));
  EXPECT_TRUE(solved(systems.tree).isApprox(x, 1e-8));
  int steps = 1;
  while (!systems.tree.solve(0.0, kNumbers).empty() && steps < kMostSteps) ++steps;
  EXPECT_GT(steps, 1);
  for (Key key = 0; key < kVariables; ++key)
    EXPECT_TRUE(systems.tree.solution(key).isApprox(x.segment<3>(3 * key), 1e-8)) << key;
}

/// Gathered variables are eliminated again, and near ones come last.
TEST(BayesTree, BringsWhatIsGatheredToTheTop) {
  Systems systems;
  systems.addFactor({systems.addVariable(3)});
  for (int i = 1; i < 200; ++i) systems.addFactor({i - 1, systems.addVariable(3)});
  systems.expectSameSolution(199);
  Vicinity vicinity{{50, 51, 52}, [](Key key) { return key >= 50 && key <= 52 ? 0 : 1; }};
  systems.tree.update({199}, vicinity);
  systems.expectSameSolution(199);
  vicinity.gathered.clear();
  for (const Key key : {51, 50, 52}) {
    systems.addFactor({key, 199});
    systems.tree.update({199}, vicinity);
    EXPECT_LE(systems.tree.cost().eliminated_rows, 15);
  }
  systems.expectSameSolution(199);
}

TEST(BayesTree, HasTheCovariancesOfTheDenseInverse) {
  Systems systems;
  systems.addFactor({systems.addVariable(3)});
  for (int i = 1; i < 60; ++i) {
    const Key key = systems.addVariable(i % 2 == 0 ? 2 : 3);
    systems.addFactor({key - 1, key});
    if (i % 5 == 0) systems.addFactor({systems.below(i), key});
    systems.tree.update({key});
  }
  const Eigen::MatrixXd P = systems.dense.H().inverse();
  const std::vector<Key> keys = {40, 3, 59};
  const auto joint = systems.tree.covariance(keys);
  int row = 0;
  for (const Key a : keys) {
    int column = 0;
    for (const Key b : keys) {
      const int rows = systems.rows(a), columns = systems.rows(b);
      EXPECT_TRUE(
          joint.block(row, column, rows, columns)
              .isApprox(P.block(systems.dense.offset(a), systems.dense.offset(b), rows, columns),
                        1e-8));
      column += columns;
    }
    row += systems.rows(a);
  }
}

TEST(BayesTree, EliminatesLittleWhereLittleIsNew) {
  Systems systems;
  systems.addFactor({systems.addVariable(3)});
  for (int i = 1; i < 1000; ++i) {
    systems.addFactor({i - 1, systems.addVariable(3)});
    systems.tree.update({i});
    EXPECT_LE(systems.tree.cost().eliminated_rows, 9);
  }
}

TEST(BayesTree, SolvesGraphsThatDoNotHangTogether) {
  Systems systems;
  for (int part = 0; part < 3; ++part) {
    const Key first = systems.addVariable(3), second = systems.addVariable(2);
    systems.addFactor({first});
    systems.addFactor({first, second});
    systems.expectSameSolution(second);
  }
  EXPECT_TRUE(systems.tree.covariance({0, 4}).block(0, 3, 3, 3).isZero());
  systems.addFactor({0, 4});
  systems.expectSameSolution(4);
}

TEST(BayesTree, HoldsAVariableThatNothingDetermines) {
  BayesTree tree;
  const Key key = tree.addVariable(2);
  tree.addFactor({{key}, Eigen::Vector2d(2, 0).asDiagonal(), Eigen::Vector2d(1, 0)});
  tree.update({key});
  tree.solve();
  EXPECT_EQ(tree.cost().undetermined, 1);
  EXPECT_NEAR(tree.solution(key)[0], 0.5, 1e-9);
  EXPECT_EQ(tree.solution(key)[1], 0.0);
  EXPECT_GT(tree.covariance({key})(1, 1), 1e9);
}

/// What rounding leaves of a very large element may be negative and as large as anything else.
TEST(BayesTree, HoldsWhatRoundingLeavesWithLessThanNothing) {
  for (const double left : {-1e283, -1e4, -1.0, -1e-20}) {
    BayesTree tree;
    const std::vector<Key> keys = {tree.addVariable(3), tree.addVariable(1)};
    Eigen::Matrix4d H = Eigen::Matrix4d::Constant(0.9 * left);
    H.diagonal().setConstant(left);
    tree.addFactor({keys, H, Eigen::Vector4d::Ones()});
    ASSERT_NO_THROW(tree.update({keys[1]})) << left;
    tree.solve();
    EXPECT_GT(tree.cost().undetermined, 0) << left;
    EXPECT_TRUE(tree.covariance(keys).allFinite()) << left;
    for (const Key key : keys) EXPECT_TRUE(tree.solution(key).allFinite()) << left;
  }
}

TEST(BayesTree, HoldsVariablesWhoseSolutionIsAbsurd) {
  BayesTree tree;
  const Key key = tree.addVariable(1), other = tree.addVariable(1);
  const auto one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  tree.addFactor({{key}, one(1e-9), Eigen::VectorXd::Constant(1, 1e300)});
  tree.addFactor({{other}, one(1.0), Eigen::VectorXd::Constant(1, 2.0)});
  tree.update({});
  tree.solve();
  EXPECT_EQ(tree.solution(key)[0], 0.0);
  EXPECT_EQ(tree.solution(other)[0], 2.0);
  EXPECT_EQ(tree.cost().undetermined, 1);
}

TEST(BayesTree, RefusesValuesThatAreNotFinite) {
  BayesTree tree;
  const Key key = tree.addVariable(1);
  tree.addFactor({{key}, Eigen::MatrixXd::Constant(1, 1, NAN), Eigen::VectorXd::Zero(1)});
  EXPECT_THROW(tree.update({key}), std::domain_error);
}

TEST(BayesTree, KeepsASmallChangeFromVariablesThatDependOnIt) {
  BayesTree tree;
  for (int i = 0; i < 10; ++i) tree.addVariable(1);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  const FactorId first = tree.addFactor({{0}, one, Eigen::VectorXd::Zero(1)});
  Eigen::Matrix2d H;
  H << 1, -1, -1, 1;
  for (int i = 1; i < 10; ++i) tree.addFactor({{i - 1, i}, H, Eigen::Vector2d::Zero()});
  tree.update({9});
  tree.solve(0.1);
  tree.replace(first, one, Eigen::VectorXd::Constant(1, 0.05));
  tree.update({9});
  EXPECT_TRUE(tree.solve(0.1).empty());
  tree.replace(first, one, Eigen::VectorXd::Constant(1, 1.0));
  tree.update({9});
  EXPECT_EQ(tree.solve(0.1).size(), 10u);
  EXPECT_NEAR(tree.solution(0)[0], 1.0, 1e-9);
}

}  // namespace
}  // namespace slam::graph
