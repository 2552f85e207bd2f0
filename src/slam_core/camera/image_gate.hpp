// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <string>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/camera/camera_model.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"

namespace slam {

/// The entrance of a component that looks through a camera: lets images out in the order of stamps,
/// once calibration and mount are known. Until then it holds them; when it holds too many, the
/// oldest comes out as unusable. Neither an ideal lens nor an identity mount is ever assumed.
///
/// Call order: configure(), set(...) of what has come, next() until image() is empty.
/// Counted: "late" (dropped), and of images that came out as unusable "unreadable", "image_size",
/// "bad_calibration", "bad_mount", "no_calibration", "no_mount".
class ImageGate {
 public:
  static constexpr std::size_t kCapacity = 30;

  /// A fresh start, without calibration; the mount is the configured one or none.
  /// @param section that the configuration was read from @throw ConfigError
  void configure(const CameraConfig& config, const std::string& section = CameraConfig::kSection);

  /// In force for all images that have not come out.
  void set(const CameraCalibration& calibration);
  /// For images of its frame. Where the configuration gives the mount only the frame's name counts.
  void set(const CameraMount& mount);
  /// Dropped when its stamp is not after the last one's; 5 s before it and more is a new beginning.
  void set(const Image& image, Counters& counters);

  /// Lets the next image out that is due. Says what is wrong with it, or with the input since the
  /// last call, or what the images wait for.
  Status next(Counters& counters);

  const std::optional<Image>& image() const { return image_; }
  /// Whether image() can be used, with camera() and mount().
  bool isUsable() const { return usable_; }
  const CameraModel& camera() const { return camera_; }
  const CameraMount& mount() const { return *mount_; }

  /// As after configure(), calibration and mount kept.
  void reset();

 private:
  struct Fault {
    std::string reason, sentence;
  };

  std::optional<Fault> missing(const Image& image) const;
  std::optional<Fault> faultOfImage() const;

  std::string section_ = CameraConfig::kSection;
  std::optional<Eigen::Isometry3d> configured_mount_;
  std::optional<CameraMount> mount_;
  std::optional<CameraCalibration> calibration_;
  std::string calibration_fault_, mount_fault_;
  CameraModel camera_;
  std::deque<Image> held_;
  std::optional<Stamp> last_;
  std::optional<Image> image_;
  bool usable_ = false;
  Status input_status_;  ///< of the images since the last next()
};

}  // namespace slam
