// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/optimizer.hpp"

namespace slam::graph {
namespace {

/// A tree from which variables go, and what it holds, to be solved as a dense matrix.
class Changing {
 public:
  Key addVariable(int rows) {
    const Key key = tree.addVariable(rows);
    EXPECT_EQ(rows_.count(key), 0u) << "the key is in use";
    rows_[key] = rows;
    addFactor({key});
    return key;
  }
  void addFactor(const std::vector<Key>& keys) {
    Eigen::Index rows = 0;
    for (const Key key : keys) rows += rows_.at(key);
    Eigen::MatrixXd A(rows, rows);
    for (Eigen::Index i = 0; i < A.size(); ++i) A(i) = random_.gaussian();
    Eigen::VectorXd b(rows);
    for (Eigen::Index i = 0; i < rows; ++i) b[i] = random_.gaussian();
    const QuadraticFactor factor{keys, A.transpose() * A, b};
    factors_[tree.addFactor(factor)] = factor;
  }
  void removeVariable(Key key) {
    for (auto it = factors_.begin(); it != factors_.end();) {
      const auto& keys = it->second.keys;
      const bool holds = std::find(keys.begin(), keys.end(), key) != keys.end();
      if (holds) tree.removeFactor(it->first);
      it = holds ? factors_.erase(it) : std::next(it);
    }
    slam::graph::removeVariable(tree, key);
    rows_.erase(key);
  }
  Key any() {
    auto it = rows_.begin();
    std::advance(it, static_cast<int>(random_.uniform() * static_cast<double>(rows_.size())));
    return it->first;
  }
  std::size_t size() const { return rows_.size(); }

  void expectDenseSolution() {
    tree.update({rows_.rbegin()->first});
    tree.solve();
    std::map<Key, int> offsets;
    int size = 0;
    for (const auto& [key, rows] : rows_) {
      offsets[key] = size;
      size += rows;
    }
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
    for (const auto& [id, factor] : factors_) {
      std::vector<int> at;
      for (const Key key : factor.keys)
        for (int i = 0; i < rows_.at(key); ++i) at.push_back(offsets.at(key) + i);
      for (std::size_t i = 0; i < at.size(); ++i) {
        g(at[i]) += factor.g(static_cast<int>(i));
        for (std::size_t j = 0; j < at.size(); ++j)
          H(at[i], at[j]) += factor.H(static_cast<int>(i), static_cast<int>(j));
      }
    }
    const Eigen::VectorXd x = H.ldlt().solve(g);
    const Eigen::MatrixXd P = H.inverse();
    for (const auto& [key, rows] : rows_) {
      const int at = offsets.at(key);
      EXPECT_LT((tree.solution(key) - x.segment(at, rows)).norm(), 1e-7 * (1 + x.norm()));
      EXPECT_TRUE(tree.covariance({key}).isApprox(P.block(at, at, rows, rows), 1e-6));
    }
  }

  BayesTree tree;

 private:
  std::map<Key, int> rows_;
  std::map<FactorId, QuadraticFactor> factors_;
  RandomStream random_{11, 0};
};

TEST(VariableRemoval, LeavesTheSolutionOfADenseSolver) {
  Changing graph;
  Key before = graph.addVariable(3);
  for (int i = 1; i < 200; ++i) {
    const Key key = graph.addVariable(i % 4 == 0 ? 2 : 3);
    graph.addFactor({before, key});
    before = key;
    if (const Key other = graph.any(); i % 3 == 0 && other != key) graph.addFactor({other, key});
    for (int k = 0; k < 2 && graph.size() > 40; ++k)
      if (const Key gone = graph.any(); gone != key) graph.removeVariable(gone);
    graph.expectDenseSolution();
  }
}

TEST(VariableRemoval, TakesBackAVariableThatWasNeverEliminated) {
  Changing graph;
  graph.addVariable(3);
  graph.removeVariable(graph.addVariable(3));
  graph.expectDenseSolution();
  EXPECT_EQ(graph.size(), 1u);
}

TEST(VariableRemoval, UsesKeysAndMemoryAgain) {
  Changing graph;
  std::vector<Key> chain;
  std::size_t bytes = 0;
  Key largest = 0;
  for (int i = 0; i < 500; ++i) {
    chain.push_back(graph.addVariable(3));
    if (i > 0) graph.addFactor({*(chain.end() - 2), chain.back()});
    if (chain.size() > 20) {
      graph.removeVariable(chain.front());
      chain.erase(chain.begin());
    }
    graph.tree.update({chain.back()});
    largest = std::max(largest, chain.back());
    if (i == 100) bytes = graph.tree.cost().bytes;
  }
  EXPECT_LE(largest, 22);
  EXPECT_LT(graph.tree.cost().bytes, 2 * bytes);
  while (chain.size() > 1) {
    graph.removeVariable(chain.back());
    chain.pop_back();
  }
  graph.tree.update({chain.back()});
  EXPECT_LT(graph.tree.cost().bytes, bytes / 4);
}

/// A pose between two motions may go without a trace, where their composition stays.
TEST(VariableRemoval, OfAPoseLeavesItsNeighboursWhereTheyWere) {
  const Eigen::Matrix3d W = 50 * Eigen::Matrix3d::Identity();
  Optimizer optimizer;
  for (int i = 0; i < 3; ++i) optimizer.add(Pose2(i, 0, 0));
  optimizer.add(std::make_unique<PosePrior>(0, Pose2(), W));
  const auto first = optimizer.add(std::make_unique<Between>(0, 1, Pose2(1, 0.1, 0.2), W));
  const auto second = optimizer.add(std::make_unique<Between>(1, 2, Pose2(1, 0.1, 0.2), W));
  optimizer.optimize({2}, 10);
  const Pose2 before = optimizer.pose(2);
  const Eigen::Matrix3d P = optimizer.covariance({2});
  const Pose2 step(1, 0.1, 0.2);
  const Eigen::Matrix3d A = step.inverse().adjoint();
  const Eigen::Matrix3d R = Eigen::Matrix3d::Identity() / (50.0 * 50.0);
  optimizer.remove(first);
  optimizer.remove(second);
  removeVariable(optimizer, 1);
  const Pose2 joined = step * step;
  const Eigen::Matrix3d of_both = A * R * A.transpose() + R;
  optimizer.add(std::make_unique<Between>(0, 2, joined, weightOfCovariance(of_both)));
  optimizer.optimize({2}, 10);
  EXPECT_LT(optimizer.pose(2).between(before).vector().norm(), 1e-9);
  EXPECT_TRUE(optimizer.covariance({2}).isApprox(P, 1e-2));
  EXPECT_EQ(optimizer.add(Pose2(7, 0, 0)), 1) << "the key is used again";
  EXPECT_EQ(optimizer.pose(1).x(), 7.0);
}

}  // namespace
}  // namespace slam::graph
