// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/descriptor_map.hpp"

#include <algorithm>
#include <cmath>

namespace slam::association {
namespace {

/// The errors of a landmark's observations have this share of their variance in common, such as
/// that of its shape from one side: no mean has a smaller variance than this share.
constexpr float kAlikeShare = 0.1F;

/// The chi-square distribution's share beyond `squared`, by its recurrence from one and from two
/// degrees of freedom (Abramowitz, Stegun 1964, 26.4.4, 26.4.5, 26.4.8).
double descriptorShareBeyond(double squared, Eigen::Index degrees) {
  const double half = 0.5 * squared;
  double known = degrees % 2 == 0 ? 2.0 : 1.0;
  double share = degrees % 2 == 0 ? std::exp(-half) : std::erfc(std::sqrt(half));
  for (; known < static_cast<double>(degrees); known += 2.0)
    share += std::pow(half, 0.5 * known) * std::exp(-half) / std::tgamma(0.5 * known + 1.0);
  return share;
}

}  // namespace

DescriptorFit fitOf(const Descriptor& seen, const Descriptor& landmark, double probability) {
  if (seen.isEmpty() || seen.size() != landmark.size()) return {};
  DescriptorFit fit;
  for (Eigen::Index i = 0; i < seen.size(); ++i) {
    const double R = std::pow(seen.sigmas(i), 2), S = R + std::pow(landmark.sigmas(i), 2);
    fit.nis += std::pow(seen.values(i) - landmark.values(i), 2) / S;
    fit.cost += std::log(S / R);
  }
  fit.cost += fit.nis;
  fit.passes = descriptorShareBeyond(fit.nis, seen.size()) > 1.0 - probability;
  return fit;
}

void fuse(const Descriptor& seen, Descriptor& known) {
  const bool is_first = known.isEmpty();
  if (is_first) known = seen;
  if (is_first || known.size() != seen.size()) return;
  for (Eigen::Index i = 0; i < known.size(); ++i) {
    const float P = known.sigmas(i) * known.sigmas(i), R = seen.sigmas(i) * seen.sigmas(i);
    const float K = P / (P + R), alike = std::min(P, kAlikeShare * R);
    known.values(i) += K * (seen.values(i) - known.values(i));
    known.sigmas(i) = std::sqrt(std::max((1.0F - K) * P, alike));
  }
}

DescriptorMap::DescriptorMap(const LandmarkMap& map) {
  for (const auto& landmark : map) set(landmark.id, landmark.descriptor);
}

void DescriptorMap::set(LandmarkId id, const Descriptor& known) {
  if (!known.isEmpty()) known_[id] = known;
}

void DescriptorMap::see(LandmarkId id, const Descriptor& seen) {
  if (!seen.isEmpty()) fuse(seen, known_[id]);
}

Descriptor DescriptorMap::of(LandmarkId id) const {
  const auto known = known_.find(id);
  return known == known_.end() ? Descriptor() : known->second;
}

void DescriptorMap::describe(LandmarkMap& map) const {
  if (known_.empty()) return;
  for (auto& landmark : map) landmark.descriptor = of(landmark.id);
}

}  // namespace slam::association
