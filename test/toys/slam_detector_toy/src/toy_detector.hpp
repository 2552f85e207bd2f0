// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam_toy {

struct ToyDetectorConfig {
  static constexpr const char* kSection = "toy_detector";

  double jump = 0.5;
  double sigma_range = 0.05;
  double sigma_bearing = 0.02;

  void describe(slam::Fields& fields);
};

/// Edges that a laser sees: where the range jumps from one beam to the next, the nearer end is a
/// landmark, without an id.
class ToyDetector final : public slam::LandmarkDetector {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;
  void set(const slam::LaserScan& scan) { scan_ = scan; }
  slam::Status execute() override;
  const std::optional<slam::LandmarkObservationArray>& observations() const override {
    return array_;
  }
  slam::Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override { return counters_["late"]; }
  void reset() override;

 private:
  void find(const slam::LaserScan& scan);
  bool isEdge(const slam::LaserBeam& beam, const slam::LaserBeam& other) const;

  ToyDetectorConfig config_;
  std::optional<slam::LaserScan> scan_;
  std::optional<slam::Stamp> last_;
  std::optional<slam::LandmarkObservationArray> array_;
  std::uint64_t sequence_ = 0;
  slam::Counters counters_;
};

}  // namespace slam_toy
