// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/models/landmark_observation.hpp"

namespace slam {

/// The role of an allothetic source that looks through a camera: raw images in, landmark
/// observations out (thesis 3.4.1, 5.2).
///
/// Who calls: the detector's nodelet or the MetaCoordinator, from one thread: set(...) of what has
/// come, then execute() until observations() is empty. Images wait, bounded, until calibration and
/// mount are known; every image that is not late yields one array, an empty one where nothing is
/// seen or the image cannot be used. Counted: "late" and the reasons of rejections.
class LandmarkDetector {
 public:
  static constexpr const char* kRole = "detector";

  virtual ~LandmarkDetector() = default;

  /// A fresh start, without calibration and mount. @throw ConfigError listing all faults of its
  /// sections
  virtual void configure(Settings& settings) = 0;

  /// In force for all images that have not been processed.
  virtual void set(const CameraCalibration& calibration) = 0;
  virtual void set(const CameraMount& mount) = 0;
  virtual void set(const Image& image) = 0;

  /// Processes the next image that is due.
  virtual Status execute() = 0;

  /// Of the last execute(); nothing when no image was due.
  virtual const std::optional<LandmarkObservationArray>& observations() const = 0;
  /// The last image in colour (CV_8UC3) with what was found and what was rejected drawn into it;
  /// made when it is asked for.
  virtual cv::Mat drawing() const = 0;
  virtual const Counters& counters() const = 0;

  /// As after configure(), calibration and mount kept.
  virtual void reset() = 0;
};

}  // namespace slam
