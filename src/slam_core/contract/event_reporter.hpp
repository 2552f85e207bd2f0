// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/common/choice.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// Something that happened in a step and to which others may have to react, for example a planner
/// that keeps a path in the map frame.
struct Event {
  enum class Kind {
    kJump,           ///< the pose moved by more than its uncertainty explains, or was set
    kLoopClosed,     ///< a place was recognised, which moved the pose
    kLoopTakenBack,  ///< a place is no longer believed to be the one it was taken for
    kMerged,         ///< the map of another session has become part of the map
    kDoubtful,       ///< there is evidence against the pose (Trust)
    kConfident,      ///< there is no such evidence any more
    kLost,           ///< the back-end does not believe its pose any more
    kFound           ///< the back-end believes its pose again
  };

  Kind kind = Kind::kJump;
  /// The pose of the robot moved by this much beyond its motion: length [m] and angle [rad], not
  /// negative.
  double distance = 0.0, turn = 0.0;
  std::string reason;  ///< a clause, for people
  Stamp stamp;         ///< of the step; the Estimator fills it in

  template <class Archive>
  void persist(Archive& archive) {
    archive(kind, distance, turn, reason, stamp);
  }
};

/// The kinds have these names in messages and files.
inline const Names<Event::Kind>& namesOfEvents() {
  static const Names<Event::Kind> names = {{"jump", Event::Kind::kJump},
                                           {"loop_closed", Event::Kind::kLoopClosed},
                                           {"loop_taken_back", Event::Kind::kLoopTakenBack},
                                           {"merged", Event::Kind::kMerged},
                                           {"doubtful", Event::Kind::kDoubtful},
                                           {"confident", Event::Kind::kConfident},
                                           {"lost", Event::Kind::kLost},
                                           {"found", Event::Kind::kFound}};
  return names;
}

/// The capability of a back-end that reports events which its pose does not show. The Estimator
/// itself detects jumps and reports events about the trust in the pose.
class EventReporter {
 public:
  virtual ~EventReporter() = default;
  /// @return the events of the last execute(), in order. They may include small corrections: the
  /// Estimator leaves out loops that hardly moved the pose.
  virtual std::vector<Event> events() const = 0;
};

}  // namespace slam
