// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "slam_core/rat/local_view_config.hpp"

namespace slam::rat {

/// A view: the grays of a reduced image, row by row, of mean 0 and standard deviation 1, so that it
/// does not depend on how bright the light is.
using View = std::vector<float>;

/// @param gray 8 bit, one channel, not empty
/// @return the view that an image shows; nothing where it has no contrast
std::optional<View> viewOf(const cv::Mat& gray, const LocalViewConfig& config);

/// The views that were seen, and which of them looks most like another one.
class ViewMemory {
 public:
  ViewMemory() = default;
  explicit ViewMemory(const LocalViewConfig& config)
      : columns_(config.columns), rows_(config.rows), largest_shift_(config.largest_shift) {}

  struct Match {
    std::int64_t view;
    double difference;  ///< mean absolute difference at the best shift
  };
  /// The first of those that look most alike; nothing where none is known.
  std::optional<Match> nearest(const View& view) const;
  /// @return its number
  std::int64_t add(View view);

  std::int64_t size() const { return static_cast<std::int64_t>(views_.size()); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(views_);
  }

 private:
  double differenceOf(const View& a, const View& b, double abandon_above) const;
  double differenceAt(const View& a, const View& b, int shift) const;

  int columns_ = 1, rows_ = 1, largest_shift_ = 0;
  std::vector<View> views_;
};

}  // namespace slam::rat
