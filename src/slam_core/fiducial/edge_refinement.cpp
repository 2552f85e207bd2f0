// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/edge_refinement.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "slam_core/fiducial/small_markers.hpp"

namespace slam::fiducial {
namespace {

using Eigen::Vector2d;
using Line = Eigen::Hyperplane<double, 2>;

// [px]
constexpr double kReach = 1.5;  ///< of edges that are about known
constexpr double kLongestReach = 4.0;
constexpr double kBase = 1.0;
constexpr double kFinest = 0.5;

/// The gray level between pixels; nothing outside the image.
std::optional<double> grayAt(const cv::Mat& gray, const Vector2d& place) {
  const double left = std::floor(place.x()), top = std::floor(place.y());
  if (!(left >= 0 && top >= 0 && left < gray.cols - 1 && top < gray.rows - 1)) return std::nullopt;
  const int u = static_cast<int>(left), v = static_cast<int>(top);
  const double a = place.x() - left, b = place.y() - top;
  const auto* row = gray.ptr<std::uint8_t>(v) + u;
  const auto* next = gray.ptr<std::uint8_t>(v + 1) + u;
  return (1 - b) * ((1 - a) * row[0] + a * row[1]) + b * ((1 - a) * next[0] + a * next[1]);
}

/// How an edge is looked for across it [px].
struct Window {
  double reach;  ///< to either side
  double base;   ///< to either side of a place, for its slope
};

/// About an edge known within `reach`.
Window wide(double reach) { return {reach, kBase}; }

/// About an edge that is about known. A slope taken over more than a third of the cells beside it
/// mixes in what lies beyond them, and a small marker would look larger than it is.
Window narrow(double cell) {
  return {std::clamp(cell, kFinest, kReach), std::clamp(cell / 3.0, kFinest, kBase)};
}

/// Where on the way through `place` along `towards_black` it gets darker: the mean of the way,
/// weighed by the square of the slope.
std::optional<Vector2d> descent(const cv::Mat& gray, const Vector2d& place,
                                const Vector2d& towards_black, const Window& window) {
  constexpr double kStep = 0.25;  // [px]
  const int steps = static_cast<int>(window.reach / kStep);
  double weights = 0.0, sum = 0.0;
  for (int i = -steps; i <= steps; ++i) {
    const double way = kStep * i;
    const auto before = grayAt(gray, place + (way - window.base) * towards_black);
    const auto after = grayAt(gray, place + (way + window.base) * towards_black);
    if (!before || !after) return std::nullopt;
    const double slope = std::max(0.0, *before - *after);
    weights += slope * slope;
    sum += slope * slope * way;
  }
  if (!(weights > 0.0)) return std::nullopt;
  return place + sum / weights * towards_black;
}

/// The line through the edge from a to b, where black is on the right of the way; nothing where it
/// is not found.
std::optional<Line> lineOfEdge(const cv::Mat& gray, const Vector2d& a, const Vector2d& b,
                               const Window& window) {
  const Vector2d along = b - a;
  const double length = along.norm();
  const Vector2d towards_black = Vector2d(-along.y(), along.x()) / length;
  const int samples = std::max(8, static_cast<int>(length));
  int found = 0;
  Vector2d sum = Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (int i = 1; i <= samples; ++i) {  // the corners themselves are round
    const auto place = descent(gray, a + along * i / (samples + 1.0), towards_black, window);
    if (!place) continue;
    ++found;
    sum += *place;
    squares += *place * place->transpose();
  }
  if (2 * found < samples) return std::nullopt;
  const Vector2d mean = sum / found;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread;
  spread.computeDirect(squares / found - mean * mean.transpose());
  return Line(spread.eigenvectors().col(0), mean);
}

/// The corners between the edges that are found about the lines from corner to corner; nothing
/// where one is not.
std::optional<Corners> cornersBetweenEdges(const cv::Mat& gray, const Corners& corners,
                                           const Window& window, Contrast contrast) {
  std::array<std::optional<Line>, 4> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % 4];
    edges[i] = contrast == Contrast::kBlackOnWhite ? lineOfEdge(gray, a, b, window)
                                                   : lineOfEdge(gray, b, a, window);
    if (!edges[i]) return std::nullopt;
  }
  Corners crossings;
  for (std::size_t i = 0; i < 4; ++i) crossings[i] = edges[i]->intersection(*edges[(i + 3) % 4]);
  return crossings;
}

}  // namespace

void refineByEdges(const cv::Mat& gray, Corners& corners, double max_move, Contrast contrast) {
  const double side = meanSide(corners);
  // the border of a marker is a sixth to a ninth of it wide: not into the code
  const double first_reach = std::clamp(std::min(max_move, side / 9.0), kReach, kLongestReach);
  auto refined = cornersBetweenEdges(gray, corners, wide(first_reach), contrast);
  if (refined) refined = cornersBetweenEdges(gray, *refined, narrow(side / kCells), contrast);
  if (!refined) return;
  for (std::size_t i = 0; i < 4; ++i)
    if (!(((*refined)[i] - corners[i]).norm() <= max_move)) return;
  corners = *refined;
}

}  // namespace slam::fiducial
