// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/models/landmark_observation.hpp"

namespace slam::association {

/// Where a landmark sensor sees landmarks, as far as it has shown: by sectors of the bearing, how
/// often it saw one there and how far. What lies well within should be seen.
class SensorReach {
 public:
  void see(const LandmarkObservationArray& array);
  /// @param place in the sensor's frame [m]
  bool covers(const Eigen::Vector2d& place) const;
  /// @return the area of all that is covered, 1 m^2 at least [m^2]
  double area() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sectors_);
  }

 private:
  static constexpr int kSectors = 24;
  struct Sector {
    int count = 0;
    double range = 0.0;  ///< mean [m]

    template <class Archive>
    void persist(Archive& archive) {
      archive(count, range);
    }
  };
  static std::size_t sectorOf(double bearing);
  static double reachOf(const Sector& sector);

  std::array<Sector, kSectors> sectors_;
};

}  // namespace slam::association
