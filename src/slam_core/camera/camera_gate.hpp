// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/camera/camera_view.hpp"
#include "slam_core/contract/gate.hpp"

namespace slam {

/// The entrance of whoever looks through a camera: lets images out in the order of stamps, once
/// calibration and mount are known. Until then it holds them; when it holds too many, the oldest
/// comes out as unusable. Neither an ideal lens nor an identity mount is ever assumed.
///
/// A camera whose driver hangs sends the same image with new stamps. Its noise makes each true
/// image another one, so an image that is the one before it, to the bit, comes out as repeated,
/// unless it is of a single gray, as behind a lens cap.
///
/// Call order: configure(), set(...) of what has come, execute() until view() is empty.
/// Counted: "late" (dropped), and of images that came out as unusable "unreadable", "image_size",
/// "bad_calibration", "bad_mount", "no_calibration", "no_mount", "repeated", and
/// "calibration_changed": the focal length differs by 2 % from that of the first image, at the same
/// size of the image, so that nothing of the map fits.
class CameraGate : public Gate {
 public:
  static constexpr std::size_t kCapacity = 30;

  /// @param section of its configuration, which is the name of its input as well
  explicit CameraGate(std::string section = CameraConfig::kSection, std::string sentence = "images")
      : section_(std::move(section)), sentence_(std::move(sentence)) {}

  std::string name() const override { return section_; }
  void describe(Ports& ports) override;
  /// A fresh start, without calibration; the mount is the configured one or none.
  /// @throw ConfigError
  void configure(const CameraConfig& config);
  void configure(Settings& settings) override { configure(settings.read<CameraConfig>()); }

  /// The calibration is in force for all images that have not come out.
  void set(const CameraCalibration& calibration);
  /// The mount counts for images of its frame. Where the configuration gives it, only the frame's
  /// name counts.
  void set(const CameraMount& mount);
  /// Dropped when its stamp is not after the last one's; 5 s before it and more is a new beginning.
  void set(const Image& image);

  /// Lets the next image out that is due. Says what is wrong with it, or with the input since the
  /// last call, or what the images wait for.
  Status execute() override;
  bool isBusy() const override { return view_.has_value(); }

  const std::optional<CameraView>& view() const { return view_; }
  Counters counters() const override { return counters_; }
  Counters held() const override;
  std::uint64_t dropped() const override { return counters_["late"]; }

  /// The gate is as after configure(), but keeps calibration and mount.
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(mount_, calibration_, first_, calibration_fault_, mount_fault_, camera_, held_, last_,
            input_status_, repeats_, counters_);
    persistMat(archive, last_gray_);
  }

 private:
  struct Fault {
    std::string reason, sentence;
  };

  std::optional<Fault> missing(const Image& image) const;
  std::optional<Fault> faultOf(const Image& image) const;
  Status letOut(Image image);

  std::string section_, sentence_;
  std::optional<Eigen::Isometry3d> configured_mount_;
  std::optional<CameraMount> mount_;
  std::optional<CameraCalibration> calibration_;
  std::optional<CameraCalibration> first_;  ///< that of the first usable image
  std::string calibration_fault_, mount_fault_;
  std::shared_ptr<const CameraModel> camera_;
  std::deque<Image> held_;
  std::optional<Stamp> last_;
  cv::Mat last_gray_;  ///< of the usable image that came out last
  int repeats_ = 0;    ///< images in a row that repeat it
  std::optional<CameraView> view_;
  Status input_status_;  ///< of the images since the last execute()
  Counters counters_;
};

/// The gate of the second camera.
class RearCameraGate final : public CameraGate {
 public:
  RearCameraGate() : CameraGate(RearCameraConfig::kSection, "images of the rear camera") {}

  using CameraGate::configure;
  void configure(Settings& settings) override { configure(settings.read<RearCameraConfig>()); }
};

/// The gate of the camera that looks at the ceiling.
class CeilingCameraGate final : public CameraGate {
 public:
  CeilingCameraGate() : CameraGate(CeilingCameraConfig::kSection, "images of the ceiling") {}

  using CameraGate::configure;
  void configure(Settings& settings) override { configure(settings.read<CeilingCameraConfig>()); }
};

}  // namespace slam
