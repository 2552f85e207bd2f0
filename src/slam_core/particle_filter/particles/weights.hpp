// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

namespace slam::particle_filter {

/// The weights of the particles, as logarithms and, in step with them, normalised to a sum of one.
class Weights {
 public:
  explicit Weights(std::size_t count = 0) { reset(count); }

  /// `count` equal ones.
  void reset(std::size_t count);

  std::size_t size() const { return normalized_.size(); }
  double operator[](std::size_t i) const { return normalized_[i]; }
  const std::vector<double>& all() const { return normalized_; }

  /// Multiplies each weight with its factor, whose logarithm is given; one that is no number counts
  /// as zero. Where nothing is left of any weight they are all made equal.
  /// @return whether something was left
  bool multiply(const std::vector<double>& log_factors);

  /// 1 / sum of squares (Kong, Liu, Wong 1994): between 1 and size().
  double effectiveSize() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(logs_, normalized_);
  }

 private:
  std::vector<double> logs_, normalized_;
};

}  // namespace slam::particle_filter
