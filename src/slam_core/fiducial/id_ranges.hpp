// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace slam::fiducial {

/// A family of markers in use: its ids are 0 .. count - 1, in the product offset .. offset + count
/// - 1.
struct IdRange {
  std::string family;
  std::int64_t offset = 0;
  std::int64_t count = 0;
};

/// Ids are unique in a product: each family has its range of them.
/// @throw ConfigError of the section for families listed twice, offsets of families that are not
/// listed, and ranges that overlap
void requireUniqueIds(const std::string& section, const std::vector<IdRange>& ranges,
                      const std::map<std::string, std::int64_t>& offsets);

}  // namespace slam::fiducial
