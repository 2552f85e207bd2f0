// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/particles/resampling.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/common/policy_table.hpp"

namespace slam::particle_filter {

std::vector<std::uint32_t> particlesAt(const std::vector<double>& positions,
                                       const std::vector<double>& weights) {
  std::vector<std::uint32_t> drawn;
  drawn.reserve(positions.size());
  std::size_t last_with_weight = weights.size();  // rounding may leave the sum below a position
  while (last_with_weight > 1 && weights[last_with_weight - 1] == 0.0) --last_with_weight;
  std::size_t i = 0;
  double sum = weights[0];
  for (const double position : positions) {
    while (sum <= position && i + 1 < last_with_weight) sum += weights[++i];
    drawn.push_back(static_cast<std::uint32_t>(i));
  }
  return drawn;
}

std::vector<std::uint32_t> resampledAlong(const std::vector<std::uint32_t>& order,
                                          const Resampling& resampling,
                                          const std::vector<double>& weights, std::size_t count,
                                          RandomStream& random) {
  std::vector<double> ordered;
  ordered.reserve(order.size());
  for (const auto i : order) ordered.push_back(weights[i]);
  auto ancestors = resampling.draw(ordered, count, random);
  for (auto& ancestor : ancestors) ancestor = order[ancestor];
  return ancestors;
}

std::vector<std::uint32_t> SystematicResampling::draw(const std::vector<double>& weights,
                                                      std::size_t count,
                                                      RandomStream& random) const {
  const double offset = random.uniform(), n = static_cast<double>(count);
  std::vector<double> positions(count);
  for (std::size_t k = 0; k < count; ++k) positions[k] = (static_cast<double>(k) + offset) / n;
  return particlesAt(positions, weights);
}

std::vector<std::uint32_t> StratifiedResampling::draw(const std::vector<double>& weights,
                                                      std::size_t count,
                                                      RandomStream& random) const {
  const double n = static_cast<double>(count);
  std::vector<double> positions(count);
  for (std::size_t k = 0; k < count; ++k)
    positions[k] = (static_cast<double>(k) + random.uniform()) / n;
  return particlesAt(positions, weights);
}

std::vector<std::uint32_t> ResidualResampling::draw(const std::vector<double>& weights,
                                                    std::size_t count, RandomStream& random) const {
  std::vector<std::uint32_t> drawn;
  drawn.reserve(count);
  std::vector<double> rest(weights.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double expected = static_cast<double>(count) * weights[i];
    const double certain = std::floor(expected);
    drawn.insert(drawn.end(), static_cast<std::size_t>(certain), static_cast<std::uint32_t>(i));
    sum += rest[i] = expected - certain;
  }
  if (drawn.size() >= count) {  // rounding may make one too many of whole parts
    drawn.resize(count);
    return drawn;
  }
  for (auto& weight : rest) weight /= sum;
  const auto others = MultinomialResampling().draw(rest, count - drawn.size(), random);
  drawn.insert(drawn.end(), others.begin(), others.end());
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

std::vector<std::uint32_t> MultinomialResampling::draw(const std::vector<double>& weights,
                                                       std::size_t count,
                                                       RandomStream& random) const {
  std::vector<double> positions(count);
  for (auto& position : positions) position = random.uniform();
  std::sort(positions.begin(), positions.end());
  return particlesAt(positions, weights);
}

namespace {

const PolicyTable<Resampling>& resamplingTable() {
  static const PolicyTable<Resampling> kTable(
      {{"systematic", makePolicyOf<Resampling, SystematicResampling>},
       {"stratified", makePolicyOf<Resampling, StratifiedResampling>},
       {"residual", makePolicyOf<Resampling, ResidualResampling>},
       {"multinomial", makePolicyOf<Resampling, MultinomialResampling>}});
  return kTable;
}

}  // namespace

const std::vector<std::string>& resamplingNames() { return resamplingTable().names(); }

std::unique_ptr<Resampling> makeResampling(const std::string& name) {
  return resamplingTable().make(name);
}

}  // namespace slam::particle_filter
