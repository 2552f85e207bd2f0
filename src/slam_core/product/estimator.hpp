// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "slam_core/common/collator.hpp"
#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/models/landmark_sensor.hpp"
#include "slam_core/models/motion_gap.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// What a step of the back-end came from; kNone: motion had piled up with nothing to see.
enum class StepTrigger { kNone, kObservations, kScan };

/// What one step of the back-end led to, all that is published and written of it.
struct StepReport {
  Stamp stamp;
  StepTrigger trigger = StepTrigger::kNone;
  PoseEstimate pose;    ///< in the map frame
  Pose2 odometry_pose;  ///< T_odom_base at the same stamp
  std::string odometry_frame, base_frame;
  UpdateStatistics statistics;
  bool restarted = false;  ///< time began anew with this step

  bool hasTrigger() const { return trigger != StepTrigger::kNone; }
};

/// A back-end with its inputs in order: collates motion, observations and, where the back-end uses
/// them, scans by stamp and takes one step of the back-end at a time. The back-end's nodelet and
/// the MetaCoordinator share it, which is why both compositions give the same result. Counted
/// beyond the collator's and the back-end's reasons: "invalid_motion", "invalid_observation",
/// "invalid_scan", "paused", "bridged" (a gap of lost motion, crossed by the odometry's poses).
class Estimator {
 public:
  /// A fresh start. @throw ConfigError listing all faults
  void configure(Settings& settings, std::unique_ptr<Backend> backend);

  void set(Motion motion);
  void set(LandmarkObservationArray observations);
  /// Nothing comes of it unless usesScans().
  void set(LaserScan scan);
  /// In force at once: backend() tells them without a step.
  Status set(const PoseEstimate& initial_pose);
  /// @return a warning where not all of the map is used, an error where none of it is
  Status set(const MapState& map);
  /// This map instead of an empty one, now and whenever everything begins anew. @return as set()
  Status startWith(MapState map);
  /// Nothing is expected of the landmarks' source now and after a reset: scans do not wait for it.
  void expectNoObservations();
  /// Paused, observations and scans are ignored and motion is still applied.
  void pause(bool paused) { paused_ = paused; }

  /// Takes the next step that is due. Afterwards report() holds it, or nothing when none was due.
  Status execute();

  const std::optional<StepReport>& report() const { return report_; }
  const Backend& backend() const { return *backend_; }
  bool usesScans() const { return backend_->usesScans(); }
  /// Of the last updates. A step's status tells when a source begins to look too sure.
  const ConsistencyMonitor& consistency() const { return consistency_; }
  std::optional<Stamp> lastMotion() const { return collator_.lastMotion(); }
  std::optional<Stamp> lastObservations() const { return collator_.lastTrigger(kObservations); }
  /// Observation arrays and scans that have come and no step has been taken for.
  std::size_t heldObservations() const { return collator_.held(kObservations); }
  std::size_t heldScans() const { return usesScans() ? collator_.held(kScans) : 0; }
  /// Nothing steps: "observations and scans since 12.3 wait for motion", where they have gone on
  /// without it for more than kPatience; else empty.
  std::string starving() const;
  static constexpr Duration kPatience = std::chrono::seconds(3);
  /// Of the collator, the back-end and the estimator itself.
  Counters counters() const;
  /// Messages that had no effect because they came late, were lost or did not fit.
  std::uint64_t dropped() const;

  void reset();

 private:
  using Trigger = std::variant<LandmarkObservationArray, LaserScan>;
  using TriggerCollator = Collator<Motion, Trigger>;
  /// The collator's sources: equal stamps come in this order.
  enum Source : std::size_t { kObservations, kScans };

  Status resetBackend();
  void warnOfBaseFrame(const std::string& moved);
  void reportStep(const TriggerCollator::Step& step);
  void takeTrigger(const Trigger& trigger);
  Status watchConsistency();

  LandmarkSensorConfig sensor_;
  FramesConfig frames_;
  Duration source_timeout_{};
  std::unique_ptr<Backend> backend_;
  ConsistencyConfig consistency_config_;
  ConsistencyMonitor consistency_;
  std::optional<MapState> start_map_;
  bool expects_observations_ = true;
  MotionGap gap_;
  TriggerCollator collator_;
  std::optional<Motion> last_motion_;
  std::optional<StepReport> report_;
  std::string moved_frame_;  ///< the base frame of the last motion
  std::string fault_;        ///< of an input since the last execute()
  bool paused_ = false;
  Counters counters_;
};

}  // namespace slam
