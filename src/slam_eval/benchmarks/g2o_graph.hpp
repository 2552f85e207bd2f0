// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "pose_graph.hpp"

namespace slam::eval {

/// Reads a graph of poses in the plane as g2o writes it (Kuemmerle, Grisetti, Strasdat, Konolige,
/// Burgard 2011): records `VERTEX_SE2 id x y theta` and `EDGE_SE2 a b x y theta`, behind it the
/// upper triangle of the information matrix by rows, in any order.
///
/// Ids are whole numbers. The robot is taken to have come to the poses in the order of their ids,
/// but to none before a pose that an edge joins it to. Only the first pose is taken from the file;
/// the edges say where the others are before anything is solved. Records of other types are
/// counted.
/// @throw ImportError where a line is wrong, or the vertices do not hang together
PoseGraph readG2o(const std::string& path);

}  // namespace slam::eval
