// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/association/sensor_reach.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::association {

/// Whether what is seen has been seen before at the same place, by odometry alone: all that a
/// sensor saw lately is followed in the robot's frame as a track, which a landmark has to be before
/// it enters a map. So clutter does not, and what is on trial touches no filter. A track's score is
/// the log-likelihood ratio of a landmark to clutter (Sittler 1964; Bar-Shalom, Fortmann 1988).
///
/// Call order in a step: move(), then see(), then isConfirmed() of its observations.
class Trials {
 public:
  /// @param sightings that a track needs at least
  explicit Trials(int sightings = 1) : sightings_(sightings) {}

  void move(const Motion& motion);
  void see(const LandmarkObservationArray& array, const SensorReach& reach);
  /// Whether the track of an observation of the last array is a landmark's.
  bool isConfirmed(std::size_t observation) const;
  /// Everything begins its trial anew.
  void forget();
  std::size_t size() const { return tracks_.size(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(tracks_, track_of_, strays_);
  }

 private:
  struct Track {
    Eigen::Vector2d place;  ///< in the robot's frame [m]
    Eigen::Matrix2d P;      ///< its covariance [m^2]
    int sightings = 0;
    double score = 0.0;
    bool is_seen = false;  ///< in the last array

    template <class Archive>
    void persist(Archive& archive) {
      archive(place, P, sightings, score, is_seen);
    }
  };
  /// Where an observation puts something in the robot's frame.
  struct Place {
    Eigen::Vector2d place;
    Eigen::Matrix2d R;
  };
  struct Pair {
    double nis;
    std::size_t track, observation;
  };
  std::vector<Place> placesOf(const LandmarkObservationArray& array) const;
  std::vector<Pair> pairsOf(const std::vector<Place>& places) const;
  void follow(const std::vector<Place>& places, double density);
  void update(const Place& seen, double density, Track& track) const;
  void miss(const Pose2& sensor, const SensorReach& reach);
  void beginAndDrop(const std::vector<Place>& places, double density);

  int sightings_;
  RangeBearingModel model_;
  std::vector<Track> tracks_;
  std::vector<std::size_t> track_of_;  ///< by observation of the last array
  double strays_ = 1.0;                ///< observations of an array that no track had predicted
};

}  // namespace slam::association
