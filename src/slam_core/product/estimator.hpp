// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "slam_core/common/collator.hpp"
#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/models/landmark_sensor.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// What one step of the back-end led to, all that is published and written of it.
struct StepReport {
  Stamp stamp;
  PoseEstimate pose;    ///< in the map frame
  Pose2 odometry_pose;  ///< T_odom_base at the same stamp
  std::string odometry_frame, base_frame;
  UpdateStatistics statistics;
  bool observed = false;   ///< the step came from an observation array
  bool restarted = false;  ///< time began anew with this step
};

/// A back-end with its inputs in order: collates motion and observations by stamp and takes one
/// step of the back-end at a time. The back-end's nodelet and the MetaCoordinator share it, which
/// is why both compositions give the same result. Counted beyond the collator's and the back-end's
/// reasons: "invalid_motion", "invalid_observation", "paused".
class Estimator {
 public:
  /// A fresh start. @throw ConfigError listing all faults
  void configure(Settings& settings, std::unique_ptr<Backend> backend);

  void set(Motion motion);
  void set(LandmarkObservationArray observations);
  /// In force at once: backend() tells them without a step.
  void set(const PoseEstimate& initial_pose);
  void set(const MapState& map);
  /// This map instead of an empty one, now and whenever everything begins anew.
  void startWith(MapState map);
  /// Paused, observations are ignored and motion is still applied.
  void pause(bool paused) { paused_ = paused; }

  /// Takes the next step that is due. Afterwards report() holds it, or nothing when none was due.
  Status execute();

  const std::optional<StepReport>& report() const { return report_; }
  const Backend& backend() const { return *backend_; }
  /// Of the last updates. A step's status tells when a source begins to look too sure.
  const ConsistencyMonitor& consistency() const { return consistency_; }
  std::optional<Stamp> lastMotion() const { return collator_.lastMotion(); }
  std::optional<Stamp> lastObservations() const { return collator_.lastTrigger(0); }
  /// Of the collator, the back-end and the estimator itself.
  Counters counters() const;
  /// Messages that had no effect because they came late, were lost or did not fit.
  std::uint64_t dropped() const;

  void reset();

 private:
  using LandmarkCollator = Collator<Motion, LandmarkObservationArray>;

  void resetBackend();
  void warnOfBaseFrame(const std::string& moved);
  void reportStep(const LandmarkCollator::Step& step);

  Status watchConsistency();

  LandmarkSensorConfig sensor_;
  FramesConfig frames_;
  Duration source_timeout_{};
  std::unique_ptr<Backend> backend_;
  ConsistencyConfig consistency_config_;
  ConsistencyMonitor consistency_;
  std::optional<MapState> start_map_;
  LandmarkCollator collator_;
  std::optional<Motion> last_motion_;
  std::optional<StepReport> report_;
  std::string moved_frame_;  ///< the base frame of the last motion
  std::string fault_;        ///< of an input since the last execute()
  bool paused_ = false;
  Counters counters_;
};

}  // namespace slam
