// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

#include "slam_core/common/random.hpp"

namespace slam::particle_filter {

/// The random streams of the filter, each named by seed, step, purpose and particle.
class RandomStreams {
 public:
  enum class Purpose : std::uint32_t { kPropose, kDraw, kResample, kResize, kPlace };

  void seed(std::uint64_t seed) { seed_ = seed; }
  void restart() { step_ = 0; }
  void nextStep() { ++step_; }

  RandomStream of(Purpose purpose, std::size_t particle = 0) const {
    constexpr unsigned kBitsOfParticle = 28;
    return RandomStream(seed_, step_,
                        static_cast<std::uint32_t>(purpose) << kBitsOfParticle |
                            static_cast<std::uint32_t>(particle));
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(step_);
  }

 private:
  std::uint64_t seed_ = 1, step_ = 0;
};

}  // namespace slam::particle_filter
