// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/consistency/gating_rate.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/data.hpp"
#include "slam_core/contract/session_merger.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/relocalisation/landmark_doubt.hpp"
#include "slam_core/relocalisation/scan_change.hpp"

namespace slam {

/// Maps what a lost robot sees: a fragment of its own, made by a second back-end that begins where
/// the robot was lost. The fragment ends when the robot is found. When the robot has not been lost
/// again on the next metres, the product's back-end gets the fragment to merge it (SessionMerger).
/// A fragment of a short way is thrown away, since the robot was where the map is. Counted:
/// "map_fragments" (that the back-end got), "fragments_left_out" (that there was no room for).
///
/// Call order for each step: predict() with the motions, see() with what was seen, then judge().
class MapFragment {
 public:
  /// @param merger of the product's back-end, which outlives this; null where it merges nothing:
  /// then there never is a fragment
  void use(SessionMerger* merger);
  /// @param ids whether observations and map share their ids
  void goBy(relocalisation::LocalLandmarks::Ids ids) {
    doubt_ = relocalisation::LandmarkDoubt(ids);
  }
  /// Forgets all fragments.
  void reset();

  void predict(const Motion& motion);
  /// @param value of this kind; a kind that the back-end does not take is ignored
  void see(Kind kind, const void* value);
  /// The product's estimate after a step.
  struct Situation {
    bool is_lost = false;
    bool is_tested = false;  ///< the place where the robot was found may still be withdrawn
    Pose2 robot;             ///< T_map_base
    Stamp stamp;
  };
  /// @return a warning where a fragment cannot be merged
  Status judge(const Situation& now);
  /// Ends the fragment: nobody knows where the robot goes from here.
  void end();
  /// Keeps all fragments from being merged: somebody may have carried the robot meanwhile, or the
  /// product has another map.
  void setAside();

  /// @return all sessions that are not part of the map, those that wait in the back-end included
  std::vector<SavedSession> unmerged() const;
  const Counters& counters() const { return counters_; }

  template <class Archive>
  void persist(Archive& archive) {
    bool is_growing = backend_ != nullptr;
    archive(is_growing);
    if constexpr (Archive::kReads) restart(is_growing);
    archive(ended_, aside_, way_, last_, since_found_, robot_, gating_, doubt_, scan_change_,
            was_carried_, counters_);
    if (!backend_) return;
    if constexpr (Archive::kReads)
      backend_->restoreState(archive);
    else
      backend_->saveState(archive);
  }

 private:
  using Sessions = std::vector<SavedSession>;

  void restart(bool grows);
  void begin();
  void drop();
  void map(Stamp stamp);
  bool admit(const LaserScan& scan);
  bool isLostItself(Stamp stamp);
  std::optional<SavedSession> session() const;
  void keep(SavedSession session, Sessions& sessions);
  Status handOver();

  SessionMerger* merger_ = nullptr;
  std::unique_ptr<Backend> backend_;  ///< while a fragment grows
  Ports ports_;                       ///< of that back-end
  double way_ = 0.0;                  ///< that the fragment has grown by [m]
  std::optional<Pose2> last_;         ///< pose in the fragment
  GatingRate gating_{kWindow};        ///< of landmarks that the fragment knows
  relocalisation::LandmarkDoubt doubt_;
  relocalisation::ScanChange scan_change_;
  bool was_carried_ = false;    ///< as the scans since the fragment began show
  Sessions ended_;              ///< to be merged
  Sessions aside_;              ///< not to be merged
  double since_found_ = 0.0;    ///< way by the product's back-end [m]
  std::optional<Pose2> robot_;  ///< T_map_base at the last step since the robot was found
  Counters counters_;

  static constexpr int kWindow = 10;  ///< steps with known landmarks
};

}  // namespace slam
