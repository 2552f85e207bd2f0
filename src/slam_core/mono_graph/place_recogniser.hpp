// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "slam_core/mono_graph/place_index.hpp"
#include "slam_core/mono_graph/tracker.hpp"

namespace slam::mono_graph {

/// A place of the map that an image shows.
struct RecognisedPlace {
  int keyframe = 0;
  Pose2 pose;                       ///< of the robot, by the points that the keyframe sees
  Eigen::Matrix3d covariance;       ///< the keyframe taken as exact
  std::vector<PointMatch> matches;  ///< that fit the pose
};

/// Recognises places: candidates by their words, then features matched with the candidate's points,
/// a pose by RANSAC (Fischler and Bolles 1981), and all points around looked for from there. A
/// place counts where enough points fit, a good share of those that were to be seen, and no other
/// place fits half as well: what looks alike in two places is recognised in neither.
class PlaceRecogniser {
 public:
  PlaceRecogniser() = default;
  /// @param least_points that have to fit
  PlaceRecogniser(int least_points, std::uint64_t seed)
      : least_points_(static_cast<std::size_t>(least_points)), seed_(seed) {}

  void add(BagOfWords bag) { index_.add(std::move(bag)); }
  /// @param left_out keyframes that are no news @param least similarity of a candidate
  std::optional<RecognisedPlace> find(const VisualMap& map, const Features& features,
                                      const BagOfWords& bag, const std::set<int>& left_out,
                                      double least);
  const PlaceIndex& index() const { return index_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(index_, queries_);
  }

 private:
  std::optional<RecognisedPlace> verify(const VisualMap& map, const Features& features,
                                        int candidate) const;
  std::optional<Pose2> consensus(const VisualMap& map, const Features& features, int candidate,
                                 const std::vector<PoseSighting>& sightings) const;

  std::size_t least_points_ = 0;
  std::uint64_t seed_ = 0;
  std::uint64_t queries_ = 0;
  PlaceIndex index_;
};

}  // namespace slam::mono_graph
