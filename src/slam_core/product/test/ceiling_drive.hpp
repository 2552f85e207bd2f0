// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slam_core/camera/image.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/product/test/product_drives.hpp"

namespace slam::test {

/// A drive under a ceiling that a camera sees, 1.7 m above it; on some metres it is dark. Landmarks
/// are seen, too.
inline std::vector<ProductInput> ceilingInputs(std::uint64_t seed) {
  constexpr int kSteps = 40;
  LateWheels drive(seed);
  SimulatedWorld world(seed);
  const ceilings::Ceiling ceiling;
  const auto mount = ceilings::mountUp();
  drive.give("ceiling_camera", ceilings::smallCamera());
  for (int i = 0; i < kSteps; ++i) {
    const auto step = world.next();
    if (i == 3) drive.give("ceiling_camera", mount);
    const bool is_dark = i >= 20 && i < 24;
    const auto light = ceiling.seenBy(mount, step.truth);
    const auto gray =
        ceilings::exposed(light, {is_dark ? 0.02 : 1.0, 0.0, 2.0}, static_cast<std::uint64_t>(i));
    drive.give("ceiling_camera", Image{step.motion.end, mount.camera_frame, gray, ""});
    drive.add(step.motion, "observations", step.observations);
  }
  return drive.take();
}

}  // namespace slam::test
