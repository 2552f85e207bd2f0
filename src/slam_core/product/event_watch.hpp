// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/contract/capabilities.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/product/step_report.hpp"

namespace slam {

struct EventsConfig {
  static constexpr const char* kSection = "events";

  double jump_position = 0.05;
  double jump_heading = 0.05;

  void describe(Fields& fields);
};

/// Tells what of a step others should know, for every back-end alike: jumps from the pose and the
/// motion, what concerns the trust in the pose from the report, the rest from the EventReporter.
/// What moves the pose by no more than the limits of the configuration is no event, unless the
/// robot was put there.
class EventWatch {
 public:
  explicit EventWatch(const EventsConfig& config = {}) : config_(config) {}

  /// A motion that the back-end is given before the next step.
  void predict(const Motion& motion);
  /// The pose has been set by something else than data.
  /// @param reason a clause
  void relocate(const std::string& reason) { relocation_ = reason; }
  /// Fills in what a step has led to; its pose and stamp are there.
  void complete(StepReport& report, const Capabilities& backend);

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose_, relocation_, lost_since_, doubted_, trust_);
  }

 private:
  void addOwn(StepReport& report, const Capabilities& backend) const;
  void addJump(StepReport& report) const;
  void addTrust(StepReport& report);
  void addLoss(StepReport& report);
  bool isLarge(double distance, double turn) const;

  EventsConfig config_;
  std::optional<PoseEstimate> pose_;  ///< of the last step, moved on by odometry
  std::optional<std::string> relocation_;
  std::optional<Stamp> lost_since_;
  std::optional<Stamp> doubted_;  ///< last
  Trust trust_ = Trust::kConfident;
};

}  // namespace slam
