// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/geometry/pose2.hpp"
#include "slam_core/relocalisation/view_change.hpp"

namespace slam::relocalisation {

/// Judges by the observed landmarks whether the robot is at its estimated pose. If observations are
/// associated by place, the gate does not show that such a robot is lost, since observations that
/// do not fit the map become new landmarks. But the landmarks that have been seen from that pose
/// before are missing (negative evidence, Montemerlo 2003, ch. 3).
///
/// The log-likelihood ratio of "lost" to "right" is summed and never falls below zero (CUSUM, Page
/// 1954), as in scan_matching::ScanDoubt. The probability that a landmark is seen again is learnt.
/// Where the robot has never been, no landmark is expected, and the sum does not grow; but a sudden
/// change of the view is noticed there as well (ViewChange).
///
/// If observations are associated by their ids, the gate shows a wrong pose among known landmarks,
/// and only the change of the view is judged: among landmarks that are new there is nothing to
/// gate.
class LandmarkDoubt {
 public:
  explicit LandmarkDoubt(LocalLandmarks::Ids ids = LocalLandmarks::Ids::kIgnored) : ids_(ids) {}

  /// To be called with each motion, and with what was seen at its end.
  void move(const Motion& motion);
  void see(const LandmarkObservationArray& array);
  /// To be called once for each step, after what was seen in it. Steps without observations are
  /// ignored.
  /// @param robot T_map_base of the back-end after the step
  void judge(const UpdateStatistics& statistics, const Pose2& robot, Stamp stamp);
  bool isLost() const { return sum_ >= kThreshold; }
  /// Trusts the landmarks of a map that was loaded.
  void know(const LandmarkMap& map);
  /// Whether a landmark was in the map before the doubt began. Others may be misplaced, since a
  /// lost robot has mapped them relative to its wrong pose.
  bool isTrusted(LandmarkId id) const { return trusted_.count(id) > 0; }
  /// @return those that are not trusted, by their ids
  std::vector<LandmarkId> doubtful() const;
  /// To be called when the robot was put somewhere else in the same map.
  void relocate();
  /// To be called when the map was replaced.
  void forget();

  template <class Archive>
  void persist(Archive& archive) {
    archive(views_, sensors_, change_, seen_, trusted_, young_, missing_, hits_, misses_, sum_,
            robot_, stamp_);
  }

 private:
  /// A cell of positions and headings from which about the same landmarks are seen.
  using Cell = std::array<long, 3>;
  using Ids = std::set<LandmarkId>;

  void judgeByIds(const UpdateStatistics& statistics, const Pose2& robot, Stamp stamp);
  static Cell cellOf(const Pose2& robot);
  double weightOf(const Pose2& robot, Stamp stamp) const;
  Ids expectedAt(const Pose2& robot, const Ids& seen);
  double evidenceOf(const Ids& expected, const Ids& seen) const;
  void noteMissing(const Ids& expected, const Ids& seen, double evidence);
  void learn(const Ids& expected, const Ids& seen, double weight);
  void note(const Ids& mapped);
  bool isRight() const { return sum_ < kRight * kThreshold; }

  static constexpr double kThreshold = 15.0;  ///< at most one false alarm in e^15 independent steps
  /// Relative to the threshold: below this sum the robot counts as right, and its steps are learnt
  /// from.
  static constexpr double kRight = 0.2;

  std::map<Cell, Ids> views_;                  ///< landmarks that were seen from each cell
  std::map<std::string, ViewChange> sensors_;  ///< by their frames
  double change_ = 0.0;                        ///< evidence of what was seen since the last step
  Ids seen_;                                   ///< since the last step, where ids are known
  Ids trusted_;                                ///< seen before the doubt began
  std::map<LandmarkId, int> young_;            ///< steps since they were seen first; the others
  std::map<LandmarkId, double> missing_;       ///< evidence by each since the doubt began
  double hits_ = 7.0, misses_ = 3.0;           ///< expected landmarks that were seen, or not
  double sum_ = 0.0;
  std::optional<Pose2> robot_;  ///< pose at the last step that was judged
  Stamp stamp_;
  LocalLandmarks::Ids ids_;
};

}  // namespace slam::relocalisation
