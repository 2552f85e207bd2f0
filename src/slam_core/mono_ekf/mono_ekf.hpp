// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/consistency/place_agreement.hpp"
#include "slam_core/consistency/tracking_doubt.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/feature_mapper.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/view_reporter.hpp"
#include "slam_core/mono_ekf/active_search.hpp"
#include "slam_core/mono_ekf/mono_state.hpp"
#include "slam_core/mono_ekf/odometry_errors.hpp"
#include "slam_core/mono_ekf/pixel_noise.hpp"
#include "slam_core/mono_ekf/place_search.hpp"

namespace slam::mono_ekf {

/// The back-end of MonoSLAM (Davison et al. 2007) with features in inverse depth (Civera, Davison
/// and Montiel 2008): an extended Kalman filter over the pose of a robot in the plane and over the
/// natural corners that its camera sees. Odometry predicts the pose and gives the scale.
///
/// An image that shows nothing leaves the pose to odometry, which is counted and reported:
/// "unusable" (without calibration, mount or pixels, or repeated), "blank" (nothing to track),
/// "contradicted" (features are not where they are predicted).
/// "behind" counts images most of whose features seem to lie behind the camera. A warning says that
/// odometry or the mount is wrong.
/// Further counted: features "matched", "rejected" (found, but the others do not agree),
/// "not_found", "added", "given_up"; "tracking_lost" (times).
class MonoEkf final : public Backend,
                      CorrectionReporter,
                      FeatureMapper,
                      LostReporter,
                      ViewDrawer,
                      ViewReporter {
 public:
  /// @throw ConfigError
  void configure(const MonoEkfConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  Status execute() override;
  PoseEstimate pose() const override;
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  /// The robot and the map as the filter has them.
  const MonoState& state() const { return state_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(state_, errors_, noise_, doubt_, agreement_, before_, corrected_by_, inputs_, next_id_,
            counters_);
    if constexpr (Archive::kReads) place_search_.reset();
  }

 private:
  /// These inputs were set since the last step.
  struct Inputs {
    std::optional<PoseEstimate> initial_pose;
    std::vector<Motion> motions;
    std::optional<CameraView> view;

    void set(const Motion& motion) { motions.push_back(motion); }
    void set(const CameraView& seen) { view = seen; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(initial_pose, motions, view);
    }
  };
  /// It keeps what the last image showed, to draw it.
  struct Seen {
    cv::Mat gray;
    std::vector<Search> searches;
    std::vector<bool> are_points;  ///< of each search, whether its depth is known
    std::vector<Eigen::Vector2d> added;
  };

  // what it offers as capabilities
  std::optional<Stamp> correctedBy() const override { return corrected_by_; }
  std::vector<MappedFeature> features() const override;
  std::optional<Stamp> lostSince() const override { return doubt_.lostSince(); }
  bool findsItself() const override { return true; }
  cv::Mat drawing() const override;
  std::optional<ViewStatistics> viewStatistics() const override;

  void relocate();
  Status look(const CameraView& view);
  void take(std::vector<Search> searches, const PlanarCamera& camera);
  void measure(std::vector<Search>& searches, const PlanarCamera& camera);
  std::optional<Stamp> firstSeen() const;
  void judgeExistence();
  std::size_t beginFeatures(const PlanarCamera& camera, const cv::Mat& gray, Stamp stamp);
  void removeFeatures();
  Status judge(Stamp stamp, std::size_t corners);
  Status judgeDepths();
  ViewOfMap viewOfMap() const;
  void lose();
  bool findItself(const PlanarCamera& camera, const cv::Mat& gray);
  void putAt(const PoseEstimate& robot);
  double radiusOfMap() const;  ///< around the robot [m]

  MonoEkfConfig config_;
  ActiveSearch active_search_;
  MonoState state_;
  OdometryErrors errors_;
  PixelNoise noise_;
  TrackingDoubt doubt_;
  PlaceAgreement agreement_;
  std::optional<MonoState> before_;          ///< the doubt, if there is one
  std::optional<PlaceSearch> place_search_;  ///< in the map of a lost robot
  std::optional<Stamp> corrected_by_;        ///< in the last step
  Inputs inputs_;
  std::uint64_t next_id_ = 0;
  double nis_ = 0.0;  ///< of the last update, per degree of freedom
  Seen seen_;
  bool has_view_ = false;  ///< the last step had an image that could be used
  Counters counters_;
};

}  // namespace slam::mono_ekf
