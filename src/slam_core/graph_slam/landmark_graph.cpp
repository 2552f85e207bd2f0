// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/landmark_graph.hpp"

#include <Eigen/Cholesky>
#include <memory>
#include <utility>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/sighting_fusion.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::graph_slam {
namespace {

/// A joint covariance of more landmarks would make a clique of all of them.
constexpr std::size_t kLargestJoint = 100;

/// The joint covariance of a saved map with the pose as a twist.
Eigen::MatrixXd withTwist(const MapState& map) {
  Eigen::MatrixXd P = map.joint_covariance;
  const Eigen::Matrix3d J_inverse = map.robot.pose.twistJacobian().transpose();
  P.topRows<3>() = J_inverse * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * J_inverse.transpose();
  return P;
}

}  // namespace

void LandmarkGraph::load(const MapState& map, double inflation) {
  auto& graph = path_.graph();
  std::vector<Eigen::Vector2d> points;
  for (const auto& landmark : map.landmarks) {
    addLandmark(landmark.id, landmark.position);
    points.push_back(landmark.position);
  }
  if (map.joint_covariance.size() > 0 && points.size() <= kLargestJoint) {
    const auto pose = graph.add(map.robot.pose);
    std::vector<graph::Key> keys = {pose};
    keys.insert(keys.end(), keys_.begin(), keys_.end());
    graph.add(std::make_unique<graph::JointPrior>(keys, map.robot.pose, points,
                                                  graph::weightOfCovariance(withTwist(map))));
    path_.relocate(pose);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto W = graph::weightOfCovariance(inflation * inflation * map.landmarks[i].covariance);
      index_.addPrior(i, graph.add(std::make_unique<graph::PointPrior>(keys_[i], points[i], W)));
    }
  }
  path_.optimize(1);
}

void LandmarkGraph::addLandmark(LandmarkId id, const Eigen::Vector2d& place) {
  ids_.add(id);
  keys_.push_back(path_.graph().add(place));
  index_.addLandmark();
}

Eigen::MatrixXd LandmarkGraph::covariance(const std::vector<std::size_t>& landmarks) const {
  std::vector<graph::Key> keys;
  for (const auto landmark : landmarks) keys.push_back(keys_[landmark]);
  return path_.covariance(keys);
}

/// The observation as if made from the last node: with the noise of the motion since then.
LandmarkObservation LandmarkGraph::carriedBack(const LandmarkObservation& z,
                                               const Pose2& sensor) const {
  const auto& motion = path_.tail().motion;
  if (!motion) return z;
  const RangeBearingModel model;
  ObservationModel::Jacobian23 J;
  const auto place = model.invert(motion->increment, sensor, z.vector());
  model.predict(motion->increment, sensor, place, &J);
  LandmarkObservation carried = z;
  carried.covariance += J * motion->covariance * J.transpose();
  return carried;
}

/// In some direction of range and bearing the motion since the last node adds more than the noise
/// of the observation.
bool LandmarkGraph::isBlurred(const LandmarkObservation& z, const Pose2& sensor) const {
  if (!path_.tail().node) return false;
  const Eigen::Matrix2d added = carriedBack(z, sensor).covariance - z.covariance;
  return Eigen::LLT<Eigen::Matrix2d>(z.covariance - added).info() != Eigen::Success;
}

void LandmarkGraph::see(std::size_t landmark, const LandmarkObservation& z, const Pose2& sensor) {
  const auto node = isBlurred(z, sensor) ? path_.addNode() : path_.nodeNearby();
  if (std::exchange(sightings_node_, node) != node) sightings_.clear();
  const auto& motion = path_.tail().motion;
  Sighting sighting{carriedBack(z, sensor), motion ? motion->increment * sensor : sensor};
  auto& graph = path_.graph();
  const auto known = sightings_.find(landmark);
  if (known != sightings_.end()) {
    const auto both = fused(known->second.z, known->second.sensor, sighting.z, sighting.sensor);
    if (!both) return;
    sighting.z = *both;
    graph.remove(index_.remove(landmark, node));
  }
  const auto factor = graph.add(std::make_unique<graph::RangeBearing>(
      node, keys_[landmark], sighting.sensor, sighting.z.vector(),
      graph::weightOfCovariance(sighting.z.covariance)));
  index_.add(landmark, node, factor);
  sightings_[landmark] = sighting;
}

void LandmarkGraph::observe(const std::vector<Match>& matches, const Pose2& sensor) {
  for (const auto& match : matches) see(match.landmark, match.z, sensor);
}

void LandmarkGraph::append(LandmarkId id, const Eigen::Vector2d& place,
                           const LandmarkObservation& z, const Pose2& sensor) {
  addLandmark(id, place);
  see(ids_.size() - 1, z, sensor);
}

void LandmarkGraph::reinitialize(std::size_t landmark, const Eigen::Vector2d& place,
                                 const LandmarkObservation& z, const Pose2& sensor) {
  for (const auto factor : index_.removeLandmark(landmark)) path_.graph().remove(factor);
  sightings_.erase(landmark);
  path_.graph().set(keys_[landmark], place);
  see(landmark, z, sensor);
}

LandmarkMap LandmarkGraph::map() const {
  LandmarkMap map;
  for (const auto i : ids_.order()) map.push_back({ids_[i], point(i), covariance(i)});
  return map;
}

MapState LandmarkGraph::state() const {
  MapState state{path_.robot(), {}, {}};
  const auto order = ids_.order();
  auto& P = state.joint_covariance;
  P = covariance(order);
  const Eigen::Matrix3d J = state.robot.pose.twistJacobian();
  P.topRows<3>() = J * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * J.transpose();
  P = 0.5 * (P + P.transpose()).eval();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto row = 3 + 2 * static_cast<Eigen::Index>(i);
    state.landmarks.push_back({ids_[order[i]], point(order[i]), P.block<2, 2>(row, row)});
  }
  return state;
}

}  // namespace slam::graph_slam
