// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/graph_slam/graph_config.hpp"
#include "slam_core/graph_slam/scan_recogniser.hpp"
#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

/// These settings say how scans are matched, and how far a map is off along the way.
struct ScanSettings {
  GraphConfig graph;
  grid_map::GridMapConfig grid;
  scan_matching::MatcherConfig matcher;
};

/// Whether two poses are as near to each other as the same place is in two maps that are bent
/// against each other: 1 m, 0.15 rad.
bool areAlike(const Pose2& a, const Pose2& b);

/// A scan of one drive that was recognised in the map of another one.
struct RecognisedScan {
  Session::Index known = 0;    ///< the node of the map that was nearest
  std::size_t seen = 0;        ///< the number that the scan was given
  Pose2 known_seen;            ///< T_known_seen
  Eigen::Matrix3d covariance;  ///< of a twist of the node that was seen

  template <class Archive>
  void persist(Archive& archive) {
    archive(known, seen, known_seen, covariance);
  }
};

/// Recognises the scans of a drive in the map of a session, until enough of them agree on how the
/// two maps lie.
class ScanMeeting {
 public:
  /// @param known outlives this
  ScanMeeting(const Session& known, const ScanSettings& settings);

  /// Looks for a scan. @param seen how who calls numbers it
  /// @return whether it was recognised
  bool look(std::size_t seen, const LaserScan& scan);

  /// The scans that agree, and how the map of the drive lies in the known one.
  struct Agreed {
    Pose2 known_drive;                  ///< T_known_drive, of the map frames
    std::vector<RecognisedScan> scans;  ///< that say so; the first is the one that most agree with
  };
  /// @param poses where the drive has the scans that were recognised, as recognised() lists them;
  /// none for one that it no longer has
  /// @return nothing where fewer than three agree that are 3 m apart, or where not four times as
  /// many agree as contradict
  std::optional<Agreed> agreed(const std::vector<std::optional<Pose2>>& poses) const;
  const std::vector<RecognisedScan>& recognised() const { return recognised_; }

  /// The map is saved with the session.
  template <class Archive>
  void persist(Archive& archive) {
    archive(recognised_);
  }

 private:
  std::optional<Session::Index> nearestNode(const Pose2& place) const;
  std::vector<std::size_t> agreeingWith(const Pose2& known_drive,
                                        const std::vector<std::optional<Pose2>>& poses) const;

  const Session& known_;
  Eigen::Vector3d drift_;  ///< variance of a map along the way of a submap, of (x, y, theta)
  ScanRecogniser map_;
  std::vector<RecognisedScan> recognised_;
};

}  // namespace slam::graph_slam
