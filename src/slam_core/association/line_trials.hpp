// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "slam_core/models/line_model.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::association {

/// The same for lines as Trials for points: a line enters the map once it has been seen several
/// times at the same place in the robot's frame, by odometry alone. That many beams lie on one
/// straight line is no chance, so that sightings are counted and weigh nothing else.
///
/// Call order in a step: move(), then see(), then isConfirmed() of its lines.
class LineTrials {
 public:
  /// @param sightings that a track needs at least
  explicit LineTrials(int sightings = 1) : sightings_(sightings) {}

  void move(const Motion& motion);
  /// @param lines of an array
  void see(const std::vector<LandmarkObservation>& lines, const Pose2& sensor);
  /// Whether the track of a line of the last array has been seen often enough.
  bool isConfirmed(std::size_t line) const;
  /// Every line begins its trial anew.
  void forget() { tracks_.clear(); }
  std::size_t size() const { return tracks_.size(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(tracks_, is_confirmed_);
  }

 private:
  struct Track {
    Eigen::Vector2d m;  ///< in the robot's frame, whose origin is the anchor [m, rad]
    Eigen::Matrix2d P;
    int sightings = 1;
    int unseen = 0;  ///< arrays since it was seen

    template <class Archive>
    void persist(Archive& archive) {
      archive(m, P, sightings, unseen);
    }
  };
  std::size_t nearest(const Track& seen, std::size_t end) const;
  void update(const Track& seen, Track& track) const;
  void dropOld();

  int sightings_;
  LineModel model_{Eigen::Vector2d::Zero()};
  std::vector<Track> tracks_;
  std::vector<bool> is_confirmed_;  ///< by line of the last array
};

}  // namespace slam::association
