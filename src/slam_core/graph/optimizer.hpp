// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "slam_core/graph/bayes_tree.hpp"
#include "slam_core/graph/factor.hpp"
#include "slam_core/graph/factor_archive.hpp"

namespace slam::graph {

struct OptimizerLimits {
  /// If a variable is further than this [m, rad] from where its factors were linearised, all of
  /// them are linearised again, at one place.
  double correction = 2e-2;
  /// Points are excepted: each of their factors is linearised again by itself, when its
  /// Factor::moved() exceeds `correction`. So local maps that are carried along as a whole stay as
  /// they are. It must not be so where points stand for
  /// parameters that many factors share: linearised at several places, these would seem to tell
  /// what none of them does (Huang et al. 2010).
  bool points_by_factor = true;
  /// A smaller change of a variable [m, rad] is not passed on to other variables.
  double change = 1e-3;
  /// A factor that joins only points waits until variables are gathered (Vicinity). It does not
  /// wait if its Factor::moved() exceeds this many times `correction` [1].
  double patience = 1.0;
  /// A step passes changes on to parts of the graph that it has not eliminated, and reads at most
  /// this many numbers of the Cholesky factor for it [1]. Other changes wait for the next steps.
  std::size_t passed_on = std::numeric_limits<std::size_t>::max();
};

/// The residuals of some factors, one after the other, with their joint covariance: the sum of
/// their own, which is the identity, and of that of the graph's estimate.
struct Innovation {
  Eigen::VectorXd r;
  Eigen::MatrixXd S;
  double nis() const;
};

using FactorVisitor = std::function<void(const Factor& factor, double weight)>;
/// The contents of a graph, to be saved.
struct GraphContents {
  std::vector<std::shared_ptr<const Factor>> factors;  ///< by number; null where one was removed
  std::vector<bool> is_pose;                           ///< of each variable there has ever been
};

/// Nonlinear least squares over a graph that grows: each update() is one Gauss-Newton step, in
/// which only what has changed is computed.
class Optimizer {
 public:
  explicit Optimizer(const OptimizerLimits& limits = {}) : limits_(limits) {}

  /// @return the key of a new variable, which may be that of a removed one
  Key add(const Pose2& pose);
  Key add(const Eigen::Vector2d& point);
  /// Removes a variable whose factors have all been removed.
  friend void removeVariable(Optimizer& graph, Key key);
  FactorId add(std::shared_ptr<const Factor> factor);
  void remove(FactorId id);
  /// Multiplies a factor's share of chi2 by a weight, which is 1 at first.
  void set(FactorId id, double weight);

  /// Moves a point. Its factors stay as they are.
  void set(Key key, const Eigen::Vector2d& point);

  /// One step. @param last variables that the next factors will touch
  /// @param vicinity of these
  /// @return whether another step would linearise factors again, without those that wait
  /// @throw std::domain_error if factors hold values that are not finite
  bool update(const std::vector<Key>& last, const Vicinity& vicinity = {});
  /// Steps in which nothing is left out, until they are over.
  /// @return whether the last of so many steps has moved no variable by more than 0.1 mm or 0.1
  /// mrad
  bool optimize(const std::vector<Key>& last, int most_steps);

  /// The estimate of a variable. A point is returned as a pose of which only the position is valid.
  Pose2 pose(Key key) const { return variables_.corrected(key, tree_.solution(key)); }
  /// The estimates of all variables as they are when all changes have been passed on.
  friend std::vector<Pose2> settled(const Optimizer& graph);
  /// The covariance describes corrections of these variables (Variables), rows in the order of the
  /// keys.
  Eigen::MatrixXd covariance(const std::vector<Key>& keys) const { return tree_.covariance(keys); }
  /// Returns the squared residual of a factor, without its weight. It need not be in the graph.
  double chi2(const Factor& factor) const;
  double chi2() const;  ///< of all factors, with their weights
  /// Compares factors that are not in the graph with the graph's prediction of them.
  Innovation innovation(const std::vector<const Factor*>& factors) const;
  BayesTree::Cost cost() const { return tree_.cost(); }

  friend const Factor& factorOf(const Optimizer& graph, FactorId id) {
    return *graph.terms_[index(id)].factor;
  }
  /// Calls a function for each factor of the graph, with its weight, in the order of their ids.
  friend void visitFactors(const Optimizer& graph, const FactorVisitor& look);

  template <class Archive>
  void persist(Archive& archive) {
    archive(variables_, terms_, terms_of_, tree_, moved_, due_, postponed_);
  }

 private:
  friend GraphContents contentsOf(const Optimizer& graph);
  friend void eliminate(Optimizer& graph, const std::vector<Key>& last);

  struct Term {
    std::shared_ptr<const Factor> factor;
    double weight = 1.0;
    std::vector<Pose2> at;  ///< where it was linearised, in the order of its keys

    template <class Archive>
    void persist(Archive& archive) {
      persistFactor(archive, factor);
      archive(weight, at);
    }
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double excess(FactorId id) const;
  void findOutdated();
  bool joinsPointsAlone(const Factor& factor) const;
  void relinearize(bool with_postponed);
  void relinearizeAll();
  void moveOrigin(Key key);
  bool goesByFactor(Key key) const { return limits_.points_by_factor && variables_.rows(key) == 2; }
  bool isFarAsAWhole(Key key) const {
    return !goesByFactor(key) && isFurther(key, limits_.correction);
  }
  bool isFurther(Key key, double limit) const {
    return tree_.solution(key).cwiseAbs().maxCoeff() > limit;
  }
  template <class Value>
  Key addVariable(const Value& value, int rows);
  QuadraticFactor linearize(Term& term) const;
  void refresh(FactorId id);
  std::vector<Pose2> linearizationOf(const Factor& factor) const;
  LinearFactor atEstimate(const Factor& factor) const;

  OptimizerLimits limits_;
  Variables variables_;  ///< the origins of the corrections
  std::vector<Term> terms_;
  std::vector<std::vector<FactorId>> terms_of_;  ///< by variable
  BayesTree tree_;
  std::vector<Key> moved_;  ///< by the last step
  /// Factors to be linearised again, in increasing order: with the next step, and with the next one
  /// that gathers variables.
  std::vector<FactorId> due_, postponed_;
};

GraphContents contentsOf(const Optimizer& graph);
/// Brings the covariances up to date without moving any variable, for example in a graph that was
/// loaded.
/// @throw std::domain_error as Optimizer::update()
void eliminate(Optimizer& graph, const std::vector<Key>& last);

}  // namespace slam::graph
