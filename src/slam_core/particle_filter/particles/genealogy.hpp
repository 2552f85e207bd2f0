// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace slam::particle_filter {

/// How much of what the particles once disagreed on they have forgotten: the share of the pairs of
/// particles that have come to descend from the same one since (the coalescent of Kingman 1982).
class Genealogy {
 public:
  /// A time since which nothing has been remembered.
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  /// The particles have come to weigh as much as `effective` of their `count` do; what weighs
  /// nothing is as good as forgotten.
  void weigh(double effective, std::size_t count);
  /// Particle i was replaced by a copy of particle ancestors[i].
  void resample(const std::vector<std::uint32_t>& ancestors);

  /// The time by resamplings: minus the logarithm of the share of pairs that have no common
  /// ancestor yet.
  double now() const { return coalesced_; }
  /// The share of the pairs of particles.
  double forgottenSince(double time) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(alive_, coalesced_);
  }

 private:
  double alive_ = 1.0;  ///< share of the pairs of particles, by weight
  double coalesced_ = 0.0;
};

}  // namespace slam::particle_filter
