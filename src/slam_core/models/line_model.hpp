// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam {

/// How the straight face of a wall looks to a sensor on the robot. z: length [m] and direction
/// [rad] of the perpendicular from the sensor. m: the line's offset [m] along its perpendicular
/// from a fixed point near it, the anchor, and the direction of that perpendicular [rad], away from
/// the side that is seen. The Hessian normal form, with the anchor for the origin: an error of the
/// direction has no lever, the offset may have either sign, and the two faces of a wall differ
/// (as in the SPmap, Castellanos, Tardos 1999, errors are local to the feature).
class LineModel final : public ObservationModel {
 public:
  /// @param anchor in the map frame [m]
  explicit LineModel(const Eigen::Vector2d& anchor = Eigen::Vector2d::Zero()) : anchor_(anchor) {}
  /// The model of a line that was seen for the first time: its anchor is the middle of what was
  /// seen.
  LineModel(const Pose2& T_map_sensor, const LandmarkObservation& z);

  Eigen::Vector2d predict(const Pose2& T_map_base, const Pose2& T_base_sensor,
                          const Eigen::Vector2d& m_map, Jacobian23* J_z_robot = nullptr,
                          Eigen::Matrix2d* J_z_m = nullptr) const override;
  Eigen::Vector2d invert(const Pose2& T_map_base, const Pose2& T_base_sensor,
                         const Eigen::Vector2d& z, Jacobian23* J_m_robot = nullptr,
                         Eigen::Matrix2d* J_m_z = nullptr) const override;
  Eigen::Vector2d innovation(const Eigen::Vector2d& z,
                             const Eigen::Vector2d& z_predicted) const override;
  /// Whether the sensor stands behind the face, or in it.
  bool isSingular(const Eigen::Vector2d& z_predicted) const override;

  /// The line when the map has turned about its origin [rad], and the derivative of that.
  Eigen::Vector2d turned(const Eigen::Vector2d& m_map, double angle) const;
  Eigen::Vector2d turnDerivative(const Eigen::Vector2d& m_map) const;

  /// The part of the line that was seen, from the point of it that is nearest to the anchor [m].
  LineExtent extentOf(const Pose2& T_map_sensor, const LandmarkObservation& z,
                      const Eigen::Vector2d& m_map) const;
  /// The line as a map has it.
  Landmark landmarkOf(LandmarkId id, const Eigen::Vector2d& m_map, const LineExtent& extent) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(anchor_);
  }

 private:
  Eigen::Vector2d anchor_;
};

/// A line of the map as it enters it: its model, and the part of it that was seen.
struct MappedLine {
  LineModel model;
  LineExtent extent;

  template <class Archive>
  void persist(Archive& archive) {
    archive(model, extent);
  }
};

/// Parts of a line that are farther apart are two lines, as walls beside a gate [m].
constexpr double kLargestLineGap = 1.2;

/// The part that covers both.
LineExtent united(const LineExtent& a, const LineExtent& b);
/// How far apart two parts of a line are; below 0 where they overlap [m].
double gapBetween(const LineExtent& a, const LineExtent& b);

}  // namespace slam
