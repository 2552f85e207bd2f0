// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/graph_slam/graph_config.hpp"
#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {

/// Decisions of association that are taken later, and some that are taken back, where places
/// decide. An observation that may be of several landmarks waits at its node. A node is looked at
/// again when 10, 30 and 90 others have followed it, with what the graph has learnt meanwhile of
/// its pose and of the landmarks:
/// - What waits goes to the policy again, and into the graph if it is of one landmark now.
/// - What was seen from it and does not fit the graph any more is withdrawn and waits.
class DelayedDecisions {
 public:
  explicit DelayedDecisions(const GraphConfig& config);

  /// To be called after the graph has got what was decided at once.
  /// @param association of the array
  void keep(const LandmarkObservationArray& array, const Association& association,
            LandmarkGraph& landmarks);
  /// Decides on what is due; to be called before the graph is optimised. Counted: "decided_later",
  /// "taken_back".
  /// @param descriptors of the landmarks
  std::vector<RevisedAssociation> revise(const association::DescriptorMap& descriptors,
                                         LandmarkGraph& landmarks, Counters& counters);
  /// A node is removed from the graph.
  void forget(graph::Key node);

  template <class Archive>
  void persist(Archive& archive) {
    archive(nodes_, due_, told_);
  }

 private:
  /// An observation as its array had it.
  struct Reading {
    Stamp stamp;
    LandmarkId own_id;

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, own_id);
    }
  };
  struct Paired {
    Reading reading;
    std::size_t landmark;

    template <class Archive>
    void persist(Archive& archive) {
      archive(reading, landmark);
    }
  };
  struct Waiting {
    NodeObservations seen;
    std::vector<std::vector<Reading>> readings;  ///< by observation

    template <class Archive>
    void persist(Archive& archive) {
      archive(seen, readings);
    }
  };
  struct Node {
    graph::Key key;
    std::vector<Paired> paired;
    std::vector<Waiting> waiting;

    template <class Archive>
    void persist(Archive& archive) {
      archive(key, paired, waiting);
    }
  };

  Node& at(graph::Key key);
  void takeBack(Node& node, LandmarkGraph& landmarks);
  void decide(Node& node, const association::DescriptorMap& descriptors, LandmarkGraph& landmarks);
  std::vector<association::Pairing> pairingsOf(const NodeObservations& seen,
                                               const association::DescriptorMap& descriptors,
                                               const LandmarkGraph& landmarks) const;
  static bool isTaken(const Node& node, const std::vector<Reading>& readings, std::size_t landmark);
  void tell(const Reading& reading, LandmarkId landmark, TakenFor taken_for);

  std::unique_ptr<association::AssociationPolicy> policy_;
  double contradiction_;  ///< largest squared residual of what fits
  double ring_gate_;      ///< candidates lie within this squared Mahalanobis distance
  bool map_is_fixed_;
  std::deque<Node> nodes_;  ///< the newest last
  std::size_t due_ = 0;     ///< nodes since the last revision
  std::vector<RevisedAssociation> told_;
};

}  // namespace slam::graph_slam
