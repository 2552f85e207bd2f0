// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::laser_landmarks {

/// A detector of landmarks in the scans of a horizontal laser. The derived class says what they
/// are. Landmarks have no ids: the back-end's association tells of which one an observation is.
/// Observations that are not valid are left out, counted as "invalid_observation".
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

 protected:
  using Observations = std::vector<LandmarkObservation>;

 private:
  /// Adds what is found in a scan.
  /// @param counters reasons why something is no landmark
  virtual Status find(const LaserScan& scan, Observations& found, Counters& counters) = 0;

  std::optional<LaserScan> next_scan_;
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::laser_landmarks
