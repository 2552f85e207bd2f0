// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>

#include "slam_core/common/time.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::relocalisation {

/// Whether the robot is where it takes itself to be, by which landmarks it sees, where observations
/// are associated by place. There nothing is gated of a robot that is lost: what does not fit is
/// taken for new landmarks. But the landmarks that have been seen from there before are missing
/// (negative evidence, Montemerlo 2003, ch. 3).
///
/// The logarithm of the likelihood of "lost" over that of "right" is summed and never falls below
/// zero (CUSUM, Page 1954), as in scan_matching::ScanDoubt. How often a landmark is seen again is
/// learnt. Where the robot has never been nothing is expected, and nothing speaks for "lost".
class LandmarkDoubt {
 public:
  /// To be called once for each step. Steps whose observations were associated by id, and those
  /// without any, say nothing.
  /// @param robot T_map_base, as the back-end has it after the step
  void judge(const UpdateStatistics& statistics, const Pose2& robot, Stamp stamp);
  bool isLost() const { return sum_ >= kThreshold; }
  /// The landmarks of a map that was loaded are trusted.
  void know(const LandmarkMap& map);
  /// Whether a landmark was in the map before the doubt began; others may stand where the lost
  /// robot took them to be.
  bool isTrusted(LandmarkId id) const { return trusted_.count(id) > 0; }
  /// The robot was put somewhere in the same map.
  void relocate();
  /// Another map.
  void forget();

 private:
  /// Poses that see about the same.
  using Cell = std::array<long, 3>;
  using Ids = std::set<LandmarkId>;

  static Cell cellOf(const Pose2& robot);
  double weightOf(const Pose2& robot, Stamp stamp) const;
  Ids expectedAt(const Pose2& robot, const Ids& seen);
  double evidenceOf(const Ids& expected, const Ids& seen) const;
  void noteMissing(const Ids& expected, const Ids& seen, double evidence);
  void learn(const Ids& expected, const Ids& seen, double weight);
  void note(const Ids& seen);

  static constexpr double kThreshold = 15.0;  ///< a false alarm in e^15 independent steps at most

  std::map<Cell, Ids> views_;             ///< what has been seen from there
  Ids trusted_, since_doubt_;             ///< seen before the doubt began, and since then
  std::map<LandmarkId, double> missing_;  ///< what each has given since the doubt began
  double hits_ = 7.0, misses_ = 3.0;      ///< of landmarks that were expected
  double sum_ = 0.0;
  std::optional<Pose2> robot_;  ///< at the last step that counted
  Stamp stamp_;
};

}  // namespace slam::relocalisation
