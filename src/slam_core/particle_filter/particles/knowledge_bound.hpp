// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/observation_model.hpp"
#include "slam_core/particle_filter/particles/genealogy.hpp"

namespace slam::particle_filter {

/// How well pose and landmarks can be known at best, as covariances that grow and shrink beside the
/// particles. Particles forget: whenever they are drawn anew, what they disagreed on in the past
/// becomes what one ancestor happened to think, and their spread says nothing of it any more
/// (Bailey, Nieto, Nebot 2006). Here nothing is forgotten, and nobody keeps the correlations
/// between pose and landmarks either: what is known of the one enters the other by covariance
/// intersection, which is right whatever they are (Julier, Uhlmann 2007); only the noise of motion
/// and of observations counts as independent. It errs on the side of caution. So it stands for the
/// particles' covariance only in so far as that is forgotten (Genealogy).
class KnowledgeBound {
 public:
  /// No landmarks, and a pose that the particles know nothing else of.
  void restart(const Eigen::Matrix3d& pose);
  /// Landmarks from elsewhere: what their errors have in common the particles have never known.
  void load(const LandmarkMap& map, double inflation);
  /// What the particles' spread has never shown.
  void setPose(const Eigen::Matrix3d& covariance);
  /// The genealogy of the particles. The caller gives it their weights and resampling steps.
  Genealogy& genealogy() { return genealogy_; }

  /// @param from the pose before the motion
  void move(const Pose2& from, const Motion& motion);

  /// An observation of a landmark that fits.
  /// @param map_is_fixed what is known of the landmark stays
  void observe(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
               const Eigen::Vector2d& landmark, std::size_t number, const LandmarkObservation& z,
               bool map_is_fixed);

  /// A landmark that an observation puts into the map, the next one or one of it anew.
  void begin(const ObservationModel& model, const Pose2& robot, const Pose2& sensor,
             std::size_t number, const LandmarkObservation& z);

  const Eigen::Matrix3d& pose() const { return pose_; }

  /// What to tell where the particles say `covariance`.
  Eigen::Matrix3d told(const Eigen::Matrix3d& covariance) const;
  Eigen::Matrix2d told(const Eigen::Matrix2d& covariance, std::size_t number) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(pose_, pose_since_, genealogy_, landmarks_);
  }

 private:
  struct Landmark {
    Eigen::Matrix2d covariance;
    double since;  ///< genealogy's time when it was begun

    template <class Archive>
    void persist(Archive& archive) {
      archive(covariance, since);
    }
  };

  Eigen::Matrix3d pose_ = Eigen::Matrix3d::Zero();
  double pose_since_ = 0.0;
  Genealogy genealogy_;
  std::vector<Landmark> landmarks_;  ///< by number
};

/// The covariance after an observation with the Jacobian H whose noise has the covariance
/// `independent`, and beyond that one, `other`, that may be correlated with `own` in any way: split
/// covariance intersection with the weight that leaves the smallest volume.
template <int N>
Eigen::Matrix<double, N, N> intersected(const Eigen::Matrix<double, N, N>& own,
                                        const Eigen::Matrix<double, 2, N>& H,
                                        const Eigen::Matrix2d& other,
                                        const Eigen::Matrix2d& independent);

/// The smallest covariance that is nowhere below either of two: their maximum along the axes that
/// both have in common.
template <int N>
Eigen::Matrix<double, N, N> atLeast(const Eigen::Matrix<double, N, N>& bound,
                                    const Eigen::Matrix<double, N, N>& covariance);

}  // namespace slam::particle_filter
