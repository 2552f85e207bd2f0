// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <string>

#include "slam_core/common/status.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// A warning where a source's triggers have waited for motion for more than three seconds.
/// @param collator a slam::Collator that holds them
/// @param what the triggers are, in the plural
template <class Collator>
Status starvation(const Collator& collator, std::size_t source, const std::string& what) {
  const auto since = collator.starvedSince(source, std::chrono::seconds(3));
  if (!since) return Status::ok();
  return Status::warning(
      fmt::format("no update: {} since {:.1f} wait for motion", what, seconds(*since - Stamp())));
}

}  // namespace slam
