// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/camera/image_gate.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/visual_odometry/alignment.hpp"
#include "slam_core/visual_odometry/features.hpp"
#include "slam_core/visual_odometry/gap_motion.hpp"
#include "slam_core/visual_odometry/visual_odometry_config.hpp"

namespace slam::visual_odometry {

/// The motion of a robot from a camera that looks at the ceiling (thesis 5.5, 6.2.3): features of
/// an image are matched with those of the last keyframe, and the rigid motion that most of them
/// agree with is the robot's. A keyframe stays while enough matches agree, so that a standing robot
/// does not drift.
///
/// Every image after the first yields a motion. Where an image tells nothing the last velocity is
/// assumed to hold, with a standard deviation of max_speed dt, or the gap source is asked; the next
/// image that can be aligned puts the pose where it belongs again.
///
/// Counted: the reasons of the gate, and of images that tell nothing "few_features" (dark, blurred,
/// bare), "few_inliers", "scale" (another surface is seen), "speed", "camera_direction";
/// "keyframes".
class VisualOdometry final : public OdometrySource {
 public:
  void configure(const VisualOdometryConfig& config, const CeilingCameraConfig& camera = {});
  void configure(Settings& settings) override;
  void seed(std::uint64_t seed) override { seed_ = seed; }
  void setGapSource(GapSource source) { gap_source_ = std::move(source); }

  bool usesWheels() const override { return false; }
  bool usesImages() const override { return true; }
  using OdometrySource::set;
  void set(const CameraCalibration& calibration) override { gate_.set(calibration); }
  void set(const CameraMount& mount) override { gate_.set(mount); }
  void set(const Image& image) override { gate_.set(image, counters_); }
  Status execute() override;
  bool isBusy() const override { return gate_.image().has_value(); }

  const std::optional<Motion>& motion() const override { return motion_; }
  const Counters& counters() const override { return counters_; }
  cv::Mat drawing() const override;
  std::vector<std::pair<std::string, double>> figures() const override;
  void reset() override;

  /// Of the last image with the keyframe or the image before.
  const Alignment& alignment() const { return alignment_; }
  /// Whether the last image told nothing.
  bool isLost() const { return last_ && (!last_good_ || last_->stamp != last_good_->stamp); }

 private:
  /// An image and where the robot was.
  struct View {
    Stamp stamp;
    std::shared_ptr<const Features> features;  ///< none of an image that cannot be used
    Pose2 T_odom_base;
  };

  std::string look(View& now);
  std::string locate(View& now);
  bool alignWith(const View& reference, View& now);
  bool isWithinReach(const View& now) const;
  SearchWindow windowFor(const View& reference, Stamp stamp) const;
  void beginAnew();
  void follow(const View& now);
  void bridge(View& now);
  GapMotion coast(Stamp start, Stamp end) const;
  Eigen::Matrix3d covarianceOf(const View& now) const;
  void publish(const View& now, const Eigen::Matrix3d& covariance);
  void chooseKeyframe(const View& now, bool is_good);
  void makeKeyframe(View view);
  void prepare(View& view) const;
  Status explain(const std::string& fault, const Status& gate_status) const;
  std::string sentenceOf(const std::string& fault) const;

  VisualOdometryConfig config_;
  std::unique_ptr<FeaturePolicy> policy_;
  std::uint64_t seed_ = 1;
  GapSource gap_source_;
  ImageGate gate_;
  CeilingView view_;

  std::optional<View> keyframe_, last_, last_good_;
  std::optional<Stamp> gap_begin_;    ///< since when images tell nothing, if they do not
  std::size_t keyframe_inliers_ = 0;  ///< of the first image aligned with the keyframe
  Pose2 T_odom_reference_;            ///< of what alignment_ was made with
  Alignment alignment_;
  std::size_t features_ = 0;
  PointMatches matches_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();        ///< [m/s, m/s, rad/s]
  Eigen::Matrix3d gap_covariance_ = Eigen::Matrix3d::Zero();  ///< since the last good view
  std::uint64_t next_sequence_ = 0, images_ = 0;
  std::optional<Motion> motion_;
  Counters counters_;
};

}  // namespace slam::visual_odometry
