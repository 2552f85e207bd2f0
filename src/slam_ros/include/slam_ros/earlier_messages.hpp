// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slam_ros {

/// Bags that hold messages of slam_msgs as they were before a landmark could be a line, or before
/// it could have a descriptor, are read as those of today: all their landmarks are points, or have
/// no descriptor.

/// @return the md5sum that a type has today, if `md5sum` is that of its earlier definition; else
///   `md5sum`
std::string md5sumOfToday(const std::string& type, const std::string& md5sum);

/// The bytes of a message in the layout of today. Bytes that do not fit the earlier definition stay
/// as they are.
/// @param md5sum of the definition that the message was written with
void bringUpToDate(const std::string& md5sum, std::vector<std::uint8_t>& bytes);

}  // namespace slam_ros
