// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/common/test/fuzz/field_change.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/product/test/drive_invariants.hpp"
#include "slam_core/product/test/product_drives.hpp"

namespace slam::test {
namespace {

/// A product, and the port of the camera that it looks through.
struct LookingProduct {
  std::vector<std::string> settings;
  std::string camera;
};

/// A drive under a ceiling of which bytes say what the camera gives: images of any size and with
/// any pixels, dark, twice, late or none; calibrations and mounts any field of which has any value.
class ImageDrive {
 public:
  ImageDrive(const LookingProduct& product, FuzzBytes bytes)
      : camera_(product.camera), bytes_(bytes) {
    Settings settings({}, {}, product.settings);
    product_.configure(settings);
    product_.put(camera_, calibration_);
    product_.put(camera_, mount_);
  }

  /// Ends the program where an invariant is broken.
  void run() {
    for (int steps = 0; steps < kSteps && !bytes_.isEmpty(); ++steps) {
      happen();
      requireThat(invariants_.hold(), invariants_.broken());
    }
    invariants_.checkEnd(product_);
    requireThat(invariants_.hold(), invariants_.broken());
  }

 private:
  static constexpr int kSteps = 15;

  void happen() {
    drive();
    switch (bytes_.below(8)) {
      case 0: {
        auto calibration = calibration_;
        FieldChange::in(calibration, bytes_);
        return give(calibration);
      }
      case 1: {
        auto mount = mount_;
        FieldChange::in(mount, bytes_);
        return give(mount);
      }
      case 2:
        give(calibration_);
        return give(mount_);
      case 3: {
        auto image = seen();
        image.stamp += 10 * std::chrono::milliseconds(bytes_.bits<std::int16_t>());
        return give(image);
      }
      case 4:
        give(seen());
        [[fallthrough]];
      default:
        give(seen());
    }
  }

  void drive() {
    now_ += std::chrono::milliseconds(100);
    pose_ = pose_ * Pose2(0.04, 0.0, 0.02);
    product_.set(odometryAt(now_, pose_));
  }

  /// Returns what the camera sees, or what bytes make of it.
  Image seen() {
    Image image{now_, mount_.camera_frame, {}, ""};
    const auto number = static_cast<std::uint64_t>(now_.time_since_epoch().count());
    switch (bytes_.below(5)) {
      case 0:
        image.gray = cv::Mat(size(), size(), CV_8UC1, cv::Scalar(bytes_.bits<std::uint8_t>()));
        break;
      case 1:
        image.gray = cv::Mat(size(), size(), CV_8UC3, cv::Scalar::all(0));
        break;
      default:
        image.gray = ceilings::exposed(ceiling_.seenBy(mount_, pose_), {}, number);
        for (auto left = bytes_.below(6); left > 0; --left) paint(image.gray);
    }
    return image;
  }
  int size() { return static_cast<int>(bytes_.below(200)); }

  /// A block of the image gets any value.
  void paint(cv::Mat& gray) {
    const auto within = [this](int end) {
      const int a = static_cast<int>(bytes_.below(static_cast<std::uint64_t>(end))),
                b = static_cast<int>(bytes_.below(static_cast<std::uint64_t>(end)));
      return cv::Range(std::min(a, b), std::max(a, b) + 1);
    };
    gray(within(gray.rows), within(gray.cols)).setTo(bytes_.bits<std::uint8_t>());
  }

  template <class T>
  void give(const T& value) {
    product_.put(camera_, value);
    do {
      invariants_.check(product_.execute());
      if (const auto& report = product_.estimator().report()) invariants_.check(*report, {});
    } while (product_.estimator().report());
  }

  const std::string camera_;
  FuzzBytes bytes_;
  const CameraCalibration calibration_ = ceilings::smallCamera();
  const CameraMount mount_ = ceilings::mountUp();
  const ceilings::Ceiling ceiling_;
  MetaCoordinator product_;
  DriveInvariants invariants_;
  Stamp now_ = Stamp(std::chrono::seconds(100));
  Pose2 pose_;
};

}  // namespace
}  // namespace slam::test

/// A camera's images, its calibration and its mount, in products that look through one.
SLAM_FUZZ_TARGET(image_drive) {
  static const std::string kHeight = "ceiling_camera.ceiling_height=1.7";
  static const std::vector<slam::test::LookingProduct> kProducts = {
      {{"backend=ekf", "detector=ceiling_features", "association=descriptor", kHeight},
       "ceiling_camera"},
      {{"backend=pf", "odometry=visual", kHeight}, "ceiling_camera"},
      {{"backend=ekf", "odometry=visual_wheel", kHeight}, "ceiling_camera"},
      {{"backend=ekf", "detector=apriltag"}, "camera"},
      {{"backend=graph", "detector=aruco"}, "camera"}};
  slam::test::FuzzBytes input(bytes, size);
  const auto& product = kProducts[input.below(kProducts.size())];
  slam::test::ImageDrive(product, input).run();
}
