// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "slam_core/graph/factor_archive.hpp"
#include "slam_core/graph/optimizer.hpp"

namespace slam::graph {

/// Loop closures, any of which may be false. A loop that contradicts the graph waits. A loop that
/// would move the graph by much more than its own noise waits as well, until another one confirms
/// it or many have come that do not contradict it. Loops in the graph are weighted by how well they
/// agree with it (dynamic covariance scaling: Agarwal, Tipaldi, Spinello, Stachniss, Burgard 2013).
/// A believed loop can be taken back, and a waiting one is added when the graph has come to agree
/// with it.
///
/// The noise of loops can be learnt from the believed ones, since information matrices are often a
/// guess. The gates for the first loops are too wide then, and false loops among them would keep
/// true ones out for ever. So once the noise is learnt, all loops so far are judged again.
class RobustLoops {
 public:
  /// Takes steps of the graph until it does not move any more.
  using Settle = std::function<void()>;

  /// Whether the covariances of the loops are used as given, or their scale is learnt.
  enum class Noise { kAsTold, kLearnt };

  /// Counts how often loops were believed and taken back so far.
  struct Changes {
    std::size_t believed = 0, taken_back = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(believed, taken_back);
    }
  };

  /// @param graph outlives this
  RobustLoops(Optimizer& graph, Noise noise) : graph_(graph), learns_(noise == Noise::kLearnt) {}

  /// @param loop between two poses
  /// @return whether it is believed for now; it then is a factor of the graph
  bool add(std::shared_ptr<const Factor> loop);
  /// Settles the graph with the loops that were added, and judges all loops in the result.
  void judge(const Settle& settle);

  /// The state of a loop, to be saved and restored.
  struct State {
    std::shared_ptr<const Factor> factor;
    bool is_believed = false;
    double weight = 1.0;    ///< if it is believed
    bool is_alone = false;  ///< it waits for another one that says the same
  };
  std::vector<State> states() const;
  /// Restores loops before any was added. Believed loops become factors of the graph.
  void restore(const std::vector<State>& states);

  std::size_t size() const { return loops_.size(); }
  /// Whether a loop, counted from 0 in the order of add(), is a factor of the graph.
  bool isBelieved(std::size_t loop) const { return loops_[loop].id.has_value(); }
  /// Whether a loop that is a factor of the graph joins this pose with another one.
  bool believesOneOf(Key pose) const;
  /// Removes all loops of a pose; later ones are renumbered.
  void forget(Key pose);
  /// The number of loops that wait.
  std::size_t rejected() const;
  Changes changes() const { return changes_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(loops_, noise_, taught_, has_new_, changes_);
  }

 private:
  struct Loop {
    std::shared_ptr<const Factor> factor;
    std::optional<FactorId> id;  ///< in the graph
    double weight = 1.0;
    bool is_alone = false;  ///< it waits for another one that says the same

    template <class Archive>
    void persist(Archive& archive) {
      persistFactor(archive, factor);
      archive(id, weight, is_alone);
    }
  };
  void believe(Loop& loop);
  void learnNoise(double nis);
  bool isConfirmed(const Loop& loop, const Loop& by) const;
  bool weigh();
  bool reconsider();
  bool hasLearnt() const;
  void judgeAnew(const Settle& settle);

  Optimizer& graph_;
  std::vector<Loop> loops_;
  bool learns_;
  double noise_ = 1.0;  ///< variance of the loops, relative to their covariances
  int taught_ = 0;      ///< loops that the noise was learnt from
  bool has_new_ = false;
  Changes changes_;
};

}  // namespace slam::graph
