// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/graph_slam/session.hpp"

// The fields of each record in the order of the file. An archive is what writes or reads them: it
// takes any number of fields, and calls fields() for those that are records.

namespace slam::graph_slam {

template <class Archive>
void fields(Archive& in, Session::Kind& it) {
  in(it.has_grid, it.resolution, it.has_own_ids);
}
template <class Archive>
void fields(Archive& in, Descriptor& it) {
  in(it.values, it.sigmas);
}
template <class Archive>
void fields(Archive& in, Session::Landmark& it) {
  in(it.id, it.position, it.fits, it.misses, it.is_retired, it.descriptor);
}
template <class Archive>
void fields(Archive& in, Session::PosePrior& it) {
  in(it.node, it.pose, it.weight);
}
template <class Archive>
void fields(Archive& in, Session::PointPrior& it) {
  in(it.landmark, it.point, it.weight);
}
template <class Archive>
void fields(Archive& in, Session::JointPrior& it) {
  in(it.node, it.landmarks, it.pose, it.points, it.weight);
}
template <class Archive>
void fields(Archive& in, Session::Between& it) {
  in(it.from, it.to, it.motion, it.weight);
}
template <class Archive>
void fields(Archive& in, Session::RangeBearing& it) {
  in(it.node, it.landmark, it.sensor, it.z, it.weight);
}
template <class Archive>
void fields(Archive& in, Session::Loop& it) {
  in(it.between, it.is_believed, it.share, it.is_alone);
}
template <class Archive>
void fields(Archive& in, LandmarkObservation& it) {
  in(it.id, it.range, it.bearing, it.covariance);
}
template <class Archive>
void fields(Archive& in, Session::Sighting& it) {
  in(it.factor, it.z, it.sensor);
}
template <class Archive>
void fields(Archive& in, Session::Mark& it) {
  in(it.stamp, it.node, it.pose);
}
template <class Archive>
void fields(Archive& in, Motion& it) {
  in(it.sequence, it.start, it.end, it.increment, it.covariance, it.odometry_start, it.odometry_end,
     it.odometry_frame, it.base_frame);
}
template <class Archive>
void fields(Archive& in, PoseEstimate& it) {
  in(it.pose, it.covariance);
}
template <class Archive>
void fields(Archive& in, Session::Robot& it) {
  in(it.node, it.motion, it.start, it.nodes);
}
template <class Archive>
void fields(Archive& in, LaserBeam& it) {
  in(it.bearing, it.range, it.hit);
}
template <class Archive>
void fields(Archive& in, LaserFan& it) {
  in(it.sensor_pose, it.relative_sigma, it.beams);
}
template <class Archive>
void fields(Archive& in, LaserScan& it) {
  in(it.sequence, it.stamp, it.sensor_frame, it.sensor_pose, it.relative_sigma, it.beams);
}
template <class Archive>
void fields(Archive& in, Session::Scan& it) {
  in(it.node, it.drawn, it.scan);
}
template <class Archive>
void fields(Archive& in, Session::PlacedScan& it) {
  in(it.scan, it.pose);
}
template <class Archive>
void fields(Archive& in, Session::Submap& it) {
  in(it.origin, it.odom_origin, it.is_base, it.scans, it.ended);
}
template <class Archive>
void fields(Archive& in, Session::Place& it) {
  in(it.node, it.in_odom, it.told);
}
template <class Archive>
void fields(Archive& in, Session::Submaps& it) {
  in(it.finished, it.older, it.younger, it.gone, it.renewed, it.drawn, it.robot, it.carried,
     it.last, it.reference);
}
template <class Archive>
void fields(Archive& in, OccupancyGrid& it) {
  in(it.resolution, it.origin, it.width, it.height, it.cells);
}
template <class Archive>
void fields(Archive& in, Session& it) {
  in(it.kind, it.stamp, it.nodes, it.landmarks, it.factors, it.chords, it.loops, it.sightings_node,
     it.sightings, it.path, it.robot, it.last_motion, it.scans, it.submaps, it.base);
}

}  // namespace slam::graph_slam
