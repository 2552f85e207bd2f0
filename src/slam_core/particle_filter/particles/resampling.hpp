// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"

namespace slam::particle_filter {

/// Draws particles in proportion to their weights (Douc, Cappe, Moulines 2005). Each has count
/// times its weight as the expected number of its offspring.
class Resampling {
 public:
  virtual ~Resampling() = default;

  /// @param weights not negative, sum 1
  /// @return for each of `count` new particles the one it descends from, in ascending order
  virtual std::vector<std::uint32_t> draw(const std::vector<double>& weights, std::size_t count,
                                          RandomStream& random) const = 0;
};

/// One draw for all: a comb of `count` equidistant teeth.
class SystematicResampling final : public Resampling {
 public:
  std::vector<std::uint32_t> draw(const std::vector<double>& weights, std::size_t count,
                                  RandomStream& random) const override;
};

/// One draw within each of `count` equal intervals.
class StratifiedResampling final : public Resampling {
 public:
  std::vector<std::uint32_t> draw(const std::vector<double>& weights, std::size_t count,
                                  RandomStream& random) const override;
};

/// The whole part of count times the weight is certain, the rest is drawn (Liu, Chen 1998).
class ResidualResampling final : public Resampling {
 public:
  std::vector<std::uint32_t> draw(const std::vector<double>& weights, std::size_t count,
                                  RandomStream& random) const override;
};

/// Independent draws.
class MultinomialResampling final : public Resampling {
 public:
  std::vector<std::uint32_t> draw(const std::vector<double>& weights, std::size_t count,
                                  RandomStream& random) const override;
};

/// For each of the ascending positions in [0, 1) the particle whose share of the line it falls on.
std::vector<std::uint32_t> particlesAt(const std::vector<double>& positions,
                                       const std::vector<double>& weights);

/// The draw with the particles in another order; the ancestors come in that order.
std::vector<std::uint32_t> resampledAlong(const std::vector<std::uint32_t>& order,
                                          const Resampling& resampling,
                                          const std::vector<double>& weights, std::size_t count,
                                          RandomStream& random);

const std::vector<std::string>& resamplingNames();
/// `name` is one of resamplingNames().
std::unique_ptr<Resampling> makeResampling(const std::string& name);

}  // namespace slam::particle_filter
