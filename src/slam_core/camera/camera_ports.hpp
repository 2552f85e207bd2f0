// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_core/contract/ports.hpp"

namespace slam {

/// The inputs of a component that looks through a camera: images, and what is latched of the
/// camera.
template <class Component>
void describeCamera(Ports& ports, const std::string& name, const std::string& sentence,
                    Component* component) {
  ports.takes<Image>(name, sentence, component);
  ports.takes<CameraCalibration>(name, "its calibration", component).latched();
  ports.takes<CameraMount>(name, "its mount", component).latched();
}

}  // namespace slam
