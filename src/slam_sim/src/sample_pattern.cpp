// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sample_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "slam_core/common/random.hpp"

namespace slam::sim {
namespace {

using Order = std::vector<int>;

Order shuffled(int n, RandomStream& random) {
  Order order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  }
  return order;
}

int around(int difference, int n) {
  const int distance = std::abs(difference);
  return std::min(distance, n - distance);
}

/// The smallest distance of two samples, each pair of dimensions counting by itself.
int nearness(const Order& x, const Order& y) {
  const int n = static_cast<int>(x.size());
  int nearest = std::numeric_limits<int>::max();
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const int dx = around(x[a] - x[b], n), dy = around(y[a] - y[b], n), dt = around(i - j, n);
      nearest = std::min({nearest, dx * dx + dy * dy, dx * dx + dt * dt, dy * dy + dt * dt});
    }
  }
  return nearest;
}

}  // namespace

std::vector<Eigen::Vector2d> samplePattern(int samples) {
  constexpr int kTrials = 2000;
  RandomStream random(static_cast<std::uint64_t>(samples), 0);
  std::pair<Order, Order> best;
  int best_nearness = -1;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::pair<Order, Order> order{shuffled(samples, random), shuffled(samples, random)};
    const int value = nearness(order.first, order.second);
    if (value > best_nearness) {
      best = std::move(order);
      best_nearness = value;
    }
  }
  std::vector<Eigen::Vector2d> pattern;
  for (std::size_t i = 0; i < best.first.size(); ++i) {
    pattern.emplace_back(Eigen::Vector2d(best.first[i] + 0.5, best.second[i] + 0.5) / samples);
  }
  return pattern;
}

}  // namespace slam::sim
