// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "slam_core/graph/quadratic_factor.hpp"
#include "slam_core/graph/vicinity.hpp"

namespace slam::graph {

/// The Cholesky factor of sparse normal equations H x = g as a tree of cliques (Bayes tree: Kaess,
/// Johannsson, Roberts, Ila, Leonard, Dellaert 2012). For a new or changed factor the cliques
/// between its variables and the root are eliminated again.
///
/// Call order: any number of changes, then update(), then solve().
class BayesTree {
 public:
  /// @return the key of a new variable with this number of rows. The key of a variable that was
  /// removed before the last update() is used again
  Key addVariable(int rows);
  /// Removes a variable that no factor holds any more. Its key is invalid until addVariable()
  /// returns it again.
  friend void removeVariable(BayesTree& tree, Key key);

  FactorId addFactor(QuadraticFactor factor);
  /// Replaces H and g of a factor.
  void replace(FactorId id, const Eigen::MatrixXd& H, const Eigen::VectorXd& g);
  void removeFactor(FactorId id);

  /// Brings the tree up to date with all changes.
  /// @param last variables to eliminate last, since the next factors will touch them
  /// @param vicinity decides on the order of the others
  /// @throw std::domain_error if factors hold values that are not finite; then the tree cannot be
  /// used any more
  void update(const std::vector<Key>& last, const Vicinity& vicinity = {});

  /// Computes the minimum again where it has changed: first in cliques that were eliminated since
  /// the last time, then in those near the root, then in those that have waited longest.
  /// @param threshold a variable that has moved by less does not move those that depend on it
  /// @param most numbers of the Cholesky factor that are read of cliques that were not eliminated
  /// since; the others wait for the next time
  /// @return the variables that moved by more than the threshold
  const std::vector<Key>& solve(double threshold = 0.0, std::size_t most = kAll);
  Eigen::VectorBlock<const Eigen::VectorXd> solution(Key key) const {
    return static_cast<const Eigen::VectorXd&>(solution_).segment(offsets_[index(key)],
                                                                  rows_[index(key)]);
  }
  /// The minimum of all variables, one after the other, where nothing waits.
  friend Eigen::VectorXd solved(const BayesTree& tree);
  /// Makes the solution of a variable its new origin, so that the solution becomes 0. The gradients
  /// of all its factors have to be replaced before the next update().
  void moveOrigin(Key key);

  /// The covariance of some variables, the inverse of H: rows in the order of the keys.
  Eigen::MatrixXd covariance(const std::vector<Key>& keys) const;

  /// What the tree costs.
  struct Cost {
    std::size_t bytes;    ///< of the numbers it holds
    int eliminated_rows;  ///< by the last update()
    int undetermined;     ///< cliques of those whose variables are held where they are, since no
                          ///< factor determines them or their solution is absurd
  };
  Cost cost() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(rows_, offsets_, clique_of_, cliques_, free_, roots_, factors_, free_factors_,
            free_keys_, open_, open_factors_, orphans_, changed_, touched_, removed_,
            eliminated_rows_, undetermined_, solution_, spread_, waiting_, moved_, row_of_);
  }

 private:
  friend class Elimination;

  /// Variables that are eliminated together (the frontal ones), and those on which they depend (the
  /// separator).
  struct Clique {
    std::vector<Key> keys;  ///< frontal ones first
    int frontals = 0;       ///< how many of the keys
    int frontal_rows = 0, rows = 0;
    Eigen::MatrixXd columns;  ///< of the Cholesky factor: the triangle, the separator's rows below
    Eigen::MatrixXd schur;    ///< what elimination leaves on the separator; the lower half
    Eigen::VectorXd rhs;      ///< of the triangular system
    Eigen::VectorXd schur_rhs;      ///< what elimination leaves of g on the separator
    std::vector<FactorId> factors;  ///< of which a frontal variable is the first one eliminated
    std::vector<int> children;
    int parent = -1;
    bool is_open = false;       ///< it was taken out of the tree
    bool is_due = false;        ///< its part of the solution was never computed
    bool is_waiting = false;    ///< to be computed again
    Eigen::VectorXd separator;  ///< the solution there by which its own part was computed

    template <class Archive>
    void persist(Archive& archive) {
      archive(keys, frontals, frontal_rows, rows, columns, schur, rhs, schur_rhs, factors, children,
              parent, is_open, is_due, is_waiting, separator);
    }
  };
  struct StoredFactor {
    QuadraticFactor factor;
    int clique = -1;  ///< that holds it; -1: none yet

    template <class Archive>
    void persist(Archive& archive) {
      archive(factor, clique);
    }
  };
  /// The rows of L^-1 E that one clique holds, where E are the columns of a variable.
  struct ForwardRows {
    int clique;
    Eigen::MatrixXd rows;
  };

  static constexpr auto kAll = std::numeric_limits<std::size_t>::max();
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int rows(Key key) const { return rows_[index(key)]; }
  Clique& clique(int i) { return cliques_[index(i)]; }
  const Clique& clique(int i) const { return cliques_[index(i)]; }
  int newClique();
  void open(int clique);
  void openAll();
  void freeRemoved();
  void giveMemoryBack();
  void substitute(Clique& clique);
  Eigen::VectorXd onSeparator(const Clique& clique, const Eigen::VectorXd& x) const;
  Eigen::VectorXd onFrontals(const Clique& clique, const Eigen::VectorXd& separator) const;
  bool isOutdated(const Clique& clique) const;
  void solve(Clique& clique, double threshold);
  void solveNew(std::vector<int>& below, double threshold);
  void solveBelow(std::vector<int>& cliques, double threshold, std::size_t& left);
  bool isRenewed(Clique& clique, double threshold, std::size_t& left);
  void solveWaiting(double threshold, std::size_t left);
  void wait(const std::vector<int>& cliques);
  std::vector<ForwardRows> forward(Key key) const;

  std::vector<int> rows_, offsets_;  ///< of each variable
  std::vector<int> clique_of_;       ///< that eliminates a variable; -1: none yet
  std::vector<Clique> cliques_;
  std::vector<int> free_, roots_;
  std::vector<StoredFactor> factors_;
  std::vector<FactorId> free_factors_;
  std::vector<Key> free_keys_;

  // since the last update()
  std::vector<Key> open_;               ///< variables to eliminate
  std::vector<FactorId> open_factors_;  ///< to eliminate
  std::vector<int> orphans_;            ///< cliques whose parents were taken out
  std::vector<int> changed_;            ///< cliques to open
  std::vector<Key> touched_;            ///< variables whose cliques are to open
  std::vector<Key> removed_;            ///< variables that are gone
  int eliminated_rows_ = 0, undetermined_ = 0;

  Eigen::VectorXd solution_;
  Eigen::VectorXd spread_;    ///< the part of the solution that the cliques below know of
  std::vector<int> waiting_;  ///< cliques whose parts of the solution are outdated, or were; the
                              ///< one that has waited longest first
  std::vector<Key> moved_;
  mutable std::vector<int> row_of_;  ///< of each variable in the clique at work
};

void removeVariable(BayesTree& tree, Key key);
Eigen::VectorXd solved(const BayesTree& tree);

}  // namespace slam::graph
