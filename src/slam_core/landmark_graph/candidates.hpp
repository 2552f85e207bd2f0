// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/association/descriptor_map.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/landmark_graph/prediction.hpp"

namespace slam::landmark_graph {

/// The graph's landmarks for a policy that asks for ids only.
class IdCandidates : public association::CandidateSource {
 public:
  explicit IdCandidates(const LandmarkGraph& graph) : graph_(graph) {}

  std::size_t size() const override { return graph_.ids().size(); }
  std::optional<std::size_t> find(LandmarkId id) const override { return graph_.ids().find(id); }
  void candidates(std::size_t /*observation*/,
                  std::vector<association::Candidate>& /*candidates*/) const override {}

 protected:
  const LandmarkGraph& graph_;
};

/// The graph's landmarks for a policy that asks for places as well.
class PlaceCandidates final : public IdCandidates {
 public:
  /// @param gate largest squared Mahalanobis distance; all within it are found, and some beyond
  PlaceCandidates(const LandmarkObservationArray& array, const LandmarkGraph& graph,
                  const association::DescriptorMap& descriptors, double gate,
                  const Viewpoint& from = {});
  PlaceCandidates(const PlaceCandidates&) = delete;  // the prediction refers to the matches
  PlaceCandidates& operator=(const PlaceCandidates&) = delete;

  void candidates(std::size_t observation,
                  std::vector<association::Candidate>& candidates) const override;
  Descriptor descriptor(std::size_t landmark) const override {
    return descriptors_.of(graph_.ids()[landmark]);
  }
  Eigen::Matrix2d crossCovariance(const association::Pairing& first,
                                  const association::Pairing& second) const override;

 private:
  void findNear(const LandmarkObservationArray& array, double gate, const PoseEstimate& sensor);
  std::size_t matchOf(const association::Pairing& pairing) const;

  const association::DescriptorMap& descriptors_;
  /// Each observation with each landmark near it, by observation; those of observation i begin at
  /// first_[i].
  std::vector<Match> matches_;
  std::vector<std::size_t> first_;
  std::optional<Prediction> prediction_;  ///< of all matches at once: the graph is solved once
};

}  // namespace slam::landmark_graph
