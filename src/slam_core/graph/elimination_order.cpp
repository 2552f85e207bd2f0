// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph/elimination_order.hpp"

#include <suitesparse/ccolamd.h>

#include <numeric>
#include <stdexcept>

namespace slam::graph {

std::vector<int> eliminationOrder(int variables, const std::vector<std::vector<int>>& sets,
                                  const std::vector<int>& groups) {
  std::vector<int> order(static_cast<std::size_t>(variables));
  std::iota(order.begin(), order.end(), 0);
  if (variables < 3) {
    if (variables == 2 && groups[0] > groups[1]) order = {1, 0};
    return order;
  }
  // columns of variables, in them the rows of the sets
  std::vector<int> starts(static_cast<std::size_t>(variables) + 1, 0);
  for (const auto& set : sets)
    for (const int variable : set) ++starts[static_cast<std::size_t>(variable) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  const int entries = starts.back(), rows = static_cast<int>(sets.size());
  const auto length = ccolamd_recommended(entries, rows, variables);
  std::vector<int> of_columns(length);
  auto next = starts;
  for (std::size_t row = 0; row < sets.size(); ++row)
    for (const int variable : sets[row])
      of_columns[static_cast<std::size_t>(next[static_cast<std::size_t>(variable)]++)] =
          static_cast<int>(row);
  auto members = groups;
  double knobs[CCOLAMD_KNOBS];
  int stats[CCOLAMD_STATS];
  ccolamd_set_defaults(knobs);
  knobs[CCOLAMD_DENSE_ROW] = -1.0;  // a large separator counts as well
  if (ccolamd(rows, variables, static_cast<int>(length), of_columns.data(), starts.data(), knobs,
              stats, members.data()) == 0)
    throw std::logic_error("the sets of variables are no matrix");
  starts.pop_back();
  return starts;
}

}  // namespace slam::graph
