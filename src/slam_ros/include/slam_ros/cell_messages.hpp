// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/PoseCellState.h>
#include <slam_msgs/ViewCell.h>

#include "slam_core/rat/cell_place.hpp"
#include "slam_core/rat/view_cell.hpp"

namespace slam_ros {

slam_msgs::ViewCell toMsg(const slam::rat::ViewCell& view);
slam::rat::ViewCell fromMsg(const slam_msgs::ViewCell& message);

slam_msgs::PoseCellState toMsg(const slam::rat::PoseCellState& state);
slam::rat::PoseCellState fromMsg(const slam_msgs::PoseCellState& message);

}  // namespace slam_ros
