// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// A detector of landmarks in the scans of a horizontal laser. The derived class decides what a
/// landmark is. Landmarks have no ids: the back-end's association finds the landmark that an
/// observation belongs to. Invalid observations are left out and counted as "invalid_observation".
class ScanDetector : public LandmarkDetector {
 public:
  void describe(Ports& ports) override;
  void set(const LaserScan& scan) { next_scan_ = scan; }
  Status execute() override;
  const std::optional<LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  Counters counters() const override { return counters_; }
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(next_sequence_, counters_);
  }

 protected:
  using Observations = std::vector<LandmarkObservation>;

 private:
  /// Adds the landmarks in a scan to `found`.
  /// @param counters count the reasons why objects are no landmarks
  virtual Status find(const LaserScan& scan, Observations& found, Counters& counters) = 0;

  std::optional<LaserScan> next_scan_;
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::laser_landmarks
