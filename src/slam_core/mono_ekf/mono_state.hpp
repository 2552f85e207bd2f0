// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/mono_ekf/feature.hpp"
#include "slam_core/mono_ekf/odometry_errors.hpp"
#include "slam_core/mono_ekf/pixel_noise.hpp"
#include "slam_core/mono_ekf/scale_error.hpp"

namespace slam::mono_ekf {

/// Innovations of pixels within this gate count: 99 % of a chi-square distribution with two degrees
/// of freedom.
constexpr double kPixelGate = 9.21;

/// A measured pixel as an update sees it: z = prediction + J_pose dx_pose + J_feature dx_feature.
struct Measurement {
  int offset = 0;  ///< of the feature's first coordinate in the state
  Prediction prediction;
  Eigen::Vector2d nu;  ///< what is not explained yet [px]
  /// The Jacobian in the error of the scale (the ScaleError of the update's features). It is zero
  /// unless the measurement is linearised elsewhere than at the state.
  Eigen::Vector2d J_scale = Eigen::Vector2d::Zero();
};

/// They tell how well an update's measurements were predicted.
struct UpdateStatistics {
  /// Whether the update moved the pose by no more than its covariance allows. If not, it was not
  /// done: linearisation does not hold there, or the measurements are not those of the features.
  bool is_credible = true;
  double nis = 0.0;  ///< nu^T S^-1 nu
  PixelScore score;
};

/// The Gaussian over the robot's pose (x, y, theta), the systematic errors of its odometry
/// (OdometryErrors) and the coordinates of all features, map frame, with invariant errors
/// (invariant_step.hpp).
class MonoState {
 public:
  static constexpr int kPose = 3;
  static constexpr int kHead = kPose + kSystematicErrors;  ///< coordinates before the features'

  MonoState() : MonoState(PoseEstimate()) {}
  explicit MonoState(const PoseEstimate& robot);

  PoseEstimate robot() const;
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  const std::vector<Feature>& features() const { return features_; }
  std::vector<Feature>& features() { return features_; }

  /// The robot's motion; all that is known of the features stays.
  void predict(const DividedMotion& motion);
  /// The robot is elsewhere; its correlations with the features become zero.
  void place(const PoseEstimate& robot);

  /// The update of the EKF with all measurements together, unless it is not credible.
  /// @param sigma of a pixel's coordinate [px]
  UpdateStatistics update(const std::vector<Measurement>& measurements, double sigma);

  /// A feature that begins where a pixel looks, its coordinates as an InverseDepth, and their
  /// Jacobians in the robot's pose and in the pixel.
  struct Seed {
    Feature feature;
    Eigen::Matrix<double, 5, 1> coordinates;
    Eigen::Matrix<double, 5, 3> J_pose;
    Eigen::Matrix<double, 5, 2> J_pixel;
  };
  /// Adds them. Half of the variance of their inverse depths is common to them, since what is in
  /// sight is near or far as a whole: else the mean of many would be taken as known, and with it
  /// the scale.
  /// @param sigma of the pixels [px] @param sigma_rho of each inverse depth [1/m]
  void add(const std::vector<Seed>& seeds, double sigma, double sigma_rho);
  /// Takes out the features that are not to be kept, in their order.
  void keep(const std::vector<bool>& kept);

  template <class Archive>
  void persist(Archive& archive) {
    archive(mean_, covariance_, features_);
  }

  /// The robot and some of the features, in this order.
  friend MonoState partOf(const MonoState& state, const std::vector<std::size_t>& features);
  /// Gives those a place in metres whose depth is known well enough.
  friend void convertSure(MonoState& state, const Eigen::Vector3d& centre_now,
                          double largest_linearity_index);

 private:
  bool isCredible(const Eigen::VectorXd& mean) const;
  void moveTo(Eigen::VectorXd mean, const ScaleError& scale, Eigen::MatrixXd of_map);
  void toPoint(int offset, double height);
  void compact(const std::vector<int>& kept_rows);

  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  std::vector<Feature> features_;  ///< in the order of their offsets
};

MonoState partOf(const MonoState& state, const std::vector<std::size_t>& features);
void convertSure(MonoState& state, const Eigen::Vector3d& centre_now,
                 double largest_linearity_index);

/// @return the coordinates of a feature of the state
inline auto coordinatesOf(const MonoState& state, const Feature& feature) {
  return state.mean().segment(feature.offset, feature.size());
}
/// Innovation covariance of a predicted pixel without the noise of the image [px^2].
Eigen::Matrix2d predictedCovariance(const MonoState& state, int offset,
                                    const Prediction& prediction);
/// The state's mean after a step of all coordinates, an invariant one of the positions.
/// @param s of the scale (MapStep)
Eigen::VectorXd stepped(const MonoState& state, const Eigen::VectorXd& step, double s);
/// The state's mean after an update with one measurement alone.
Eigen::VectorXd meanAfter(const MonoState& state, const Measurement& measurement, double sigma);

}  // namespace slam::mono_ekf
