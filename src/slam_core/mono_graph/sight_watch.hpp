// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

#include "slam_core/common/time.hpp"

namespace slam::mono_graph {

/// Whether what is seen contradicts the map: images that show much, but next to nothing of what the
/// map has there. One may be blurred or hidden; several in a row say that the robot is elsewhere,
/// as one that was carried away.
class SightWatch {
 public:
  /// @param features of the image @param expected points that were to be seen @param matched of
  /// them, those that were
  void add(Stamp stamp, std::size_t features, std::size_t expected, std::size_t matched);
  /// Whether the last image contradicts the map.
  bool isContradicted() const { return since_.has_value(); }
  /// Since when; nothing while there are too few such images.
  std::optional<Stamp> lostSince() const;
  void clear() { *this = SightWatch(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(since_, in_a_row_);
  }

 private:
  std::optional<Stamp> since_;
  int in_a_row_ = 0;
};

}  // namespace slam::mono_graph
