// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slam::eval {

/// Rows stay in file order where their stamps are equal. @return rows that came too late
template <class Row>
std::size_t sortByStamp(std::vector<Row>& rows) {
  std::size_t late = 0;
  std::int64_t newest = 0;
  for (const Row& row : rows) {
    if (row.stamp < newest) ++late;
    newest = std::max(newest, row.stamp);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.stamp < b.stamp; });
  return late;
}

}  // namespace slam::eval
