// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "slam_core/common/time.hpp"

namespace slam::rat {

/// No view cell: the image shows nothing that could be told from something else.
constexpr std::int64_t kNoView = -1;

/// Which local view cell is active: what the camera sees, as one of the views that it has seen.
struct ViewCell {
  Stamp stamp;
  std::uint64_t sequence = 0;
  std::int64_t cell = kNoView;  ///< number of the view, from 0 in the order of their first sight
  bool is_new = false;          ///< it is seen for the first time
  double difference = 0.0;      ///< from the view that looks most alike [standard deviations]

  template <class Archive>
  void persist(Archive& archive) {
    archive(stamp, sequence, cell, is_new, difference);
  }
};

inline std::string faultOf(const ViewCell& view) {
  return view.cell >= kNoView && std::isfinite(view.difference)
             ? ""
             : "a local view cell has a number that none can have, or a difference that is no "
               "number";
}

}  // namespace slam::rat
