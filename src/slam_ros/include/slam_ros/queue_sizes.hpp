// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

namespace slam_ros {

constexpr std::uint32_t kQueue = 1000;
/// Images are large: a full queue is tens of megabytes already.
constexpr std::uint32_t kImageQueue = 50;

/// How many messages of an input the bag source sends before the back-end must acknowledge; every
/// queue after it must hold as many.
constexpr std::size_t kInFlight = 100;
/// The same for images. Each takes long to process, and a thread of a nodelet manager processes all
/// messages in one nodelet's queue before other nodelets have their turn, among them the back-end
/// and those that wait for its answer.
constexpr std::size_t kImagesInFlight = 8;
/// The same for scans. They are few for the same reason, and so that little else passes meanwhile.
constexpr std::size_t kScansInFlight = 20;
/// More than a component holds while it waits for calibration and mount.
constexpr std::size_t kImagesHeld = 40;

}  // namespace slam_ros
