// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/graph/bayes_tree.hpp"

namespace slam::graph {

/// Eliminates the open variables of a tree once: first symbolically, then numerically clique by
/// clique (multifrontal: Liu 1992).
class Elimination {
 public:
  Elimination(BayesTree& tree, const std::vector<Key>& last, const Vicinity& vicinity);
  /// @throw std::domain_error if factors hold values that are not finite
  void run();

 private:
  /// A variable at its place in the order, with the factors and cliques whose first variable it is.
  struct Column {
    Key key;
    std::vector<FactorId> factors;
    std::vector<int> orphans;
    std::vector<int> depends;   ///< places on which it depends once eliminated, increasing
    std::vector<int> children;  ///< places whose first dependency it is
    int clique = -1;            ///< that it is a frontal variable of
  };

  void order(const std::vector<int>& groups);
  std::vector<int> groupsOf(const std::vector<Key>& last, const Vicinity& vicinity) const;
  void assign();
  void findStructure();
  void formCliques();
  void eliminate(std::size_t column);
  void factorize(Eigen::Ref<Eigen::MatrixXd> matrix);
  void gather(BayesTree::Clique& clique, std::size_t last);
  void adopt(int id, const std::vector<int>& members);
  Eigen::MatrixXd front(const BayesTree::Clique& clique);
  void addFactor(const QuadraticFactor& factor, Eigen::MatrixXd& front) const;
  void addSchur(const BayesTree::Clique& child, Eigen::MatrixXd& front) const;

  int placeOf(Key key) const { return places_[BayesTree::index(key)]; }

  BayesTree& tree_;
  std::vector<int> places_;  ///< of each variable of the tree in the order
  std::vector<Column> columns_;
  std::vector<std::vector<int>> members_;  ///< columns of a new clique, at its last column
};

}  // namespace slam::graph
