// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/landmark_graph.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <utility>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/principal_axes.hpp"
#include "slam_core/graph/factors.hpp"
#include "slam_core/landmark_graph/sighting_fusion.hpp"
#include "slam_core/models/observation_model.hpp"

namespace slam::landmark_graph {
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

/// Whether a factor of the graph contradicts the other ones. Its residual has the covariance
/// I - J P J^T, since the estimate has been drawn towards what it says.
/// @param gate largest squared residual, by that covariance
bool isContradicting(const graph::Optimizer& graph, const graph::Factor& factor, double gate) {
  constexpr double kLeastShare = 0.1;  // of I that counts: what nothing else holds tells nothing
  if (graph.chi2(factor) <= kLeastShare * gate) return false;
  const auto innovation = graph.innovation({&factor});
  const auto size = innovation.S.rows();
  const Eigen::MatrixXd S = 2.0 * Eigen::MatrixXd::Identity(size, size) - innovation.S;
  const auto axes = principalAxes(S);
  const Eigen::ArrayXd along = axes.directions.transpose() * innovation.r;
  return (along.square() / axes.values.array().max(kLeastShare)).sum() > gate;
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

Eigen::MatrixXd LandmarkGraph::covariance(const std::vector<std::size_t>& landmarks,
                                          const Viewpoint& from) const {
  std::vector<graph::Key> keys;
  for (const auto landmark : landmarks) keys.push_back(keys_[landmark]);
  return path_.covariance(keys, from);
}

Eigen::MatrixXd covarianceFrom(const LandmarkGraph& graph, const Pose2& sensor,
                               const std::vector<std::size_t>& landmarks, const Viewpoint& from) {
  const auto& parameters = *parametersOf(graph.path_);
  auto keys = parameters.keys();
  for (const auto landmark : landmarks) keys.push_back(graph.keys_[landmark]);
  const Eigen::MatrixXd P = graph.path_.covariance(keys, from);
  const auto size = 2 * static_cast<Eigen::Index>(landmarks.size());
  const auto column = [&](CalibrationParameter row) { return 3 + parameters.row(row); };
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(3 + size, P.cols());
  T.topLeftCorner<3, 3>() = sensor.inverse().adjoint();
  T.block<2, 1>(0, column(kSensorX)) = sensor.rotation().transpose().col(0);
  T.block<2, 1>(0, column(kSensorY)) = sensor.rotation().transpose().col(1);
  T(2, column(kSensorYaw)) = 1.0;
  T.bottomRightCorner(size, size).setIdentity();
  const Pose2 place = graph.path_.robot(from).pose * sensor;
  if (parameters.row(kRangeScale) >= 0)
    for (std::size_t i = 0; i < landmarks.size(); ++i)
      T.block<2, 1>(3 + 2 * static_cast<Eigen::Index>(i), column(kRangeScale)) =
          place.position() - graph.point(landmarks[i]);
  return T * P * T.transpose();
}

PoseEstimate sensorOf(const LandmarkGraph& landmarks, const Pose2& on_robot,
                      const Viewpoint& from) {
  const auto robot = landmarks.robot(from);
  Eigen::Matrix3d J_robot;
  const Pose2 pose = robot.pose.compose(on_robot, &J_robot);
  if (!calibrates(landmarks)) return {pose, J_robot * robot.covariance * J_robot.transpose()};
  return {pose, coordinateCovariance(pose, covarianceFrom(landmarks, on_robot, {}, from))};
}

double rangeScaleVarianceOf(const LandmarkGraph& landmarks) {
  const auto* parameters = parametersOf(landmarks.path_);
  if (parameters == nullptr || parameters->row(kRangeScale) < 0) return 0.0;
  return parameters->estimate(landmarks.path_.graph()).covariance(kRangeScale, kRangeScale);
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
  carried.covariance += J * tailCovarianceOf(path_) * J.transpose();
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
  startNode(node);
  const auto& motion = path_.tail().motion;
  Sighting sighting{carriedBack(z, sensor), motion ? motion->increment * sensor : sensor,
                    sensorPart(calibrationOf(path_))};
  auto& graph = path_.graph();
  const auto known = sightings_.find(landmark);
  if (known != sightings_.end()) {
    const auto before = renewed(known->second);
    const auto both = fused(before.z, before.sensor, sighting.z, sighting.sensor);
    if (!both) return;
    sighting.z = *both;
    graph.remove(index_.remove(landmark, node));
  }
  addSighting(landmark, sighting, node);
  sightings_[landmark] = sighting;
}

void LandmarkGraph::addSighting(std::size_t landmark, const Sighting& sighting, graph::Key node) {
  const auto factor = std::make_shared<graph::RangeBearing>(
      node, keys_[landmark], sighting.sensor, sighting.z.vector(),
      graph::weightOfCovariance(sighting.z.covariance));
  auto& graph = path_.graph();
  if (const auto* parameters = parametersOf(path_))
    index_.add(landmark, node,
               graph.add(std::make_shared<graph::CalibratedSighting>(
                   node, keys_[landmark], parameters->ofSensor(), *factor, sighting.then)));
  else
    index_.add(landmark, node, graph.add(factor));
}

LandmarkGraph::Sighting LandmarkGraph::renewed(Sighting sighting) const {
  if (parametersOf(path_) == nullptr) return sighting;
  const auto now = sensorPart(calibrationOf(path_));
  const auto& then = sighting.then;
  const Eigen::Vector2d moved = now.offset - then.offset;
  sighting.sensor = {sighting.sensor.x() + moved.x(), sighting.sensor.y() + moved.y(),
                     sighting.sensor.theta() + now.yaw - then.yaw};
  CalibrationVector scale = CalibrationVector::Zero();
  scale(kRangeScale) = now.range_scale - then.range_scale;
  sighting.z = calibrated(std::move(sighting.z), scale);
  sighting.then = now;
  return sighting;
}

NodeObservations renewed(const LandmarkGraph& landmarks, NodeObservations seen) {
  auto& array = seen.array;
  LandmarkGraph::Sighting at{{}, array.sensor_pose, seen.then};
  for (auto& z : array.observations) {
    at.z = z;
    z = landmarks.renewed(at).z;
  }
  const auto now = landmarks.renewed(at);
  array.sensor_pose = now.sensor;
  seen.then = now.then;
  return seen;
}

void LandmarkGraph::startNode(graph::Key node) {
  if (std::exchange(sightings_node_, node) != node) sightings_.clear();
}

/// What the factor of a node says.
LandmarkGraph::Sighting LandmarkGraph::sightingOf(std::size_t landmark, graph::Key node) const {
  const auto& any = factorOf(path_.graph(), index_.factor(landmark, node));
  const auto* calibrated = dynamic_cast<const graph::CalibratedSighting*>(&any);
  const auto& factor =
      calibrated != nullptr ? calibrated->seen() : dynamic_cast<const graph::RangeBearing&>(any);
  Sighting sighting;
  if (calibrated != nullptr) sighting.then = calibrated->then();
  sighting.sensor = factor.sensor();
  sighting.z.range = factor.measured().x();
  sighting.z.bearing = factor.measured().y();
  sighting.z.covariance = (factor.weight().transpose() * factor.weight()).inverse();
  return renewed(sighting);
}

NodeObservations fromNode(LandmarkGraph& landmarks, const LandmarkObservationArray& array) {
  auto& path = landmarks.path_;
  const auto& seen = array.observations;
  const bool is_blurred = std::any_of(seen.begin(), seen.end(), [&](const auto& z) {
    return landmarks.isBlurred(z, array.sensor_pose);
  });
  NodeObservations from_node{is_blurred ? path.addNode() : path.nodeNearby(), array,
                             sensorPart(calibrationOf(path))};
  landmarks.startNode(from_node.node);
  for (auto& z : from_node.array.observations) z = landmarks.carriedBack(z, array.sensor_pose);
  if (const auto& motion = path.tail().motion)
    from_node.array.sensor_pose = motion->increment * array.sensor_pose;
  return from_node;
}

void LandmarkGraph::observe(const Match& match, const Pose2& sensor, graph::Key node) {
  Sighting sighting{match.z, sensor, sensorPart(calibrationOf(path_))};
  const auto& seen = index_.seenFrom(node);
  if (std::find(seen.begin(), seen.end(), match.landmark) != seen.end()) {
    const auto known = sightingOf(match.landmark, node);
    const auto both = fused(sighting.z, sensor, known.z, known.sensor);
    if (!both) return;
    sighting = {*both, known.sensor, known.then};
    path_.graph().remove(index_.remove(match.landmark, node));
  }
  addSighting(match.landmark, sighting, node);
  if (node == sightings_node_) sightings_[match.landmark] = sighting;
}

std::vector<std::size_t> contradictionsOf(const LandmarkGraph& landmarks, graph::Key node,
                                          double gate) {
  const auto& graph = landmarks.path_.graph();
  std::vector<std::size_t> contradicting;
  for (const auto landmark : landmarks.index_.seenFrom(node))
    if (isContradicting(graph, factorOf(graph, landmarks.index_.factor(landmark, node)), gate))
      contradicting.push_back(landmark);
  return contradicting;
}

NodeObservations withdraw(LandmarkGraph& landmarks, std::size_t landmark, graph::Key node) {
  const auto sighting = landmarks.sightingOf(landmark, node);
  landmarks.path_.graph().remove(landmarks.index_.remove(landmark, node));
  if (node == landmarks.sightings_node_) landmarks.sightings_.erase(landmark);
  NodeObservations withdrawn{node, {}, sighting.then};
  withdrawn.array.sensor_pose = sighting.sensor;
  withdrawn.array.observations = {sighting.z};
  return withdrawn;
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

}  // namespace slam::landmark_graph
