// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/view_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace slam::rat {

std::optional<View> viewOf(const cv::Mat& gray, const LocalViewConfig& config) {
  const int top = static_cast<int>(config.crop_top * gray.rows);
  const int bottom = gray.rows - static_cast<int>(config.crop_bottom * gray.rows);
  cv::Mat exact, reduced;
  gray.rowRange(top, std::max(bottom, top + 1)).convertTo(exact, CV_32F);
  cv::resize(exact, reduced, {config.columns, config.rows}, 0.0, 0.0, cv::INTER_AREA);
  cv::Scalar mean, deviation;
  cv::meanStdDev(reduced, mean, deviation);
  if (!(deviation[0] >= config.least_contrast)) return std::nullopt;
  reduced = (reduced - mean[0]) / deviation[0];
  return View(reduced.begin<float>(), reduced.end<float>());
}

std::optional<ViewMemory::Match> ViewMemory::nearest(const View& view) const {
  std::optional<Match> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const double difference = differenceOf(views_[i], view, least);
    if (difference >= least) continue;
    least = difference;
    best = Match{static_cast<std::int64_t>(i), difference};
  }
  return best;
}

double ViewMemory::differenceOf(const View& a, const View& b, double abandon_above) const {
  double least = std::min(differenceAt(a, b, 0), std::numeric_limits<double>::max());
  // A view that differs by three times as much is not met by a small shift.
  if (least > 3.0 * abandon_above) return least;
  for (int shift = 1; shift <= largest_shift_; ++shift)
    least = std::min({least, differenceAt(a, b, shift), differenceAt(a, b, -shift)});
  return least;
}

double ViewMemory::differenceAt(const View& a, const View& b, int shift) const {
  const int width = columns_ - std::abs(shift);
  const int from_a = std::max(shift, 0), from_b = std::max(-shift, 0);
  double sum = 0.0;
  for (int row = 0; row < rows_; ++row) {
    const float* left = &a[static_cast<std::size_t>(row * columns_ + from_a)];
    const float* right = &b[static_cast<std::size_t>(row * columns_ + from_b)];
    float row_sum = 0.0F;
    for (int i = 0; i < width; ++i) row_sum += std::abs(left[i] - right[i]);
    sum += static_cast<double>(row_sum);
  }
  return sum / (width * rows_);
}

std::int64_t ViewMemory::add(View view) {
  views_.push_back(std::move(view));
  return size() - 1;
}

}  // namespace slam::rat
