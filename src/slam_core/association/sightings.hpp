// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "slam_core/common/status.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::association {

/// Of each landmark: how often it was seen where the map has it, and how often in a row elsewhere
/// (after the evidence counter of Montemerlo 2003, ch. 3). A wrong reading that put a landmark into
/// the map gates all right ones from then on: it must not stay there for ever. Only steps count in
/// which confirmed landmarks fit, and as many as do not: else the robot may be what is elsewhere.
class Sightings {
 public:
  /// The latest observation of what was seen elsewhere once too often.
  struct Verdict {
    LandmarkObservation z;
    bool was_confirmed = false;  ///< it has been moved, else it was never where the map has it
  };

  /// Warns of a landmark that was seen elsewhere.
  static Status warningOf(const Verdict& verdict, bool is_reinitialized);

  /// A record counts what is known of a landmark.
  struct Record {
    int fits = 0, misses = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(fits, misses);
    }
  };

  /// Those of a loaded map are confirmed.
  explicit Sightings(const LandmarkMap& map = {});
  /// @param fitting the landmarks of a stamp's observations that passed the gate
  /// @param gated the observations that did not
  /// @return the landmarks to be re-initialised; each of them once in a row of such sightings
  std::vector<Verdict> judge(const std::vector<LandmarkId>& fitting,
                             const std::vector<LandmarkObservation>& gated);
  /// The landmark stands elsewhere from now on.
  void restart(LandmarkId id) { records_[id] = {}; }

  // A session saves the records and takes them up again.
  Record record(LandmarkId id) const;
  void set(LandmarkId id, const Record& record) { records_[id] = record; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(records_);
  }

 private:
  static constexpr int kConfirmed = 3;  ///< seen so often after the first time where it is
  static constexpr int kDoubtful = 3, kMoved = 10;  ///< seen so often in a row elsewhere

  bool isConfirmed(LandmarkId id) const;
  bool robotIsWhereItShould(const std::vector<LandmarkId>& fitting, std::size_t gated) const;

  std::unordered_map<LandmarkId, Record> records_;  // looked up only, never iterated
};

}  // namespace slam::association
