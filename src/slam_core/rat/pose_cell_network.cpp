// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/pose_cell_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slam::rat {
namespace {

constexpr double kReach = 3.0;  // of weights [standard deviations]
constexpr int kAround = 3;      // cells that count for the centre

int wrapped(int i, int n) { return ((i % n) + n) % n; }

/// @return the weights of a Gaussian, from its middle outwards; both sides and the middle sum to 1
std::vector<double> weightsOf(double sigma, int cells) {
  const int reach = std::min(static_cast<int>(std::ceil(kReach * sigma)), (cells - 1) / 2);
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i == 0 ? 1.0 : 2.0) * weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Convolves lines of n values, `step` apart, in place.
void convolveLine(double* first, std::size_t step, int n, const std::vector<double>& weights,
                  std::vector<double>& line) {
  for (int i = 0; i < n; ++i)
    line[static_cast<std::size_t>(i)] = first[step * static_cast<std::size_t>(i)];
  const int reach = static_cast<int>(weights.size()) - 1;
  for (int i = 0; i < n; ++i) {
    double sum = weights[0] * line[static_cast<std::size_t>(i)];
    for (int k = 1; k <= reach; ++k)
      sum += weights[static_cast<std::size_t>(k)] *
             (line[static_cast<std::size_t>(wrapped(i - k, n))] +
              line[static_cast<std::size_t>(wrapped(i + k, n))]);
    first[step * static_cast<std::size_t>(i)] = sum;
  }
}

/// The cell before a place, and how far beyond it the place is.
struct Between {
  int low;
  double part;

  explicit Between(double place)
      : low(static_cast<int>(std::floor(place))), part(place - std::floor(place)) {}
};

}  // namespace

PoseCellNetwork::PoseCellNetwork(const PoseCellConfig& config)
    : edge_(config.edge),
      headings_(config.headings),
      cell_size_(config.cell_size),
      global_inhibition_(config.global_inhibition),
      excitation_(weightsOf(config.excitation_sigma, std::min(edge_, headings_))),
      inhibition_(weightsOf(config.inhibition_sigma, std::min(edge_, headings_))),
      activity_(static_cast<std::size_t>(edge_ * edge_ * headings_), 0.0) {
  activity_[0] = 1.0;
}

void PoseCellNetwork::inject(const CellPlace& place, double activity) {
  const Between x(place.x), y(place.y), theta(place.theta);
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      for (const int k : {0, 1}) {
        const double share = (i == 0 ? 1.0 - x.part : x.part) * (j == 0 ? 1.0 - y.part : y.part) *
                             (k == 0 ? 1.0 - theta.part : theta.part);
        activity_[index(wrapped(x.low + i, edge_), wrapped(y.low + j, edge_),
                        wrapped(theta.low + k, headings_))] += share * activity;
      }
}

/// The activity, weighted in the three directions one after the other: a Gaussian is separable.
std::vector<double> PoseCellNetwork::spread(const std::vector<double>& weights) const {
  auto out = activity_;
  std::vector<double> line(static_cast<std::size_t>(std::max(edge_, headings_)));
  const auto edge = static_cast<std::size_t>(edge_);
  for (int a = 0; a < headings_; ++a)
    for (int b = 0; b < edge_; ++b) {
      convolveLine(&out[index(0, b, a)], 1, edge_, weights, line);
    }
  for (int a = 0; a < headings_; ++a)
    for (int b = 0; b < edge_; ++b) convolveLine(&out[index(b, 0, a)], edge, edge_, weights, line);
  for (int a = 0; a < edge_; ++a)
    for (int b = 0; b < edge_; ++b)
      convolveLine(&out[index(a, b, 0)], edge * edge, headings_, weights, line);
  return out;
}

