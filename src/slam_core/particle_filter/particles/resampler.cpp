// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/resampler.hpp"

#include "slam_core/particle_filter/particles/hilbert_order.hpp"

namespace slam::particle_filter {

Resampler::Resampler(const Config& config)
    : threshold_(config.threshold), resampling_(makeResampling(config.method)) {
  if (config.sizes) size_.emplace(*config.sizes);
}

bool Resampler::isDue(const Weights& weights) const {
  return weights.effectiveSize() < threshold_ * static_cast<double>(weights.size());
}

std::vector<std::uint32_t> Resampler::draw(const std::vector<PoseGaussian>& proposals,
                                           const Weights& weights, const PoseEstimate& moments,
                                           const RandomStreams& streams) const {
  std::vector<Pose2> poses;
  poses.reserve(proposals.size());
  for (const auto& proposal : proposals) poses.push_back(proposal.mean);
  auto count = weights.size();
  if (size_) {
    auto stream = streams.of(RandomStreams::Purpose::kResize);
    count = size_->drawnFrom(poses, weights.all(), stream);
  }
  auto stream = streams.of(RandomStreams::Purpose::kResample);
  return resampledAlong(hilbertOrder(poses, moments), *resampling_, weights.all(), count, stream);
}

}  // namespace slam::particle_filter
