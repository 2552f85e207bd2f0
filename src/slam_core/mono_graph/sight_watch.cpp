// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/sight_watch.hpp"

namespace slam::mono_graph {
namespace {

constexpr std::size_t kMuch = 100;      // features of an image that shows much
constexpr std::size_t kExpected = 40;   // points that say where the robot should be
constexpr double kNextToNothing = 0.1;  // of them
constexpr int kContradicting = 5;       // images in a row

}  // namespace

void SightWatch::add(Stamp stamp, std::size_t features, std::size_t expected, std::size_t matched) {
  const bool contradicts =
      features >= kMuch && expected >= kExpected &&
      static_cast<double>(matched) < kNextToNothing * static_cast<double>(expected);
  if (!contradicts) return clear();
  if (!since_) since_ = stamp;
  ++in_a_row_;
}

std::optional<Stamp> SightWatch::lostSince() const {
  return in_a_row_ >= kContradicting ? since_ : std::nullopt;
}

}  // namespace slam::mono_graph
