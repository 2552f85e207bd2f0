// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/view_gain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slam::active_path {
namespace {

constexpr double kMostCells = 5000.0;  // of a beam, so that memory is bounded

double binaryEntropy(double p) {
  if (p <= 0.0 || p >= 1.0) return 0.0;
  return -p * std::log2(p) - (1.0 - p) * std::log2(1.0 - p);
}

View wholeCircle(const std::vector<double>& gains) {
  const double step = 2.0 * M_PI / static_cast<double>(gains.size());
  View view;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t ray = 0; ray < gains.size(); ++ray) {
    const double angle = step * static_cast<double>(ray);
    view.gain += gains[ray];
    sum += gains[ray] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  view.heading = std::atan2(sum.y(), sum.x());
  return view;
}

/// Walks through all cells that a ray touches, side by side, so that it slips through no wall
/// (Amanatides, Woo 1987). Lengths in cells; starts in the middle of a cell.
class CellWalk {
 public:
  CellWalk(std::int64_t x, std::int64_t y, double angle)
      : x_(along(std::cos(angle), x)), y_(along(std::sin(angle), y)) {}

  /// To the next cell. @return how far from the start the ray enters it
  double advance() {
    auto& axis = x_.next <= y_.next ? x_ : y_;
    const double way = axis.next;
    axis.next += axis.pace;
    axis.cell += axis.step;
    return way;
  }
  std::int64_t x() const { return x_.cell; }
  std::int64_t y() const { return y_.cell; }

 private:
  struct Axis {
    std::int64_t cell, step;
    double pace, next;  ///< way between two borders, and from the start to the next one
  };

  static Axis along(double direction, std::int64_t cell) {
    constexpr double kLeast = 1e-12;
    if (std::abs(direction) < kLeast) {
      constexpr double kNever = std::numeric_limits<double>::infinity();
      return {cell, 0, kNever, kNever};
    }
    const double pace = 1.0 / std::abs(direction);
    return {cell, direction > 0.0 ? 1 : -1, pace, 0.5 * pace};
  }

  Axis x_, y_;
};

}  // namespace

ViewGain::ViewGain(const FreeSpace& space, const Sensor& sensor)
    : space_(space),
      sensor_(sensor),
      range_(std::min(sensor.range / space.grid().resolution, kMostCells)),
      reach_(static_cast<std::int64_t>(range_) + 1),
      seen_(static_cast<std::size_t>((2 * reach_ + 1) * (2 * reach_ + 1)), 0) {
  for (int percent = 0; percent <= 100; ++percent)
    entropy_.push_back(binaryEntropy(percent / 100.0));
}

View ViewGain::at(Cell viewpoint) {
  ++view_;
  std::vector<double> gains;
  for (int ray = 0; ray < sensor_.rays; ++ray)
    gains.push_back(cast(viewpoint, 2.0 * M_PI * ray / sensor_.rays));
  return bestOf(gains);
}

/// The gain of one beam [bit m^2].
double ViewGain::cast(Cell from, double angle) {
  const auto& grid = space_.grid();
  const std::int64_t left = from % grid.width - reach_, bottom = from / grid.width - reach_;
  CellWalk walk(left + reach_, bottom + reach_, angle);
  double gain = 0.0, in_unknown = 0.0;
  for (double way = walk.advance(); way < range_;) {
    const auto x = walk.x(), y = walk.y();
    const bool is_inside = x >= 0 && y >= 0 && x < grid.width && y < grid.height;
    const auto cell = is_inside ? static_cast<Cell>(y * grid.width + x) : Cell{0};
    if (is_inside && space_.isOccupied(cell)) break;
    const double next = walk.advance();
    if (!is_inside || !space_.isKnown(cell)) {
      const auto place = static_cast<std::size_t>((y - bottom) * (2 * reach_ + 1) + x - left);
      const bool is_first = std::exchange(seen_[place], view_) != view_;
      const double survival = std::exp(-in_unknown / sensor_.unknown_way);
      if (is_first)
        gain += entropyOf(is_inside ? grid.cells[cell] : OccupancyGrid::kUnknown) * survival;
      in_unknown += (next - way) * grid.resolution;
    }
    way = next;
  }
  return gain;
}

/// [bit m^2]
double ViewGain::entropyOf(std::int8_t percent) const {
  const double resolution = space_.grid().resolution;
  const double bits = percent < 0 ? 1.0 : entropy_[static_cast<std::size_t>(percent)];
  return bits * resolution * resolution;
}

/// The field of view that gains most; of a whole circle the direction in which most is gained.
View ViewGain::bestOf(const std::vector<double>& gains) const {
  const auto count = gains.size();
  const double step = 2.0 * M_PI / static_cast<double>(count);
  const auto window = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::lround(sensor_.field_of_view / step)), 1, count);
  if (window == count) return wholeCircle(gains);
  View best;
  for (std::size_t first = 0; first < count; ++first) {
    double gain = 0.0;
    for (std::size_t i = 0; i < window; ++i) gain += gains[(first + i) % count];
    const double middle =
        step * (static_cast<double>(first) + 0.5 * static_cast<double>(window - 1));
    if (gain > best.gain) best = {gain, std::remainder(middle, 2.0 * M_PI)};
  }
  return best;
}

}  // namespace slam::active_path
