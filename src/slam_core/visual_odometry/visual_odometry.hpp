// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/visual_odometry/increment_maker.hpp"
#include "slam_core/visual_odometry/view_matcher.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// The motion of a robot from a camera that looks at the ceiling (thesis 5.5, 6.2.3): features of
/// an image are matched with those of the last keyframe, and the rigid motion that most of them
/// agree with is the robot's. A keyframe stays while enough matches agree, so that a standing robot
/// does not drift.
///
/// Every image after the first yields a motion. Where an image tells nothing the last velocity is
/// assumed to hold, with a standard deviation of max_speed dt, or the gap source is asked; where a
/// turn source knows the turn, that is taken. The next image that can be aligned puts the pose
/// where it belongs again.
///
/// Counted: of images that tell nothing "few_features" (dark, blurred,
/// bare), "few_inliers", "scale" (another surface is seen), "speed", "camera_direction";
/// "keyframes".
class VisualOdometry final : public OdometrySource, public ViewDrawer {
 public:
  void configure(const VisualOdometryConfig& config);
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { matcher_.seed(seed); }
  void setGapSource(GapSource source) { increments_.setGapSource(std::move(source)); }
  void setTurnSource(TurnSource source) { increments_.setTurnSource(std::move(source)); }

  void describe(Ports& ports) override;
  void set(const CameraView& view) { next_view_ = view; }
  Status execute() override;

  const std::optional<Motion>& motion() const override { return motion_; }
  std::string name() const override { return "visual"; }
  Counters counters() const override { return counters_; }
  cv::Mat drawing() const override;
  Figures figures() const override;
  void reset() override;
  void goOnLive() override { reset(); }
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  /// Whether the images measured the last motion from its start to its end.
  bool isMeasured() const { return is_measured_; }
  /// Whether the motion up to the last image is unknown.
  bool isLost() const {
    return views_.last && (!views_.last_good || views_.last->stamp != views_.last_good->stamp);
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(matcher_, views_, increments_, is_measured_, counters_);
  }

 private:
  /// The views that a present one is compared with.
  struct Views {
    std::optional<View> keyframe, last, last_good;
    std::optional<Stamp> gap_begin;    ///< since when images tell nothing, if they do not
    std::size_t keyframe_inliers = 0;  ///< of the first image aligned with the keyframe
    Pose2 T_odom_reference;            ///< of what the present one was aligned with

    template <class Archive>
    void persist(Archive& archive) {
      archive(keyframe, last, last_good, gap_begin, keyframe_inliers, T_odom_reference);
    }
  };

  bool tells(const CameraView& view) const;
  std::string look(View& now);
  std::string locate(View& now);
  std::string alignWith(const View& reference, View& now);
  bool isWithinReach(const View& now) const;
  SearchWindow windowFor(const View& reference, Stamp stamp) const;
  void beginAnew();
  bool chooseKeyframe(const View& now, bool is_good);
  bool makeKeyframe(View view);
  Status explain(const std::string& fault) const;
  std::string sentenceOf(const std::string& fault) const;

  VisualOdometryConfig config_;
  std::optional<CameraView> next_view_, view_;  ///< of the next step and of the last one
  ViewMatcher matcher_;
  Views views_;
  IncrementMaker increments_;
  std::optional<Motion> motion_;
  bool is_measured_ = false;
  Counters counters_;
};

}  // namespace slam::visual_odometry
