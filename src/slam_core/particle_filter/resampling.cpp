// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/resampling.hpp"

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

const std::vector<std::string>& resamplingNames() {
  static const std::vector<std::string> kNames = {"systematic", "stratified", "residual",
                                                  "multinomial"};
  return kNames;
}

std::unique_ptr<Resampling> makeResampling(const std::string& name) {
  if (name == "multinomial") return std::make_unique<MultinomialResampling>();
  if (name == "residual") return std::make_unique<ResidualResampling>();
  if (name == "stratified") return std::make_unique<StratifiedResampling>();
  return std::make_unique<SystematicResampling>();
}

}  // namespace slam::particle_filter
