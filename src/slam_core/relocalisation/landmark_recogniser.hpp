// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>

#include "slam_core/association/constellation_search.hpp"
#include "slam_core/relocalisation/local_landmarks.hpp"
#include "slam_core/relocalisation/recognition.hpp"
#include "slam_core/relocalisation/relocalisation_config.hpp"
#include "slam_core/relocalisation/rival_places.hpp"

namespace slam::relocalisation {

/// Recognises the place of a robot by the landmarks around it. Two markers may have the same id,
/// and a marker may have been moved. So a place must be much more likely than all others, and
/// remain so for a while. If landmarks have no ids, there must also be no other place left whose
/// odds have reached the limit since the search began (RivalPlaces).
class LandmarkRecogniser {
 public:
  explicit LandmarkRecogniser(const RelocalisationConfig& config = {},
                              LocalLandmarks::Ids ids = LocalLandmarks::Ids::kKnown)
      : config_(config), has_ids_(ids == LocalLandmarks::Ids::kKnown), local_(ids) {}

  void move(const Motion& motion);
  void see(const LandmarkObservationArray& array);
  void forget();

  /// Starts to look for the robot in this map.
  void begin(LandmarkMap map);
  void end() { search_.reset(); }
  /// To be called between begin() and end().
  /// @return nothing if no landmark was seen since the last call
  std::optional<Recognition> find(Stamp stamp);
  /// Radius of a circle that holds the map [m]; 0 if there is none to search.
  double radius() const { return search_ ? search_->evidence().radius() : 0.0; }

  template <class Archive>
  void persist(Archive& archive) {
    bool is_searching = search_ != nullptr;
    archive(is_searching, map_);
    if constexpr (Archive::kReads) is_searching ? begin(std::move(map_)) : end();
    archive(local_, reach_, rivals_, candidate_, has_news_);
  }

 private:
  /// The best place, and since when it has been the best.
  struct Candidate {
    PoseEstimate robot;  ///< T_map_base now, as odometry leads there from where it was found first
    Stamp since;
    int times = 1;

    template <class Archive>
    void persist(Archive& archive) {
      archive(robot, since, times);
    }
  };

  Recognition::Verdict verdictOn(const std::vector<association::Place>& places);
  double leastLogOdds() const;
  void updateRivals(const std::vector<association::Place>& places);
  bool stays(const PoseEstimate& place, Stamp stamp);

  RelocalisationConfig config_;
  bool has_ids_;
  LocalLandmarks local_;
  association::SensorReach reach_;  ///< around the base
  LandmarkMap map_;
  std::unique_ptr<association::ConstellationSearch> search_;  ///< in the map
  RivalPlaces rivals_;                                        ///< if landmarks have no ids
  std::optional<std::vector<Pose2>> repeats_;                 ///< of the map, once they were needed
  std::optional<Candidate> candidate_;
  bool has_news_ = false;
};

}  // namespace slam::relocalisation
