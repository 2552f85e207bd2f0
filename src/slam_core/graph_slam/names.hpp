// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/landmark_graph/associator.hpp"
#include "slam_core/landmark_graph/candidates.hpp"
#include "slam_core/landmark_graph/landmark_graph.hpp"
#include "slam_core/landmark_graph/sighting_fusion.hpp"

namespace slam::graph_slam {

// The graph of path and landmarks, which this component extends by scans, loops and sessions.
using landmark_graph::Association;
using landmark_graph::Associator;
using landmark_graph::coordinateCovariance;
using landmark_graph::fused;
using landmark_graph::LandmarkGraph;
using landmark_graph::LandmarkIds;
using landmark_graph::Match;
using landmark_graph::NodeChain;
using landmark_graph::NodeLimits;
using landmark_graph::NodeObservations;
using landmark_graph::ParameterVariables;
using landmark_graph::PathGraph;
using landmark_graph::PlaceCandidates;
using landmark_graph::Prediction;
using landmark_graph::SightingIndex;
using landmark_graph::Tail;
using landmark_graph::twistCovariance;
using landmark_graph::Viewpoint;

}  // namespace slam::graph_slam
