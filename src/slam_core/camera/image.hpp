// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "slam_core/camera/mat_archive.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// One raw image of a camera. Copies share the pixels; nobody writes to them.
struct Image {
  Stamp stamp;
  std::string frame;  ///< the camera's optical frame
  cv::Mat gray;       ///< 8 bit, one channel; empty where the pixels cannot be used
  std::string fault;  ///< why not: a sentence

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, frame, fault);
    persistMat(archive, gray);
  }
};

}  // namespace slam
