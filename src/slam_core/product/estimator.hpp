// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/consistency/consistency_monitor.hpp"
#include "slam_core/consistency/dead_reckoning.hpp"
#include "slam_core/consistency/noise_adaptation.hpp"
#include "slam_core/consistency/pose_doubt.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/models/filter_pose.hpp"
#include "slam_core/product/detector_place.hpp"
#include "slam_core/product/event_watch.hpp"
#include "slam_core/product/expected_landmarks.hpp"
#include "slam_core/product/intake.hpp"
#include "slam_core/product/map_choice.hpp"
#include "slam_core/product/map_fragment.hpp"
#include "slam_core/product/saved_map.hpp"
#include "slam_core/product/step_report.hpp"
#include "slam_core/relocalisation/relocaliser.hpp"

namespace slam {

/// A back-end with its inputs in order, one step at a time. It takes in what the back-end takes;
/// its output `pose` is that of the last step. Both compositions share it, which is why they give
/// the same result. A pose that came with a loaded map, and one that what is seen contradicts, is
/// not believed until the robot's place has been recognised in the map (Relocaliser). Where the
/// back-end merges sessions, a lost robot maps a fragment of its own meanwhile (MapFragment).
/// Counted beyond the intake's, the back-end's and the relocaliser's reasons: "paused",
/// "not_finite_pose" (a step that left no finite pose).
class Estimator final : public Component {
 public:
  /// To be called before everything else. The back-end is configured with this.
  void use(std::unique_ptr<Backend> backend);
  /// Has the back-end make the product's map, so that its ports are those of this map; a back-end
  /// that can do without motion takes it in where the product has an odometry source.
  /// @throw ConfigError where the back-end cannot make it
  void adaptTo(const ProductConfig& product);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;

  /// Gives the back-end a value for its input of this kind; a kind that it does not take is
  /// ignored.
  template <class T>
  void set(const T& value) {
    intake_.take(kindOf<T>(), &value);
  }
  /// Pose and map are in force at once: backend() reports them without a step. A doubt beyond 1 km
  /// or half a turn is taken as that.
  /// @return an error where the pose cannot be used (place_fault.hpp), which leaves all as it is
  Status set(const PoseEstimate& initial_pose);
  /// @return a warning where not all of the map is used, an error where none of it is
  Status set(const MapState& map);
  /// Goes on from a session (SessionKeeper), at once as from a map.
  /// @return an error where it cannot be used, which leaves all as it is
  Status set(const SavedSession& session);
  /// This map instead of an empty one, now and whenever everything starts over. @return as set()
  Status startWith(MapState map);
  Status startWith(SavedSession session);  ///< the same
  /// Paused, triggers are ignored and motion is still applied.
  void pause(bool paused) { paused_ = paused; }

  /// Takes the next step that is due. Afterwards report() holds it, or nothing when none was due or
  /// the back-end's pose is not finite, which is an error.
  Status execute() override;

  const std::optional<StepReport>& report() const { return report_; }
  const Backend& backend() const { return *backend_; }
  /// What the back-end can do beyond its role; known once the map is chosen.
  const Capabilities& capabilities() const { return capabilities_; }
  /// The monitor of the last updates. A step's status reports when a source begins to look
  /// over-confident.
  const ConsistencyMonitor& consistency() const { return consistency_; }
  /// The relocaliser reports how much the pose is believed, and can be asked to look for the robot.
  friend relocalisation::Relocaliser& relocaliserOf(Estimator& estimator) {
    return estimator.relocaliser_;
  }
  /// To be called after restoreState() where the robot has gone on without this process. Unless the
  /// poses of an odometry that ran on bridge the pause, its place has to be recognised in the map
  /// again. Where the stamps went back, as with a clock that was set anew, time starts over with
  /// the saved map.
  friend void goOnLive(Estimator& estimator, Interruption interruption);
  const Intake& intake() const { return intake_; }
  Intake& intake() { return intake_; }

  Counters counters() const override;
  std::uint64_t dropped() const override { return intake_.dropped(); }
  /// Beside the back-end's: the factors on the reported noise (NoiseAdaptation), and the parameters
  /// that it calibrates, with their standard deviations.
  Figures figures() const override;
  void reset() override;

  bool canResume() const override { return backend_->canResume() && slam::canResume(intake_); }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;
  template <class Archive>
  void persist(Archive& archive) {
    archive(intake_, consistency_, noise_, dead_reckoning_, doubt_, events_, relocaliser_,
            fragment_, start_map_, start_session_, last_motion_, fault_, paused_, counters_);
  }

 private:
  /// The back-end's, without those that the product does not use; its observations come from each
  /// of the product's detectors at an input of its own.
  Ports usedPorts() const;
  void addFurther(const InputPort& observations, Ports& used) const;
  bool takesLines() const;
  Status resetBackend();
  Status restart();
  Status judgePause();
  void give(const Intake::Step& step);
  void give(const Intake::Trigger& trigger);
  Intake::Trigger scaled(const Intake::Trigger& trigger) const;
  void learnMerged();
  /// Has the dead reckoning know what the back-end's last step corrected.
  void judgeCorrection(Stamp stamp);
  void adaptNoise();
  /// The back-end's parameters, if it estimates some.
  std::optional<CalibrationEstimate> calibration() const;
  PoseEstimate reportedPose() const;
  bool isAdmitted(const Intake::Trigger& trigger);
  /// Puts the robot where it has been recognised, where that is elsewhere.
  Status relocate(Stamp stamp);
  void reportStep(const Intake::Step& step);
  UpdateStatistics statistics() const;
  bool isLost() const;
  bool isLostByBackend() const;
  void judgeWay(bool was_lost);
  /// A clause on why the pose is in doubt; empty where it is not.
  std::string doubt() const;
  Trust trust(const std::string& doubt) const;
  /// An error where the back-end's pose is not finite.
  Status faultOfState();
  Status watchConsistency();
  /// A warning where a calibrated parameter is further off than it can be.
  Status watchCalibration() const;

  std::unique_ptr<Backend> backend_;
  bool has_odometry_ = true;            ///< the product has an odometry source
  std::vector<DetectorPlace> further_;  ///< the detectors beside the first one
  Ports ports_;                         ///< the back-end's
  ExpectedLandmarks expected_;          ///< in a loaded map
  const InputPort* carrier_ = nullptr;  ///< that takes motion; none in a product without
  Capabilities capabilities_;           ///< the back-end's
  FramesConfig frames_;
  Intake intake_;
  ConsistencyConfig consistency_config_;
  ConsistencyMonitor consistency_;
  NoiseAdaptation noise_;
  DeadReckoning dead_reckoning_;
  PoseDoubt doubt_;
  EventsConfig events_config_;
  EventWatch events_;
  relocalisation::Relocaliser relocaliser_;
  MapFragment fragment_;  ///< while the robot is lost
  std::optional<MapState> start_map_;
  std::optional<SavedSession> start_session_;
  std::optional<SavedMap> saved_map_;  ///< of a resumed product, until its first step
  std::optional<Motion> last_motion_;
  std::optional<StepReport> report_;
  std::optional<FilterPose> pose_;
  std::string fault_;  ///< of the map to start with, since the last execute()
  bool paused_ = false;
  Counters counters_;
};

void goOnLive(Estimator& estimator, Interruption interruption);

/// Has the estimator's back-end remove a landmark (LandmarkRemover).
Status removeLandmark(LandmarkId id, const Estimator& estimator);
/// Has a session wait until the estimator's back-end recognises it (SessionMerger).
Status merge(const SavedSession& session, const Estimator& estimator);

}  // namespace slam
