// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

namespace slam {

/// A family of markers in use. Its own ids are 0 .. count - 1; in the product they become offset ..
/// offset + count - 1.
struct IdRange {
  std::string family;
  std::int64_t offset = 0;
  std::int64_t count = 0;

  std::int64_t last() const { return offset + count - 1; }
  bool overlaps(const IdRange& other) const {
    return offset <= other.last() && other.offset <= last();
  }
  /// "36h11 (0 .. 586)", for messages
  std::string text() const {
    return family + " (" + std::to_string(offset) + " .. " + std::to_string(last()) + ")";
  }
};

}  // namespace slam
