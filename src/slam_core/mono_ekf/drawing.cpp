// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/drawing.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "slam_core/camera/drawn_point.hpp"
#include "slam_core/geometry/principal_axes.hpp"

namespace slam::mono_ekf {
namespace {

const cv::Scalar kMatched(0, 200, 0), kWithoutDepth(0, 220, 220), kRejected(60, 60, 255),
    kNotFound(150, 150, 150), kAdded(255, 120, 0);

cv::Scalar colourOf(const Search& search, bool has_depth) {
  if (search.outcome == Search::Outcome::kNotFound) return kNotFound;
  if (search.outcome == Search::Outcome::kRejected) return kRejected;
  return has_depth ? kMatched : kWithoutDepth;
}

void drawEllipse(const Search& search, const cv::Scalar& colour, cv::Mat& picture) {
  constexpr double kSigmas = 3.03;  // 99 % lie within
  const auto [variances, directions] = principalAxes(search.S);
  const Eigen::Vector2d axes = kSigmas * variances.cwiseMax(0.0).cwiseSqrt();
  const Eigen::Vector2d direction = directions.col(1);
  const double angle = std::atan2(direction.y(), direction.x()) * 180.0 / M_PI;
  const cv::Point size = drawnAt({axes(1), axes(0)});
  cv::ellipse(picture, drawnAt(search.predicted), cv::Size(size), angle, 0.0, 360.0, colour, 1,
              cv::LINE_AA, kFractionBits);
}

void drawPoint(const Eigen::Vector2d& pixel, const cv::Scalar& colour, cv::Mat& picture) {
  cv::circle(picture, drawnAt(pixel), 2 << kFractionBits, colour, cv::FILLED, cv::LINE_AA,
             kFractionBits);
}

}  // namespace

cv::Mat draw(const cv::Mat& gray, const std::vector<Search>& searches,
             const std::vector<bool>& have_depth, const std::vector<Eigen::Vector2d>& added) {
  cv::Mat picture;
  if (gray.empty() || gray.type() != CV_8UC1) return picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const auto colour = colourOf(searches[i], have_depth[i]);
    drawEllipse(searches[i], colour, picture);
    if (searches[i].outcome != Search::Outcome::kNotFound)
      drawPoint(searches[i].found, colour, picture);
  }
  for (const auto& pixel : added) drawPoint(pixel, kAdded, picture);
  return picture;
}

}  // namespace slam::mono_ekf
