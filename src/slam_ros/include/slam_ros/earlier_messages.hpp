// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slam_ros {

/// Converts messages of slam_msgs in bags from before landmarks could be lines, or from before they
/// could have descriptors: all their landmarks become points, or have no descriptor.

/// @return the current md5sum of a type, if `md5sum` is that of its earlier definition; otherwise
/// `md5sum`
std::string md5sumOfToday(const std::string& type, const std::string& md5sum);

/// The bytes of a message in the current layout. Bytes that do not fit the earlier definition are
/// not changed.
/// @param md5sum of the definition with which the message was written
void bringUpToDate(const std::string& md5sum, std::vector<std::uint8_t>& bytes);

}  // namespace slam_ros
