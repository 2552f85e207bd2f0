// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam_core/grid_map/beam_model.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::grid_map {

/// Some neighbouring elements of a list.
template <class T>
struct Span {
  const T* first;
  const T* last;
  const T* begin() const { return first; }
  const T* end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

/// A scan as the map takes it, in the robot's frame, lengths in cells.
struct ScanPoints {
  struct Beam {
    Eigen::Vector2d end;  ///< of what it says
    LogOdds gain;         ///< of the cell in which it ends; 0: it says that there is nothing
    double sigma;         ///< of its length; 0 where it says that there is nothing
    bool isHit() const { return gain > 0; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(end, gain, sigma);
    }
  };
  /// This is the part of one laser. Its beams and ends go on up to the first ones of the next
  /// laser.
  struct Fan {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the sensor
    double relative_sigma = 0.0;                       ///< of a range, relative to it
    std::size_t first_beam = 0, first_end = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(origin, relative_sigma, first_beam, first_end);
    }
  };
  double cells_per_metre = 1.0;
  std::vector<Fan> fans;
  std::vector<Beam> beams;
  /// Ends to match with the map: of those that lie close together only some.
  std::vector<Eigen::Vector2d> ends;

  /// Whether cells have numbers there. A pose that is none, or further away, is no place on a map.
  bool isOnMap(const Pose2& pose) const;
  /// The pose with lengths in cells.
  Pose2 inCells(const Pose2& pose) const {
    return {cells_per_metre * pose.x(), cells_per_metre * pose.y(), pose.theta()};
  }

  /// Beams and ends that are added from here on are those of another laser.
  void startFan(const Eigen::Vector2d& origin, double relative_sigma) {
    fans.push_back({origin, relative_sigma, beams.size(), ends.size()});
  }
  /// Calls visit(fan, its beams, its ends) for each laser.
  template <class Visit>
  void forEachFan(const Visit& visit) const {
    for (std::size_t i = 0; i < fans.size(); ++i) {
      const bool is_last = i + 1 == fans.size();
      const auto beyond_beams = is_last ? beams.size() : fans[i + 1].first_beam;
      const auto beyond_ends = is_last ? ends.size() : fans[i + 1].first_end;
      visit(fans[i], Span<Beam>{beams.data() + fans[i].first_beam, beams.data() + beyond_beams},
            Span<Eigen::Vector2d>{ends.data() + fans[i].first_end, ends.data() + beyond_ends});
    }
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(cells_per_metre, fans, beams, ends);
  }
};

/// Beams that are no numbers, or further than what is usable, are left out.
/// @param spacing between the ends to match [m]
ScanPoints pointsOf(const LaserScan& scan, const BeamModel& model, double spacing);

}  // namespace slam::grid_map
