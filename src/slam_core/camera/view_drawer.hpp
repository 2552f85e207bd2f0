// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>

namespace slam {

/// What a component that looks through a camera offers to those who want to see what it saw.
class ViewDrawer {
 public:
  virtual ~ViewDrawer() = default;
  /// The last image in colour (CV_8UC3) with what was found and what was rejected drawn into it,
  /// made when it is asked for; empty where there is nothing to show.
  virtual cv::Mat drawing() const = 0;
};

}  // namespace slam
