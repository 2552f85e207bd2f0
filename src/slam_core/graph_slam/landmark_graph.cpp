// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/landmark_graph.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/sighting_fusion.hpp"

// Symbols: a twist of the robot is a small motion in its own frame, J takes it to the coordinates
// (x, y, theta); P a covariance, Q that of the motion since the last node.

namespace slam::graph_slam {
namespace {

/// A joint covariance of more landmarks would make a clique of all of them.
constexpr std::size_t kLargestJoint = 100;
/// Smaller errors of a pose [m, rad] are not told apart from none.
constexpr double kSmallestSigma = 1e-6;

Eigen::Matrix3d ofTwist(const Pose2& pose, const Eigen::Matrix3d& P) {
  const Eigen::Matrix3d J_inverse = pose.twistJacobian().transpose();
  return J_inverse * P * J_inverse.transpose() +
         kSmallestSigma * kSmallestSigma * Eigen::Matrix3d::Identity();
}

Eigen::Matrix3d ofCoordinates(const Pose2& pose, const Eigen::Matrix3d& P_twist) {
  const Eigen::Matrix3d J = pose.twistJacobian();
  const Eigen::Matrix3d P = J * P_twist * J.transpose();
  return 0.5 * (P + P.transpose());
}

}  // namespace

LandmarkGraph::LandmarkGraph(const NodeLimits& limits, const PoseEstimate& start)
    : limits_(limits), start_(start) {}

LandmarkGraph::LandmarkGraph(const NodeLimits& limits, const MapState& map, double inflation)
    : limits_(limits), start_(map.robot) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& landmark : map.landmarks) {
    addLandmark(landmark.id, landmark.position);
    points.push_back(landmark.position);
  }
  const auto& joint = map.joint_covariance;
  if (joint.size() > 0 && map.landmarks.size() <= kLargestJoint) {
    node_ = graph_.add(map.robot.pose);
    ++nodes_;
    std::vector<graph::Key> keys = {*node_};
    keys.insert(keys.end(), keys_.begin(), keys_.end());
    Eigen::MatrixXd P = joint;
    const Eigen::Matrix3d J_inverse = map.robot.pose.twistJacobian().transpose();
    P.topRows<3>() = J_inverse * joint.topRows<3>();
    P.leftCols<3>() = P.leftCols<3>().eval() * J_inverse.transpose();
    graph_.add(std::make_unique<graph::JointPrior>(keys, map.robot.pose, points,
                                                   graph::weightOfCovariance(P)));
  } else {
    for (std::size_t i = 0; i < points.size(); ++i)
      factors_of_[i].push_back(graph_.add(std::make_unique<graph::PointPrior>(
          keys_[i], points[i],
          graph::weightOfCovariance(inflation * inflation * map.landmarks[i].covariance))));
  }
  optimize(1);
}

std::optional<std::size_t> LandmarkGraph::find(LandmarkId id) const {
  const auto found = number_.find(id);
  if (found == number_.end()) return std::nullopt;
  return found->second;
}

graph::Key LandmarkGraph::addLandmark(LandmarkId id, const Eigen::Vector2d& place) {
  number_[id] = ids_.size();
  ids_.push_back(id);
  keys_.push_back(graph_.add(place));
  factors_of_.emplace_back();
  largest_id_ = std::max(largest_id_, id);
  return keys_.back();
}

PoseEstimate LandmarkGraph::base() const {
  if (!node_) return start_;
  const Pose2 pose = graph_.pose(*node_);
  return {pose, ofCoordinates(pose, graph_.covariance({*node_}))};
}

PoseEstimate LandmarkGraph::robot() const {
  const auto from = base();
  if (!motion_) return from;
  Eigen::Matrix3d J_base, J_motion;
  const Pose2 pose = from.pose.compose(motion_->increment, &J_base, &J_motion);
  const Eigen::Matrix3d P = J_base * from.covariance * J_base.transpose() +
                            J_motion * motion_->covariance * J_motion.transpose();
  return {pose, 0.5 * (P + P.transpose())};
}

Eigen::MatrixXd LandmarkGraph::covariance(const std::vector<std::size_t>& landmarks) const {
  std::vector<graph::Key> keys;
  if (node_) keys.push_back(*node_);
  for (const auto landmark : landmarks) keys.push_back(keys_[landmark]);
  const Eigen::MatrixXd known = graph_.covariance(keys);
  const auto size = 3 + 2 * static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size, size);
  P.bottomRightCorner(known.rows(), known.cols()) = known;
  if (!node_) P.topLeftCorner<3, 3>() = ofTwist(start_.pose, start_.covariance);
  if (!motion_) return P;
  const Eigen::Matrix3d Ad = motion_->increment.inverse().adjoint();
  P.topRows<3>() = Ad * P.topRows<3>().eval();
  P.leftCols<3>() = P.leftCols<3>().eval() * Ad.transpose();
  P.topLeftCorner<3, 3>() += ofTwist(motion_->increment, motion_->covariance);
  return P;
}

