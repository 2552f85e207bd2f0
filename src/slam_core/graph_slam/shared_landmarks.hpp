// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/graph_slam/landmark_meeting.hpp"
#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

// The landmarks that two sessions have, with their marginal covariances. Retired ones are left out.

/// Those of the same id.
std::vector<SharedLandmark> sharedById(const Session& first, const Session& second);

/// Those that lie at one place, each the nearest one of the other.
/// @param first_second T_first_second, of the map frames
std::vector<SharedLandmark> sharedByPlace(const Session& first, const Session& second,
                                          const Pose2& first_second);

/// How the maps lie, by a constellation of landmarks of one that is found in the other: five of
/// them at least, a million times as likely as if they had nothing in common, and as any other
/// place.
/// @return T_first_second, of the map frames; nothing where there is no such place
std::optional<Pose2> constellationMeeting(const Session& first, const Session& second);

}  // namespace slam::graph_slam
