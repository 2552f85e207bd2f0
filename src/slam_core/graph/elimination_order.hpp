// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace slam::graph {

/// An order of elimination with little fill (CCOLAMD: Davis, Gilbert, Larimore, Ng 2004).
/// @param sets the variables that each factor joins, numbered from 0
/// @param groups of each variable: those of a smaller one come first. They are counted from 0, and
/// none of them is empty
/// @return the variables, first eliminated first
std::vector<int> eliminationOrder(int variables, const std::vector<std::vector<int>>& sets,
                                  const std::vector<int>& groups);

}  // namespace slam::graph
