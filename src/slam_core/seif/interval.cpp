// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/interval.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/seif/map_joining.hpp"

namespace slam::seif {
namespace {

bool contains(const std::vector<std::size_t>& all, std::size_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// The factors of an interval in a graph of their own, in the frame of its last pose.
class OwnGraph {
 public:
  OwnGraph(const graph::Optimizer& whole, graph::Key base)
      : whole_(whole), T_base_map_(whole.pose(base).inverse()), base_(keyOf(base)) {
    constexpr double kHeld = 1e6;  // the weight of what defines the frame [1/m, 1/rad]
    graph_.add(
        std::make_shared<graph::PosePrior>(base_, Pose2(), kHeld * Eigen::Matrix3d::Identity()));
  }

  graph::Key keyOf(graph::Key pose) {
    const auto [found, is_new] = keys_.try_emplace(pose, -1);
    if (is_new) found->second = graph_.add(T_base_map_ * whole_.pose(pose));
    return found->second;
  }
  graph::Key pointKeyOf(graph::Key point) {
    const auto [found, is_new] = keys_.try_emplace(point, -1);
    if (is_new) found->second = graph_.add(T_base_map_.transform(whole_.pose(point).position()));
    return found->second;
  }
  void addMotion(graph::FactorId id) {
    const auto& motion = dynamic_cast<const graph::Between&>(factorOf(whole_, id));
    graph_.add(std::make_shared<graph::Between>(keyOf(motion.keys()[0]), keyOf(motion.keys()[1]),
                                                motion.measured(), motion.weight()));
  }
  void addSighting(graph::FactorId id) {
    const auto& seen = dynamic_cast<const graph::RangeBearing&>(factorOf(whole_, id));
    graph_.add(std::make_shared<graph::RangeBearing>(keyOf(seen.keys()[0]),
                                                     pointKeyOf(seen.keys()[1]), seen.sensor(),
                                                     seen.measured(), seen.weight()));
  }
  graph::LocalMap solved(const std::vector<graph::Key>& poses,
                         const std::vector<graph::Key>& points) {
    constexpr int kSteps = 10;
    graph_.optimize({base_}, kSteps);
    const Pose2 T_base = graph_.pose(base_).inverse();
    graph::LocalMap map;
    std::vector<graph::Key> keys;
    for (const auto pose : poses) {
      keys.push_back(keyOf(pose));
      map.poses.push_back(T_base * graph_.pose(keys.back()));
    }
    for (const auto point : points) {
      keys.push_back(pointKeyOf(point));
      map.points.push_back(T_base.transform(graph_.pose(keys.back()).position()));
    }
    map.covariance = graph_.covariance(keys);
    return map;
  }

 private:
  const graph::Optimizer& whole_;
  Pose2 T_base_map_;
  graph::Optimizer graph_;
  std::unordered_map<graph::Key, graph::Key> keys_;  // looked up only, never iterated
  graph::Key base_;
};

}  // namespace

void Interval::see(graph::Key node) {
  for (const auto landmark : sightingsOf(landmarks_).seenFrom(node))
    if (!contains(observed_, landmark)) observed_.push_back(landmark);
}

void Interval::follow() {
  const std::size_t first = nodes_.empty() ? 0 : nodes_.size() - 1;
  for (const auto node : chainOf(path_).takeNew()) nodes_.push_back(node);
  for (std::size_t i = first; i < nodes_.size(); ++i) see(nodes_[i]);
}

std::vector<graph::Key> Interval::active() const {
  const auto most = 2 * limits_.landmarks;
  const auto first = observed_.size() > most ? observed_.size() - most : 0;
  std::vector<graph::Key> keys;
  for (std::size_t i = first; i < observed_.size(); ++i)
    keys.push_back(keyOf(landmarks_, observed_[i]));
  return keys;
}

bool Interval::isFull() const {
  if (nodes_.empty()) return false;
  return observed_.size() > limits_.landmarks || nodes_.size() >= limits_.nodes ||
         (!observed_.empty() && headingSigma() > limits_.heading);
}

/// Of the robot, relative to the first pose [rad].
double Interval::headingSigma() const {
  double variance = tailCovarianceOf(path_)(2, 2);
  if (nodes_.size() > 1) {
    const Eigen::MatrixXd P = path_.graph().covariance({nodes_.front(), nodes_.back()});
    variance += std::max(0.0, P(2, 2) + P(5, 5) - 2.0 * P(2, 5));
  }
  return std::sqrt(variance);
}

/// What is left of the interval without its poses, but for the last one and those with a prior.
/// @param with_joint the pose before the interval is kept as well, and the motion from there
MappedPart Interval::marginalised(bool with_joint) const {
  const auto& graph = path_.graph();
  OwnGraph own(graph, nodes_.back());
  MappedPart part;
  std::vector<graph::Key> points;
  if (with_joint) part.poses.push_back(joint_);
  for (const auto node : nodes_) {
    const auto& chain = chainOf(path_)[node];
    if (chain.has_prior && node != nodes_.back()) part.poses.push_back(node);
    if (chain.before >= 0 && (with_joint || node != nodes_.front()))
      own.addMotion(chain.link.factor);
    for (const auto landmark : sightingsOf(landmarks_).seenFrom(node))
      own.addSighting(sightingsOf(landmarks_).factor(landmark, node));
  }
  part.landmarks = observed_;
  for (const auto landmark : observed_) points.push_back(keyOf(landmarks_, landmark));
  part.map = own.solved(part.poses, points);
  return part;
}

/// Whether landmarks alone say how the interval lies in the map.
bool Interval::isTied(const MappedPart& part) const {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < part.landmarks.size(); ++i)
    if (contains(previous_->landmarks, part.landmarks[i]) || maps_.knows(part.landmarks[i]))
      known.push_back(i);
  return determinesBase(part.map, known);
}

/// Removes the pose between the interval before and this one.
void Interval::letGo() {
  separate(chainOf(path_), nodes_.front());
  path_.graph().remove(factor_);
  chainOf(path_).remove(joint_);
  maps_.add(*std::exchange(previous_, std::nullopt));
}

/// Removes all that the local map of the interval stands for.
void Interval::consume() {
  for (const auto node : nodes_) {
    for (const auto factor : sightingsOf(landmarks_).removeNode(node)) path_.graph().remove(factor);
    separate(chainOf(path_), node);
  }
  for (const auto node : nodes_)
    if (node != nodes_.back() && !chainOf(path_)[node].has_prior) chainOf(path_).remove(node);
  startSightings(landmarks_);
}

/// The local map of the interval before, with the pose between it and this one as one of its poses.
MappedPart Interval::withJoint(const MappedPart& part) const {
  auto [map, landmarks, poses] = part;
  const auto size = map.covariance.rows(), old_poses = 3 * static_cast<Eigen::Index>(poses.size());
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(size + 3, size + 3);  // the base has no error in itself
  P.topLeftCorner(old_poses, old_poses) = map.covariance.topLeftCorner(old_poses, old_poses);
  const auto points = size - old_poses;
  P.bottomRightCorner(points, points) = map.covariance.bottomRightCorner(points, points);
  P.topRightCorner(old_poses, points) = map.covariance.topRightCorner(old_poses, points);
  P.bottomLeftCorner(points, old_poses) = map.covariance.bottomLeftCorner(points, old_poses);
  map.covariance = P;
  map.poses.emplace_back();
  poses.push_back(joint_);
  return {map, landmarks, poses};
}

/// Keeps the pose between the interval before and this one, as one of either local map.
void Interval::keepJoint() {
  path_.graph().remove(factor_);
  maps_.add(withJoint(*std::exchange(previous_, std::nullopt)));
}

/// Marginalises the pose between both, where no more landmarks are joined by it than may be.
std::optional<MappedPart> Interval::continued(const MappedPart& part) {
  if (chainOf(path_)[joint_].has_prior) return std::nullopt;
  auto both = maps_.joined(part, withJoint(*previous_), {joint_});
  if (!both) return std::nullopt;
  separate(chainOf(path_), nodes_.front());
  path_.graph().remove(factor_);
  chainOf(path_).remove(joint_);
  previous_.reset();
  return both;
}

/// The pose between the interval before and this one goes where landmarks tie this one to the map.
MappedPart Interval::ended() {
  if (!previous_) return marginalised(false);
  const auto with_joint = marginalised(true);
  if (auto both = continued(with_joint)) return *both;
  auto part = marginalised(false);
  if (isTied(part) && !chainOf(path_)[joint_].has_prior) {
    letGo();
    return part;
  }
  keepJoint();
  return with_joint;
}

bool Interval::endWhereFull() {
  if (!isFull()) return false;
  auto part = ended();
  consume();
  joint_ = nodes_.back();
  std::vector<graph::Key> keys = {joint_};
  keys.insert(keys.end(), part.poses.begin(), part.poses.end());
  for (const auto landmark : part.landmarks) keys.push_back(keyOf(landmarks_, landmark));
  factor_ = path_.graph().add(std::make_shared<graph::BasedMap>(keys, part.map));
  previous_ = std::move(part);
  nodes_.clear();
  observed_.clear();
  path_.addNode();
  follow();
  return true;
}

void Interval::endForGood() {
  if (nodes_.empty()) return;
  const auto last = nodes_.back();
  if (!chainOf(path_)[last].has_prior) {
    auto part = ended();
    consume();
    chainOf(path_).remove(last);
    maps_.add(std::move(part));
  }
  previous_.reset();
  nodes_.clear();
  observed_.clear();
}

}  // namespace slam::seif
