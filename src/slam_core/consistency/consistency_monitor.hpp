// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <deque>
#include <optional>
#include <string>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/consistency/gating_rate.hpp"
#include "slam_core/consistency/innovation_bias.hpp"
#include "slam_core/consistency/odometry_sensitivity.hpp"
#include "slam_core/consistency/serial_correlation.hpp"
#include "slam_core/contract/landmark_mapper.hpp"

namespace slam {

struct ConsistencyConfig {
  static constexpr const char* kSection = "consistency";

  int window = 50;
  double warning_factor = 1.5;
  bool adapt = true;

  void describe(Fields& fields);
};

/// Watches whether the innovations are as large as their predicted covariance and, if they are not,
/// which of three sources is to blame: the noise of ranges, of bearings, or of the odometry. The
/// factors on the three that explain a window of innovations best are found by one step of Fisher
/// scoring on their likelihood (Harville 1977; where S is linear in the variances this is MINQUE,
/// Rao 1971), with a prior that keeps them near 1. Mehra 1970 finds the noise of a Kalman filter by
/// the autocorrelation of its innovations instead. The noise of a sensor is independent between
/// landmarks, whereas the error of a prediction is common to all observations of a stamp, so that
/// the two can be separated if several landmarks are seen. OdometrySensitivity gives the odometry's
/// share of an innovation. If the back-end reports too little for that, the whole covariance of the
/// prediction counts as the odometry's.
///
/// This holds for zero-mean noise only. So before a sigma is named, two other explanations are
/// tried: the pose is lost (GatingRate), or the innovations are biased (InnovationBias). While one
/// of them is likely, fault(), finding() and overconfident() name no sigma.
class ConsistencyMonitor {
 public:
  enum Source : std::size_t { kRange, kBearing, kMotion, kSources };
  /// After kNone, the faults stand in the order of their severity, the most severe one first.
  enum class Fault { kNone, kLost, kBias, kRangeSigma, kBearingSigma, kMotionSigma };

  /// The estimate for one source over the window.
  struct Factor {
    double sigma = 1.0;        ///< true over believed standard deviation
    double uncertainty = 0.0;  ///< standard deviation of `sigma`; 0 before the first update
    double evidence = 0.0;     ///< against its being right, in standard deviations

    template <class Archive>
    void persist(Archive& archive) {
      archive(sigma, uncertainty, evidence);
    }
  };

  explicit ConsistencyMonitor(const ConsistencyConfig& config = {});

  /// To be called once for each step. Steps without observations of known landmarks are ignored.
  void add(const UpdateStatistics& statistics);

  int updates() const { return static_cast<int>(window_.size()); }
  /// Normalised innovation squared (NIS) of the last update, without gated observations.
  double nis() const { return last_nis_; }
  /// NIS of the window per degree of freedom (1 expected), gated observations included unless their
  /// NIS is 100 or more, and the bounds between which it lies for 95 % of all windows (Bar-Shalom,
  /// Li, Kirubarajan 2001, sec. 5.4).
  double nisMean() const;
  std::array<double, 2> nisBounds() const;
  const std::array<Factor, kSources>& factors() const { return factors_; }
  /// The most severe fault as a sentence, such as "40 of the last 50 observations failed the gate:
  /// the pose may be lost" or "range sigma looks 3.0 times too small (...)"; empty where there is
  /// none. A wrong sensor sigma makes the prediction wrong as well, so that the odometry is named
  /// only where no sensor is suspicious.
  std::string finding() const;
  /// Why the back-end is over-confident. A sigma that is too large is no fault: it may cover errors
  /// that are correlated from step to step, which the innovations do not show.
  Fault fault() const;
  /// The source whose sigma is named as too small.
  std::optional<Source> overconfident() const;

  static const char* name(Source source);
  friend const InnovationBias& biasOf(const ConsistencyMonitor& monitor) { return monitor.bias_; }
  /// The source whose sigma looks too small or too large. Unlike overconfident(), this does not
  /// check for a lost pose.
  friend std::optional<Source> blamedOf(const ConsistencyMonitor& monitor) {
    return monitor.blamed_;
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(gating_, bias_, serial_, odometry_, window_, last_nis_, factors_, is_lost_, is_biased_,
            blamed_, agreeing_.bias, agreeing_.sensor, agreeing_.motion);
  }

 private:
  /// The derivative of the log-likelihood with respect to the three variances, and its Fisher
  /// information.
  struct Score {
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double nis = 0.0;
    int dof = 0;

    template <class Archive>
    void persist(Archive& archive) {
      archive(slope, information, nis, dof);
    }
  };
  Score scoreOf(const UpdateStatistics& statistics);
  void addGroup(const JointInnovation& group, Score& score) const;
  void judge();
  void blame();
  Source sensorInQuestion() const;
  bool isOff(Source source, double by, double significant) const;
  bool isSystematic(Source sensor) const;

  ConsistencyConfig config_;
  GatingRate gating_;
  InnovationBias bias_;
  SerialCorrelation serial_;
  OdometrySensitivity odometry_;
  std::deque<Score> window_;
  double last_nis_ = 0.0;
  std::array<Factor, kSources> factors_;
  bool is_lost_ = false, is_biased_ = false;
  std::optional<Source> blamed_;  ///< the source whose sigma is wrong
  /// For each finding, the number of successive updates that agree with it.
  struct {
    int bias = 0, sensor = 0, motion = 0;
  } agreeing_;
};

}  // namespace slam
