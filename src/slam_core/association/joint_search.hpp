// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/options.hpp"

namespace slam::association {

/// The search of the joint compatibility test: of all ways to pair some observations with landmarks
/// that together pass the chi-square test, the one with the most pairings; of several, the most
/// likely one (Neira, Tardos 2001, fig. 4). The factor of the joint covariance grows and shrinks
/// with the branch by two rows, so that a node costs the square of its depth.
class JointSearch {
 public:
  /// An observation of the search with the number of its option; -1 stands for clutter.
  struct Choice {
    std::size_t observation;
    int option;
    bool is_ambiguous;  ///< another choice has as many pairings and is nearly as likely
  };

  /// @param probability that the right pairings together pass the test, in (0, 1)
  /// @param margin by which the cost of another choice has to be larger, see Option
  /// @param nodes pairings that are tried at most
  void configure(double probability, double margin, int nodes);

  /// @param observations each has an option; kMostObservations at most
  /// @param taken landmarks that are paired already
  const std::vector<Choice>& search(const std::vector<std::size_t>& observations,
                                    const Options& options, const CandidateSource& source,
                                    const std::vector<std::size_t>& taken);
  /// Whether the last search ended before all branches had been looked at.
  bool isCutOff() const { return nodes_left_ < 0; }

  static constexpr std::size_t kMostObservations = 32;
  static constexpr std::size_t kMostOptions = 8;  ///< of an observation that are looked at

 private:
  /// An observation of the search, the one with the fewest options first.
  struct Level {
    std::size_t observation;
    std::size_t options;         ///< how many are looked at
    int choice = -1, best = -1;  ///< on this branch; in the best hypothesis
    std::vector<double> costs;   ///< lowest one by option, the last one of clutter
  };
  static constexpr Eigen::Index kRows = 2 * static_cast<Eigen::Index>(kMostObservations);

  void begin(const std::vector<std::size_t>& observations, const std::vector<std::size_t>& taken);
  void visit(std::size_t level);
  void cutOff(std::size_t level);
  void tryOption(std::size_t level, int option);
  bool mayBeBest(std::size_t next_level) const;
  bool isTaken(std::size_t landmark) const;
  const Eigen::Matrix2d& crossCovariance(std::size_t first, std::size_t second);
  std::size_t pairingOf(std::size_t level, int option) const {
    return level * kMostOptions + static_cast<std::size_t>(option);
  }
  const Option& optionOf(std::size_t pairing) const;
  void solveRows(std::size_t pairing);
  bool push(std::size_t pairing);
  void pop();
  void finishBranch();
  void conclude();

  double margin_ = 0.0;
  int nodes_ = 0, nodes_left_ = 0;  ///< below 0 where there were too few
  std::vector<double> gates_;       ///< of the joint test, by pairings

  const Options* options_ = nullptr;
  const CandidateSource* source_ = nullptr;
  std::vector<Level> levels_;
  std::vector<std::size_t> taken_;   ///< landmarks, those of the branch last
  std::vector<std::size_t> branch_;  ///< pairings
  std::vector<double> nis_, costs_;  ///< of the branch up to each pairing
  std::size_t best_pairings_ = 0;
  double best_cost_ = 0.0;
  Eigen::Matrix<double, kRows, kRows, Eigen::RowMajor> L_;  ///< of the branch's covariance L L^T
  Eigen::Matrix<double, kRows, 1> whitened_;                ///< L^-1 nu
  std::vector<Eigen::Matrix2d> cross_;  ///< by two pairings, made when they are needed
  std::vector<char> has_cross_;
  std::vector<Choice> choices_;
};

}  // namespace slam::association
