// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam_core/common/time.hpp"
#include "slam_core/models/landmark_map.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"

namespace slam {

/// How far an observation of a known landmark was from the prediction.
struct ObservationInnovation {
  LandmarkId id = kUnknownId;
  Eigen::Vector2d nu = Eigen::Vector2d::Zero();  ///< in range [m] and bearing [rad]
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();   ///< its covariance, as the back-end predicts it
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();   ///< the observation's part of it
  bool used = false;                             ///< it passed the gate

  template <class Archive>
  void persist(Archive& archive) {
    archive(id, nu, S, R, used);
  }
};

/// What an observation was taken for.
enum class TakenFor {
  kLandmark,
  kNew,
  kGated,
  kAmbiguous,
  kOnTrial,
  kNotInMap,
  kNothing,
  kTakenBack  ///< it was taken for the wrong landmark before
};

/// What an observation was taken for, in a back-end in which ids do not decide.
struct AssociatedObservation {
  LandmarkId own_id = kUnknownId;    ///< the observation's id, which was not used
  LandmarkId landmark = kUnknownId;  ///< the landmark's id, if it was taken for one
  TakenFor taken_for = TakenFor::kNothing;

  template <class Archive>
  void persist(Archive& archive) {
    archive(own_id, landmark, taken_for);
  }
};

/// A decision on an observation of an earlier step that replaces the first one.
struct RevisedAssociation {
  Stamp stamp;  ///< of that step
  AssociatedObservation observation;

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, observation);
  }
};

/// The innovation of several observations with one stamp together, (range, bearing) one after the
/// other.
struct JointInnovation {
  Eigen::VectorXd nu;
  Eigen::MatrixXd S, R;
  /// Jacobian of the prediction by the pose (x, y, theta), map frame; empty if it is not known.
  Eigen::MatrixX3d H;

  template <class Archive>
  void persist(Archive& archive) {
    archive(nu, S, R, H);
  }
};

/// What the last execute() made of its observations.
struct UpdateStatistics {
  double nis = 0.0;   ///< normalised innovation squared of the used observations together
  int nis_dof = 0;    ///< its degrees of freedom
  int used = 0;       ///< observations of known landmarks that went into the update
  int gated = 0;      ///< outside the chi-square gate, left out
  int added = 0;      ///< landmarks seen for the first time
  int unknown = 0;    ///< left out: its landmark is unknown, or is not in the map
  int landmarks = 0;  ///< in the map after the step
  /// The probability that a correct observation passes the gate. If more are gated, something is
  /// wrong.
  double gate_probability = 0.9999;
  /// log N(nu; 0, S) of the observations of known landmarks. Outside the gate the density falls
  /// like a power of the distance instead, so that an outlier costs more the smaller S is.
  double log_likelihood = 0.0;
  /// One for each observation of a known landmark, gated ones included, in the order of the
  /// observations.
  std::vector<ObservationInnovation> innovations;
  /// One for each observation, in their order, if the back-end associates by place; else empty.
  std::vector<AssociatedObservation> associations;
  std::vector<RevisedAssociation> revised_associations;  ///< in the order of their decision
  JointInnovation joint;      ///< of the used observations, the first kJoint of them
  PosePrediction prediction;  ///< before the observations; valid only if joint.H is known

  static constexpr std::size_t kJoint = 8;

  template <class Archive>
  void persist(Archive& archive) {
    archive(nis, nis_dof, used, gated, added, unknown, landmarks, gate_probability, log_likelihood,
            innovations, associations, revised_associations, joint, prediction);
  }
};

/// The capability of a back-end whose map has landmarks.
class LandmarkMapper {
 public:
  virtual ~LandmarkMapper() = default;
  virtual LandmarkMap landmarks() const = 0;  ///< sorted by id
  virtual UpdateStatistics statistics() const = 0;
  /// Whether it maps lines as well as points. If not, it is given none.
  virtual bool takesLines() const { return false; }
};

}  // namespace slam
