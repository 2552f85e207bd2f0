// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "slam_core/contract/id_range.hpp"

namespace slam::fiducial {

/// Ids are unique in a product: each family has its range of them.
/// @throw ConfigError of the section for families listed twice, offsets of families that are not
/// listed, and ranges that overlap
void requireUniqueIds(const std::string& section, const std::vector<IdRange>& ranges,
                      const std::map<std::string, std::int64_t>& offsets);

}  // namespace slam::fiducial