PosePrediction LandmarkGraph::predict(const Motion& motion) {
  PosePrediction prediction;
  Eigen::Matrix3d J_motion;
  robot().pose.compose(motion.increment, &prediction.F, &J_motion);
  prediction.Q = J_motion * motion.covariance * J_motion.transpose();
  motion_ = motion_ ? joined(*motion_, motion) : motion;
  return prediction;
}

void LandmarkGraph::relocate(const PoseEstimate& robot) {
  start_ = robot;
  node_.reset();
  motion_.reset();
  sightings_.clear();
}

bool LandmarkGraph::nodeIsDue() const {
  if (!node_) return true;
  if (!motion_) return false;
  return motion_->increment.position().norm() > limits_.distance ||
         std::abs(motion_->increment.theta()) > limits_.angle;
}

void LandmarkGraph::addNode() {
  const auto now = robot();
  const auto key = graph_.add(now.pose);
  if (node_) {
    const auto W = graph::weightOfCovariance(ofTwist(motion_->increment, motion_->covariance));
    graph_.add(std::make_unique<graph::Between>(*node_, key, motion_->increment, W));
  } else {
    const auto W = graph::weightOfCovariance(ofTwist(now.pose, now.covariance));
    graph_.add(std::make_unique<graph::PosePrior>(key, now.pose, W));
  }
  node_ = key;
  ++nodes_;
  motion_.reset();
  sightings_.clear();
}

/// The observation as if made from the last node: with the noise of the motion since then.
LandmarkObservation LandmarkGraph::carriedBack(const LandmarkObservation& z,
                                               const Pose2& sensor) const {
  if (!motion_) return z;
  const RangeBearingModel model;
  ObservationModel::Jacobian23 J;
  const auto place = model.invert(motion_->increment, sensor, z.vector());
  model.predict(motion_->increment, sensor, place, &J);
  LandmarkObservation carried = z;
  carried.covariance += J * motion_->covariance * J.transpose();
  return carried;
}

void LandmarkGraph::see(std::size_t landmark, const LandmarkObservation& z, const Pose2& sensor) {
  Sighting sighting{-1, carriedBack(z, sensor), motion_ ? motion_->increment * sensor : sensor};
  auto& factors = factors_of_[landmark];
  const auto known = sightings_.find(landmark);
  if (known != sightings_.end()) {
    const auto both = fused(known->second.z, known->second.sensor, sighting.z, sighting.sensor);
    if (!both) return;
    sighting.z = *both;
    graph_.remove(known->second.factor);
    factors.erase(std::find(factors.begin(), factors.end(), known->second.factor));
  }
  sighting.factor = graph_.add(std::make_unique<graph::RangeBearing>(
      *node_, keys_[landmark], sighting.sensor, sighting.z.vector(),
      graph::weightOfCovariance(sighting.z.covariance)));
  factors.push_back(sighting.factor);
  sightings_[landmark] = sighting;
}

void LandmarkGraph::observe(const std::vector<Match>& matches, const Pose2& sensor) {
  if (matches.empty()) return;
  if (nodeIsDue()) addNode();
  for (const auto& match : matches) see(match.landmark, match.z, sensor);
}

void LandmarkGraph::append(LandmarkId id, const Eigen::Vector2d& place,
                           const LandmarkObservation& z, const Pose2& sensor) {
  if (nodeIsDue()) addNode();
  addLandmark(id, place);
  see(ids_.size() - 1, z, sensor);
}

void LandmarkGraph::reinitialize(std::size_t landmark, const Eigen::Vector2d& place,
                                 const LandmarkObservation& z, const Pose2& sensor) {
  if (nodeIsDue()) addNode();
  for (const auto factor : factors_of_[landmark]) graph_.remove(factor);
  factors_of_[landmark].clear();
  sightings_.erase(landmark);
  graph_.set(keys_[landmark], place);
  see(landmark, z, sensor);
}

void LandmarkGraph::optimize(int most_iterations) {
  std::vector<graph::Key> last;
  if (node_) last.push_back(*node_);
  for (int i = 0; i < most_iterations; ++i)
    if (!graph_.update(last)) return;
}

void LandmarkGraph::mark(Stamp stamp) {
  const Pose2 moved = motion_ ? motion_->increment : Pose2();
  marks_.push_back({stamp, node_.value_or(-1), node_ ? moved : start_.pose * moved});
}

std::vector<StampedPose> LandmarkGraph::path() const {
  std::vector<StampedPose> path;
  path.reserve(marks_.size());
  for (const auto& mark : marks_)
    path.push_back(
        {mark.stamp, mark.node < 0 ? mark.relative : graph_.pose(mark.node) * mark.relative});
  return path;
}

std::vector<std::size_t> LandmarkGraph::orderById() const {
  std::vector<std::size_t> order(ids_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [this](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
  return order;
}

LandmarkMap LandmarkGraph::map() const {
  LandmarkMap map;
  for (const auto i : orderById()) map.push_back({ids_[i], point(i), covariance(i)});
  return map;
}

MapState LandmarkGraph::state() const {
  MapState state{robot(), {}, {}};
  const auto order = orderById();
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
