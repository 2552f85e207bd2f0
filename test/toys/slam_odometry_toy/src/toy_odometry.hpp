// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam_toy {

struct ToyOdometryConfig {
  static constexpr const char* kSection = "toy_odometry";

  double relative_sigma = 0.1;
  double floor = 0.002;

  void describe(slam::Fields& fields);
};

/// The driver's increments of pose as they are; their standard deviation is a part of what was
/// driven and turned.
class ToyOdometry final : public slam::OdometrySource {
 public:
  void configure(slam::Settings& settings) override;
  void describe(slam::Ports& ports) override;
  void set(const slam::OdometrySample& sample) { sample_ = sample; }
  slam::Status execute() override;
  const std::optional<slam::Motion>& motion() const override { return motion_; }
  slam::Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override { return counters_["late"] + counters_["invalid"]; }
  void reset() override;

 private:
  slam::Motion between(const slam::OdometrySample& first, const slam::OdometrySample& second);

  ToyOdometryConfig config_;
  std::optional<slam::OdometrySample> last_, sample_;
  std::optional<slam::Motion> motion_;
  std::uint64_t sequence_ = 0;
  slam::Counters counters_;
};

}  // namespace slam_toy