/// After a long way without a view the activity has spread so far that inhibition would take all of
/// it: then it stays as it is excited, until a view makes a packet of it.
void PoseCellNetwork::settle() {
  activity_ = spread(excitation_);
  const auto excited = activity_, inhibited = spread(inhibition_);
  for (std::size_t i = 0; i < activity_.size(); ++i)
    activity_[i] = std::max(activity_[i] - inhibited[i] - global_inhibition_, 0.0);
  const auto isActive = [](double activity) { return activity > 0.0; };
  if (std::none_of(activity_.begin(), activity_.end(), isActive)) activity_ = excited;
  normalise();
}

void PoseCellNetwork::normalise() {
  const double sum = std::accumulate(activity_.begin(), activity_.end(), 0.0);
  if (sum > 0.0)
    for (double& activity : activity_) activity /= sum;
}

void PoseCellNetwork::move(const Pose2& increment) {
  const Eigen::Vector2d way = increment.position() / cell_size_;
  for (int theta = 0; theta < headings_; ++theta) {
    const double heading = 2.0 * M_PI * theta / headings_;
    const double c = std::cos(heading), s = std::sin(heading);
    moveLayer(theta, c * way.x() - s * way.y(), s * way.x() + c * way.y());
  }
  turn(increment.theta() * headings_ / (2.0 * M_PI));
}

void PoseCellNetwork::moveLayer(int theta, double dx, double dy) {
  const Between x(dx), y(dy);
  const auto first = activity_.begin() + static_cast<std::ptrdiff_t>(index(0, 0, theta));
  const std::vector<double> before(first, first + edge_ * edge_);
  const auto at = [&](int u, int v) {
    return before[static_cast<std::size_t>(wrapped(v, edge_) * edge_ + wrapped(u, edge_))];
  };
  for (int v = 0; v < edge_; ++v)
    for (int u = 0; u < edge_; ++u) {
      const int from_u = u - x.low, from_v = v - y.low;
      activity_[index(u, v, theta)] =
          (1.0 - y.part) * ((1.0 - x.part) * at(from_u, from_v) + x.part * at(from_u - 1, from_v)) +
          y.part * ((1.0 - x.part) * at(from_u, from_v - 1) + x.part * at(from_u - 1, from_v - 1));
    }
}

void PoseCellNetwork::turn(double cells) {
  const Between by(cells);
  const auto before = activity_;
  for (int theta = 0; theta < headings_; ++theta) {
    const int near = wrapped(theta - by.low, headings_),
              far = wrapped(theta - by.low - 1, headings_);
    for (int i = 0; i < edge_ * edge_; ++i) {
      const auto cell = static_cast<std::size_t>(i);
      activity_[index(0, 0, theta) + cell] = (1.0 - by.part) * before[index(0, 0, near) + cell] +
                                             by.part * before[index(0, 0, far) + cell];
    }
  }
}

CellPlace PoseCellNetwork::centre() const {
  const auto most = std::max_element(activity_.begin(), activity_.end()) - activity_.begin();
  const int x = static_cast<int>(most) % edge_, y = static_cast<int>(most) / edge_ % edge_,
            theta = static_cast<int>(most) / (edge_ * edge_);
  double sum = 0.0, sum_x = 0.0, sum_y = 0.0, sum_theta = 0.0;
  for (int k = -kAround; k <= kAround; ++k)
    for (int j = -kAround; j <= kAround; ++j)
      for (int i = -kAround; i <= kAround; ++i) {
        const double here = activity_[index(wrapped(x + i, edge_), wrapped(y + j, edge_),
                                            wrapped(theta + k, headings_))];
        sum += here;
        sum_x += here * i;
        sum_y += here * j;
        sum_theta += here * k;
      }
  const auto onTorus = [](double place, int cells) {
    return place - cells * std::floor(place / cells);
  };
  return {onTorus(x + sum_x / sum, edge_), onTorus(y + sum_y / sum, edge_),
          onTorus(theta + sum_theta / sum, headings_)};
}

}  // namespace slam::rat
