// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <string>

#include "slam_core/common/time.hpp"

namespace slam {

/// A stamp as the files of a run have it: seconds with nine decimals, without a rounding error.
inline std::string stampText(Stamp stamp) {
  return fmt::format("{}.{:09d}", nanoseconds(stamp) / 1000000000, nanoseconds(stamp) % 1000000000);
}

}  // namespace slam
