// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>

#include "slam_core/models/descriptor.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::association {

/// This tells how well an observation's descriptor fits a landmark's.
struct DescriptorFit {
  double nis = 0.0;   ///< squared Mahalanobis distance
  double cost = 0.0;  ///< with ln(|S| / |R|) added, as Option::cost; never negative
  bool passes = true;
};

/// Descriptors of different lengths, and where one of them is empty, say nothing: they pass and
/// cost nothing.
/// @param probability that the right one passes the chi-square test, in (0, 1)
DescriptorFit fitOf(const Descriptor& seen, const Descriptor& landmark, double probability);

/// Makes an observation's descriptor a part of what is known (a Kalman filter for each element),
/// where it has the length of that.
void fuse(const Descriptor& seen, Descriptor& known);

/// The descriptors of a map's landmarks by id: means with their standard deviations, from all
/// observations that were taken for the landmark. They do not depend on the pose, so that one
/// serves all particles of a filter as well.
class DescriptorMap {
 public:
  /// @param map landmarks that were loaded, with their descriptors
  explicit DescriptorMap(const LandmarkMap& map = {});

  /// An observation was taken for the landmark.
  void see(LandmarkId id, const Descriptor& seen);
  void set(LandmarkId id, const Descriptor& known);
  void forget(LandmarkId id) { known_.erase(id); }
  /// Empty where nothing is known.
  Descriptor of(LandmarkId id) const;
  /// Fills in the descriptors of a map.
  void describe(LandmarkMap& map) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(known_);
  }

 private:
  std::map<LandmarkId, Descriptor> known_;
};

}  // namespace slam::association
