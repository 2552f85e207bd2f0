// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

namespace slam_ros {

constexpr std::uint32_t kQueue = 1000;
/// Images are large: what waits here is tens of megabytes already.
constexpr std::uint32_t kImageQueue = 50;

/// What the bag source sends before the back-end must acknowledge, per input; every queue behind
/// must hold as many.
constexpr std::size_t kInFlight = 100;
/// The queue of images. Each takes long, and a nodelet manager's thread works off all that one
/// nodelet was sent before the others have their turn, the back-end and who waits for its answer
/// among them.
constexpr std::size_t kImagesInFlight = 8;
/// The queue of scans is short for the same reason, and so that little of the rest goes by
/// meanwhile.
constexpr std::size_t kScansInFlight = 20;
/// More than a component holds while it waits for calibration and mount.
constexpr std::size_t kImagesHeld = 40;

}  // namespace slam_ros
