// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/calibration_file.hpp"

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

/// What a camera sees is seen, or not; it is no number that is none.
void look(const CameraModel& camera) {
  for (const auto& point : {Eigen::Vector3d(0.1, -0.2, 1.0), Eigen::Vector3d(5.0, 3.0, 0.01)}) {
    const auto pixel = camera.project(point);
    test::requireThat(!pixel || pixel->allFinite(), "a pixel that is not finite");
  }
  for (const auto& pixel : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(319.5, 17.0)}) {
    const auto point = camera.unproject(pixel);
    test::requireThat(!point || point->allFinite(), "a ray that is not finite");
  }
}

}  // namespace
}  // namespace slam

/// A camera's calibration file: it is refused with a sentence, or its camera can be used.
SLAM_FUZZ_TARGET(calibration_file) {
  static const slam::test::TemporaryFolder kFolder;
  const auto path = kFolder.write("camera.yaml", slam::test::contentOf(bytes, size));
  try {
    slam::look(slam::CameraModel(slam::loadCalibrationFile(path)));
  } catch (const slam::ConfigError& refused) {
    slam::test::requireSentence(refused);
  }
}
