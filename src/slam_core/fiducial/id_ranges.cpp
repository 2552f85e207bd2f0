// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/id_ranges.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"

namespace slam::fiducial {
void requireUniqueIds(const std::string& section, const std::vector<IdRange>& ranges,
                      const std::map<std::string, std::int64_t>& offsets) {
  FaultCollector faults;
  std::vector<std::string> families;
  for (const auto& range : ranges) families.push_back(range.family);
  for (const auto& [family, offset] : offsets)
    if (std::count(families.begin(), families.end(), family) == 0)
      faults.add(section + ".id_offsets: " + family + " is not in use" +
                 didYouMean(family, families) + "; in use: " + join(families));
  for (auto a = ranges.begin(); a != ranges.end(); ++a) {
    for (auto b = a + 1; b != ranges.end(); ++b) {
      if (a->family == b->family)
        faults.add(section + ": " + a->family + " is listed twice");
      else if (a->overlaps(*b))
        faults.add(section + ".id_offsets: the ids of " + a->text() + " and " + b->text() +
                   " overlap; give " + b->family + " an offset of " +
                   std::to_string(a->last() + 1) + " or more");
    }
  }
  faults.raise();
}

}  // namespace slam::fiducial
