// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace slam {

/// The candidate with the fewest single-letter edits from `name` (Levenshtein 1966), or an empty
/// string where none is near enough to be a typo.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or "" where nothing is near.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, const std::string& separator = ", ");

}  // namespace slam
