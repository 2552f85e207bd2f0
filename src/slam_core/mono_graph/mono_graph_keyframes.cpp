// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <utility>

#include "slam_core/mono_graph/mono_graph.hpp"
#include "slam_core/mono_graph/pose_chain.hpp"

namespace slam::mono_graph {

/// Keyframes that a keyframe is joined with already: what they show is no news.
std::set<int> MonoGraph::knownAround(int keyframe) const {
  constexpr int kRecent = 10;
  std::set<int> known;
  for (const auto& [other, shared] : sharedPoints(map_, keyframe)) {
    const auto around = keyframesAround(map_, other);
    known.insert(around.begin(), around.end());
  }
  const int last = static_cast<int>(map_.keyframes().size()) - 1;
  for (int i = std::max(0, keyframe - kRecent); i <= last; ++i) known.insert(i);
  return known;
}

/// The work on a keyframe goes on with the two images after it, so that no image takes the time of
/// all. The robot moves with the keyframe that it is tracked by.
void MonoGraph::finishKeyframe() {
  if (!unadjusted_ && !unrecognised_) return;
  const Pose2 before = reference_ ? map_.keyframe(*reference_).pose : Pose2();
  if (const auto keyframe = std::exchange(unrecognised_, std::nullopt)) recognise(*keyframe);
  unrecognised_ = std::exchange(unadjusted_, std::nullopt);
  if (unrecognised_) adjust(*unrecognised_);
  if (!reference_) return;
  anchor_.moveWith(before, map_.keyframe(*reference_).pose);
  predict();
}

void MonoGraph::adjust(int keyframe) {
  adjustAround(map_, keyframe, config_.window);
  auto& adjusted = map_.keyframe(keyframe);
  adjusted.covariance = chainedCovariance(map_, keyframe).value_or(adjusted.covariance);
}

void MonoGraph::recognise(int keyframe) {
  const auto place =
      recogniser_.find(map_, map_.keyframe(keyframe).features, recogniser_.index()[keyframe],
                       knownAround(keyframe), config_.least_similarity);
  if (!place) return;
  const Pose2 before = map_.keyframe(keyframe).pose;
  const auto closed = closer_.close(map_, *place, keyframe);
  if (!closed.is_newest) counters_.add("loops_rejected");
  if (closed.loops == 0) return;
  counters_.add("loops", static_cast<std::uint64_t>(closed.loops));
  if (closed.is_newest) joinPlaces(map_, *place, keyframe);
  adjust(keyframe);
  if (closed.is_newest) noteLoop(*place, before, map_.keyframe(keyframe).pose);
}

}  // namespace slam::mono_graph
