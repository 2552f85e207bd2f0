// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <utility>

#include "slam_core/models/coasting.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/usual_interval.hpp"
#include "slam_core/models/usual_step.hpp"

namespace slam {

/// What stopped before a state was restored.
enum class Interruption {
  kOfThisProcess,  ///< what measures odometry ran on in another one
  kOfAll,          ///< perhaps the odometry as well, and somebody may have carried the robot
};

/// Bridges the gaps between an odometry's motions, whatever made them: messages lost, a source that
/// was restarted, an odometry that was silent and reports the motion since then as one. Each motion
/// carries the odometry's poses, whose difference is the motion in the gap. They are as the wheels
/// measured them, and are scaled as the increments were so far. They have no covariance: the noise
/// is assumed to have been, all the while, that of the odometry's worst tenth of a second so far.
/// They do not tell the way between them either: the robot may have driven a detour at its largest
/// speed so far, on which an error of the heading leads further away. An odometry that reports
/// by way (UsualStep) sends nothing while the robot stands: a usual step after a pause has the
/// noise of one, though nobody knows when in the pause it was made. Where the poses do not belong
/// together, as of an odometry that was restarted as well, the robot is assumed to have gone on at
/// its last velocity. Motions of a burst tell neither a speed nor a noise in time.
class MotionGap {
 public:
  enum class Bridge {
    kNone,
    kByPoses,
    kByVelocity,
    kUnknown,  ///< only after resume(): the motion belongs to what nobody knows, leave it out
  };

  /// @return how what is missing before this motion was made up for: it now begins where the last
  /// one ended; one that is older than the last one is left alone
  Bridge bridge(Motion& motion);

  /// From when to when nobody knows where on its way the robot was, of the motion that bridge() had
  /// last: motion that came more often is missing, and the robot has moved meanwhile.
  const std::optional<std::pair<Stamp, Stamp>>& unknownWay() const { return unknown_way_; }

  /// The motions so far are those of a saved state, and the next one comes from a process that runs
  /// now. Unless the odometry has evidently gone on meanwhile, its poses tell nothing: a pause of
  /// up to 10 s is bridged by the last velocity, a longer one is not bridged.
  void resume(Interruption interruption) { resumed_after_ = interruption; }
  /// @return whether the odometry seems to have gone on, as the first motion after resume() shows;
  /// nothing for all other motions
  std::optional<bool> wentOn() const { return went_on_; }

  void reset() { *this = {}; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(last_, before_jump_, since_jump_, usual_, usual_step_, span_, span_covariance_,
            worst_rate_, knows_rate_, way_scale_, turn_scale_, coasting_);
  }

 private:
  /// True over measured by least squares, beginning with 1.
  class Scale {
   public:
    void add(double told_by_measured, double measured_squared) {
      above_ += told_by_measured;
      below_ += measured_squared;
    }
    double value() const { return above_ / below_; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(above_, below_);
    }

   private:
    static constexpr double kFirst =
        1e-8;  ///< a tenth of a millimetre or of a milliradian, squared
    double above_ = kFirst, below_ = kFirst;
  };

  /// The motion that this one may follow, where there are two: one before its stamps jumped.
  std::optional<Motion> predecessorOf(const Motion& motion);
  void learnRate(const Motion& motion);
  void learnScales(const Motion& motion);
  Pose2 scaled(const Pose2& measured) const;
  Motion across(const Motion& before, const Motion& after) const;
  Motion onAnyWay(Motion motion) const;
  Motion coasted(const Motion& before, const Motion& after) const;
  bool posesTell(const Motion& before, const Motion& after) const;
  bool wentOn(const Motion& before, const Motion& after, Interruption interruption) const;

  std::optional<Motion> last_;
  std::optional<Motion> before_jump_;  ///< of the stamps, ahead or back
  int since_jump_ = 0;                 ///< motions
  UsualInterval usual_;                ///< of the motions
  UsualStep usual_step_;               ///< of the motions
  Duration span_{};                    ///< of increments since the last rate
  Eigen::Matrix3d span_covariance_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d worst_rate_ = Eigen::Matrix3d::Zero();  ///< covariance in a second
  bool knows_rate_ = false;
  Scale way_scale_, turn_scale_;
  Coasting coasting_;
  std::optional<Interruption> resumed_after_;           ///< and no motion has come since
  std::optional<bool> went_on_;                         ///< not part of the state
  std::optional<std::pair<Stamp, Stamp>> unknown_way_;  ///< neither is this
};

}  // namespace slam
