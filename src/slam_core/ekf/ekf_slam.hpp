// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "slam_core/association/sightings.hpp"
#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/ekf/association.hpp"
#include "slam_core/ekf/ekf_config.hpp"
#include "slam_core/ekf/ekf_state.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::ekf {

/// EKF-SLAM with a map of points and lines (thesis 5.1; Thrun, Burgard, Fox 2005, sec. 10.2 and
/// 10.3), but with one joint, iterated update of all observations of a stamp. The variant of the
/// filter is that of its linearisation (linearization.hpp) and of its Gaussian transform, extended
/// or unscented (gaussian_transform.hpp). A step costs O(n^2) in the n landmarks of the
/// neighbourhood instead of those of the whole map (neighbourhood.hpp).
class EkfSlam final : public Backend,
                      LandmarkMapper,
                      LandmarkRemover,
                      MapKeeper,
                      AssociationChooser,
                      Calibrator {
 public:
  /// @throw ConfigError
  void configure(const EkfConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const Motion& motion);
  void set(const LandmarkObservationArray& observations) { observations_ = observations; }
  void set(const PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  Status execute() override;

  PoseEstimate pose() const override;
  Counters counters() const override { return counters_; }
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(associator_, state_, sightings_, statistics_, counters_, map_, initial_pose_, motion_,
            observations_, frame_, J_motion_, velocity_);
  }

 private:
  // what it offers as capabilities
  LandmarkMap landmarks() const override;
  UpdateStatistics statistics() const override { return statistics_; }
  bool takesLines() const override { return true; }
  Status remove(LandmarkId id) override;
  MapState state() const override;
  void set(const MapState& map) override { map_ = map; }
  void useAssociation(const std::string& policy) override { association_ = policy; }
  std::optional<CalibrationEstimate> calibration() const override { return state_.calibration(); }
  const CalibrationConfig& calibrationConfig() const override { return config_.calibration; }
  LandmarkObservationArray corrected(const LandmarkObservationArray& array) const override {
    return calibrated(array, velocity_, *state_.parameters());
  }

  PoseEstimate estimate() const;
  NewLandmark initialized(const LandmarkObservation& z, const Pose2& sensor) const;
  StretchLimits limits() const;
  std::optional<CalibrationEstimate> calibrationPrior() const;
  void followVelocity(const Motion& motion);
  void move(const SensorFrame::Transition& transition);
  LandmarkObservationArray takeObservations();
  void replaceMap();
  void relocate();
  void predict();
  Status update(const std::vector<Match>& matches, const Pose2& sensor);
  Status reconsider(const Association& association, const Pose2& sensor);
  Status reinitialize(const association::Sightings::Verdict& verdict, const Pose2& sensor);
  Status augment(Association& association, const Pose2& sensor);
  void removeGhosts(const Association& association, const Pose2& sensor);
  Status summary(const Association& association, const std::vector<Status>& of_steps) const;

  std::string association_ = "known_ids";
  EkfConfig config_;
  RangeBearingModel model_;
  Associator associator_;
  FilterVariant variant_;
  EkfState state_;
  association::Sightings sightings_;
  UpdateStatistics statistics_;
  Counters counters_;

  std::optional<MapState> map_;
  std::optional<PoseEstimate> initial_pose_;
  std::optional<Motion> motion_;     ///< all motions since the last step as one, calibrated
  CalibrationJacobian<3> J_motion_;  ///< of its increment
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< filtered [m/s, m/s, rad/s]
  SensorFrame frame_;                                   ///< of the state, where it calibrates
  std::optional<LandmarkObservationArray> observations_;
};

}  // namespace slam::ekf
