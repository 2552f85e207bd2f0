// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/consistency/place_agreement.hpp"
#include "slam_core/consistency/tracking_doubt.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/event_reporter.hpp"
#include "slam_core/contract/feature_mapper.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/place_reporter.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/contract/view_reporter.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/mono_graph/image_continuity.hpp"
#include "slam_core/mono_graph/local_mapper.hpp"
#include "slam_core/mono_graph/loop_closer.hpp"
#include "slam_core/mono_graph/mono_graph_config.hpp"
#include "slam_core/mono_graph/odometry_anchor.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/place_recogniser.hpp"
#include "slam_core/mono_graph/standstill_watch.hpp"
#include "slam_core/mono_graph/tracker.hpp"
#include "slam_core/mono_graph/visual_map.hpp"
#include "slam_core/mono_graph/vocabulary.hpp"

namespace slam::mono_graph {

/// SLAM with keyframes of one camera that looks ahead (the strategy of ORB-SLAM: Mur-Artal,
/// Montiel, Tardos 2015), for a robot on the plane whose odometry gives the scale: each image is
/// tracked in the map of points, some become keyframes, and those around the newest are adjusted
/// together. Places are recognised by visual words: a loop moves all keyframes, and a lost robot
/// is found.
///
/// Counted: "untracked" (images that show too few points of the map), "matched" and "rejected"
/// (points that were found, and that do not fit the pose), "blank" (images with too few features),
/// "unusable" (without calibration, mount or pixels, or repeated), "keyframes_full",
/// "without_points" (keyframes that see much, but no points that fit odometry's way), "loops" (that
/// were believed), "loops_rejected" (that the map contradicts, or that wait for another one).
class MonoGraph final : public Backend,
                        CorrectionReporter,
                        EventReporter,
                        FeatureMapper,
                        GraphReporter,
                        LostReporter,
                        PathReviser,
                        PlaceReporter,
                        ViewDrawer,
                        ViewReporter {
 public:
  /// @throw ConfigError
  void configure(const MonoGraphConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void seed(std::uint64_t seed) override { seed_ = seed; }
  void set(const PoseEstimate& initial_pose) override { inputs_.initial_pose = initial_pose; }
  Status execute() override;
  PoseEstimate pose() const override;
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(map_, mapper_, recogniser_, closer_, anchor_, way_, is_way_known_, way_without_points_,
            reference_, unadjusted_, unrecognised_, last_, doubt_, continuity_, standstill_,
            agreement_, is_tracked_, pose_, covariance_, path_, events_, inputs_, counters_);
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
  /// A step of the way, relative to the keyframe that it was tracked by.
  struct WayPoint {
    Stamp stamp;
    std::optional<int> keyframe;
    Pose2 pose;                        ///< in the keyframe; in the map where there is none
    std::optional<Stamp> first_visit;  ///< of the place, where points show it

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, keyframe, pose, first_visit);
    }
  };

  /// The last image, for those who want to see it.
  struct Seen {
    cv::Mat gray;
    Features features;
    TrackedView tracked;
  };

  // what it offers as capabilities
  std::optional<Stamp> correctedBy() const override {
    return isLost() ? std::nullopt : firstVisit();
  }
  std::vector<Event> events() const override { return events_; }
  GraphView graph() const override;
  std::optional<Stamp> lostSince() const override;
  bool findsItself() const override { return true; }
  std::vector<StampedPose> path() const override;
  std::vector<PlaceVisit> visits() const override;
  std::vector<MappedFeature> features() const override;
  cv::Mat drawing() const override;
  std::optional<ViewStatistics> viewStatistics() const override;

  // the lines of execute()
  void relocate();
  void move(const Motion& motion);
  void predict();
  Status see(const CameraView& view);
  void noteStep(Stamp stamp);

  // what an image leads to
  Status follow(const CameraView& view, const Features& features);
  bool isLost() const { return doubt_.isLost() || continuity_.isLost() || standstill_.isLost(); }
  bool mayMap() const { return doubt_.admits() && continuity_.admits(); }
  void lookForPlace(const Features& features);
  TrackedView tracked(const Features& features) const;
  bool showsRobot(const TrackedView& tracked) const;
  bool correctStep(const Features& features);
  void believe(const TrackedView& tracked);
  ViewOfMap viewOfMap(const Features& features, const TrackedView& tracked) const;
  bool wantsKeyframe(const TrackedView& tracked) const;
  bool isFarFromKeyframes(double share) const;
  Status addKeyframe(const CameraView& view, const Features& features, const TrackedView& tracked);
  Status judgeMapping(int number);
  Pose2 poseByImages(const Features& features) const;
  void finishKeyframe();
  void adjust(int keyframe);
  void recognise(int keyframe);
  std::set<int> knownAround(int keyframe) const;
  void noteLoop(const RecognisedPlace& place, const Pose2& before, const Pose2& after);
  /// The robot is somewhere else than odometry leads to.
  void putAt(const Pose2& pose, const Eigen::Matrix3d& covariance);

  std::optional<int> nearestKeyframe() const;
  double radiusOfMap() const;  ///< around the robot [m]
  std::optional<Stamp> firstVisit() const;

  MonoGraphConfig config_;
  std::uint64_t seed_ = 1;
  OrbExtractor orb_;
  Vocabulary vocabulary_;
  VisualMap map_;
  LocalMapper mapper_;
  PlaceRecogniser recogniser_;
  LoopCloser closer_;
  OdometryAnchor anchor_;            ///< where points showed the robot last
  Features last_;                    ///< of the image with which the anchor's step began
  OdometryAnchor way_;               ///< odometry since the newest keyframe
  bool is_way_known_ = false;        ///< there is one, and no jump came since
  double way_without_points_ = 0.0;  ///< since a keyframe had enough points [m]
  std::optional<int> reference_;     ///< the keyframe that the robot is tracked by
  std::optional<int> unadjusted_;    ///< the newest one, if the map around it was not adjusted yet
  std::optional<int> unrecognised_;  ///< one whose place has not been looked up yet
  TrackingDoubt doubt_;
  ImageContinuity continuity_;
  StandstillWatch standstill_;
  PlaceAgreement agreement_;
  bool is_tracked_ = false;  ///< the last image shows where the robot is
  Pose2 pose_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  ///< relative to the reference
  std::vector<WayPoint> path_;
  Seen seen_;
  bool has_view_ = false;      ///< the last step had an image that could be used
  std::vector<Event> events_;  ///< of the last step
  Inputs inputs_;
  Counters counters_;
};

}  // namespace slam::mono_graph
