// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/active_path/free_space.hpp"

#include <cmath>
#include <limits>

namespace slam::active_path {
namespace {

constexpr float kFar = 1e12F;  // [cells^2], farther than any cell of a grid

/// The squared distance transform along one line in place, by the lower envelope of parabolas
/// (Felzenszwalb, Huttenlocher 2012, algorithm 1).
class LineTransform {
 public:
  explicit LineTransform(std::size_t length)
      : values_(length), vertices_(length), bounds_(length + 1) {}

  void apply(float* line, std::size_t length, std::size_t stride) {
    for (std::size_t i = 0; i < length; ++i) values_[i] = line[i * stride];
    buildEnvelope(length);
    std::size_t k = 0;
    for (std::size_t i = 0; i < length; ++i) {
      while (bounds_[k + 1] < static_cast<double>(i)) ++k;
      const double offset = static_cast<double>(i) - static_cast<double>(vertices_[k]);
      line[i * stride] = static_cast<float>(offset * offset + values_[vertices_[k]]);
    }
  }

 private:
  void buildEnvelope(std::size_t length) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    vertices_[0] = 0;
    bounds_[0] = -kInfinity;
    bounds_[1] = kInfinity;
    for (std::size_t i = 1; i < length; ++i) {
      double meeting = meetingOf(i, vertices_[k]);
      while (meeting <= bounds_[k]) meeting = meetingOf(i, vertices_[--k]);
      vertices_[++k] = i;
      bounds_[k] = meeting;
      bounds_[k + 1] = kInfinity;
    }
  }

  /// Returns where the parabolas of two cells meet.
  double meetingOf(std::size_t right, std::size_t left) const {
    const auto r = static_cast<double>(right), l = static_cast<double>(left);
    return (values_[right] + r * r - values_[left] - l * l) / (2.0 * (r - l));
  }

  std::vector<double> values_;
  std::vector<std::size_t> vertices_;
  std::vector<double> bounds_;
};

}  // namespace

std::string faultOf(const OccupancyGrid& grid) {
  constexpr std::size_t kMostCells = 100'000'000;
  if (grid.width == 0 || grid.height == 0) return "it has no cells";
  if (!(grid.resolution > 0.0) || !std::isfinite(grid.resolution))
    return "its resolution is not a positive number";
  if (!grid.origin.allFinite()) return "its origin is not a number";
  const std::size_t count = std::size_t{grid.width} * grid.height;
  if (count > kMostCells) return "it has more than 100 million cells";
  if (grid.cells.size() != count) return "its data do not fill its width and height";
  return "";
}

FreeSpace::FreeSpace(const OccupancyGrid& grid, double robot_radius)
    : grid_(grid), radius_(robot_radius - 1e-6), clearance_(grid.cells.size(), kFar) {
  for (Cell cell = 0; cell < grid.cells.size(); ++cell)
    if (isOccupied(cell)) clearance_[cell] = 0.0F;
  LineTransform transform(std::max(grid.width, grid.height));
  for (std::size_t x = 0; x < grid.width; ++x)
    transform.apply(&clearance_[x], grid.height, grid.width);
  for (std::size_t y = 0; y < grid.height; ++y)
    transform.apply(&clearance_[y * grid.width], grid.width, 1);
  for (auto& squared : clearance_)
    squared = static_cast<float>((std::sqrt(squared) - 0.5) * grid.resolution);
}

bool FreeSpace::contains(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d place = (p_map - grid_.origin) / grid_.resolution;
  return place.x() >= 0.0 && place.x() < grid_.width && place.y() >= 0.0 &&
         place.y() < grid_.height;
}

Cell FreeSpace::cellAt(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d place = (p_map - grid_.origin) / grid_.resolution;
  return static_cast<Cell>(place.y()) * grid_.width + static_cast<Cell>(place.x());
}

Eigen::Vector2d FreeSpace::centre(Cell cell) const {
  const Eigen::Vector2d place(cell % grid_.width + 0.5, cell / grid_.width + 0.5);
  return grid_.origin + grid_.resolution * place;
}

}  // namespace slam::active_path
