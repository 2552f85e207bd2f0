// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/association/place_config.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam::association {

/// A landmark that an observation may be of.
struct Candidate {
  std::size_t landmark = 0;  ///< the asker's own number of it
  Eigen::Vector2d nu =
      Eigen::Vector2d::Zero();  ///< observed less predicted: range [m], bearing [rad]
  Eigen::Matrix2d S =
      Eigen::Matrix2d::Zero();  ///< its covariance, the observation's noise included
  /// The descriptor adds this to the cost of the pairing (see Option). Policies fill it in.
  double descriptor_cost = 0.0;
};

/// The observation with this number and the landmark it is taken for.
struct Pairing {
  std::size_t observation = 0;
  std::size_t landmark = 0;
};

/// The map of whoever asks: of an EKF, or of one particle. Landmarks are numbered as the asker
/// likes, from 0 to size() - 1.
class CandidateSource {
 public:
  virtual ~CandidateSource() = default;

  virtual std::size_t size() const = 0;
  /// The landmark with this id.
  virtual std::optional<std::size_t> find(LandmarkId id) const = 0;
  /// Appends what the observation with this number may be of by its place: all landmarks within the
  /// asker's gate, maybe others. Only where the policy usesPlaces().
  virtual void candidates(std::size_t observation, std::vector<Candidate>& candidates) const = 0;
  /// The descriptor of a landmark; empty where nothing is known of it.
  virtual Descriptor descriptor(std::size_t /*landmark*/) const { return {}; }
  /// The covariance of the innovations of two pairings of different landmarks. Landmarks are
  /// independent given the pose, as a particle's are, unless the asker says otherwise.
  virtual Eigen::Matrix2d crossCovariance(const Pairing& /*first*/,
                                          const Pairing& /*second*/) const {
    return Eigen::Matrix2d::Zero();
  }
};

/// What becomes of an observation.
struct Decision {
  enum class Kind {
    kLandmark,   ///< it is of `landmark`
    kNew,        ///< it is of a landmark that is not in the map yet
    kUnknown,    ///< clutter: the policy cannot decide for a landmark
    kDuplicate,  ///< clutter: another one of the same array is of that landmark
    kNotInMap,   ///< clutter: it would be new, but the map is fixed
    kAmbiguous,  ///< clutter: by its place it may be of several landmarks, or of one nearby
    kOnTrial,    ///< it would be new, but has not been seen often enough yet
    kDistrusted  ///< clutter: its id does not name one place (DistrustedIds)
  };
  Kind kind = Kind::kUnknown;
  std::size_t landmark = 0;

  bool isClutter() const { return kind != Kind::kLandmark && kind != Kind::kNew; }
  /// What it comes to: a policy of another package may be wrong, but nothing is new in a fixed map,
  /// and only a landmark that the policy was offered can be updated.
  Kind checked(bool map_is_fixed, bool is_offered) const {
    if (kind == Kind::kNew && map_is_fixed) return Kind::kNotInMap;
    return kind == Kind::kLandmark && !is_offered ? Kind::kUnknown : kind;
  }
};

/// Decides of which landmark each observation is.
///
/// Who calls: a filter with one map, once a step for all observations of a stamp; one with
/// particles, for each of them with the particle's own source, from several threads, each with a
/// policy of its own. Where the policy does not usesPlaces(), its answer depends on ids only: it is
/// the same for all who have the same ids, and need be asked for once. A policy keeps nothing of
/// one call for the next but memory, so that the order of calls does not matter and no call
/// allocates once the buffers have grown.
///
/// The gate stays with the filter: an observation that is taken for a landmark and lies outside is
/// gated there.
///
/// A new policy derives from this and registers itself (contract/registry.hpp); the back-ends' key
/// `association` names it.
class AssociationPolicy {
 public:
  static constexpr const char* kRole = "association";

  virtual ~AssociationPolicy() = default;

  /// To be called first.
  virtual void configure(const PolicyConfig& /*config*/) {}
  /// Whether it asks for candidates by place. Then a filter brings the landmarks around the
  /// observations' places into its neighbourhood before it asks, else those with their ids.
  virtual bool usesPlaces() const = 0;
  /// @param map_is_fixed nothing is new
  /// @param decisions one for each observation, replaced
  virtual void decide(const LandmarkObservationArray& array, const CandidateSource& source,
                      bool map_is_fixed, std::vector<Decision>& decisions) = 0;
};

/// The names of all policies there are, this library's own included.
std::vector<std::string> policyNames();
/// @throw ConfigError for a name that is not known
std::unique_ptr<AssociationPolicy> makePolicy(const std::string& name,
                                              const PolicyConfig& config = {});

}  // namespace slam::association
