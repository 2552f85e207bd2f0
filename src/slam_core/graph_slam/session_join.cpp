// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_join.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/names.hpp"

namespace slam::graph_slam {
namespace {

using Index = Session::Index;

/// Submaps of the other drive count as finished so long a way ago [m].
constexpr double kLongAgo = 1e6;

/// The numbers that the parts of the second session get in the joined one.
class Renumbering {
 public:
  Renumbering(const Session& first, const Session& second, const SessionLinks& links)
      : nodes_(static_cast<Index>(first.nodes.size())),
        scans_(static_cast<Index>(first.scans.size())),
        landmarks_(second.landmarks.size()) {
    for (const auto& [in_first, in_second] : links.landmarks) landmarks_[in_second] = in_first;
    std::set<LandmarkId> taken = {kUnknownId};
    for (const auto& landmark : first.landmarks)
      if (first.kind.has_own_ids || !landmark.is_retired) taken.insert(landmark.id);
    auto next = static_cast<Index>(first.landmarks.size());
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      const auto& landmark = second.landmarks[i];
      if (landmarks_[i] || landmark.is_retired) continue;
      const auto id = first.kind.has_own_ids ? *taken.rbegin() + 1 : landmark.id;
      if (!taken.insert(id).second) continue;
      landmarks_[i] = next++;
      added_.push_back({i, id});
    }
  }

  struct Added {
    std::size_t number;  ///< in the second session
    LandmarkId id;       ///< in the joined one
  };
  /// Those of the second session that the first one does not have.
  const std::vector<Added>& addedLandmarks() const { return added_; }
  /// @return the number of a landmark of the second session; none where it is left out
  const std::optional<Index>& landmark(Index number) const { return landmarks_[number]; }
  Index node(Index number) const { return nodes_ + number; }
  std::optional<Index> node(const std::optional<Index>& number) const {
    if (!number) return std::nullopt;
    return node(*number);
  }
  Session::Between between(Session::Between it) const {
    it.from = node(it.from);
    it.to = node(it.to);
    return it;
  }
  Session::Submap submap(Session::Submap it) const {
    it.origin = node(it.origin);
    for (auto& placed : it.scans) placed.scan += scans_;
    return it;
  }

 private:
  Index nodes_, scans_;
  std::vector<std::optional<Index>> landmarks_;
  std::vector<Added> added_;
};

/// Takes a factor of the second session into the joined one, where it has a place there.
class FactorTransfer {
 public:
  using Result = std::optional<Session::Factor>;
  explicit FactorTransfer(const Renumbering& renumbered) : renumbered_(renumbered) {}

  /// The first one says where the map frame is, which the other session does. The others say where
  /// their nodes are from there.
  Result operator()(const Session::PosePrior& it) {
    if (!first_) {
      first_ = it;
      return std::nullopt;
    }
    const Eigen::Matrix3d J = it.pose.between(first_->pose).adjoint();
    const Eigen::Matrix3d P =
        covarianceOf(it.weight) + J * covarianceOf(first_->weight) * J.transpose();
    return renumbered_.between(
        {first_->node, it.node, first_->pose.between(it.pose), graph::weightOfCovariance(P)});
  }
  Result operator()(const Session::Between& it) { return renumbered_.between(it); }
  Result operator()(Session::RangeBearing it) {
    const auto& landmark = renumbered_.landmark(it.landmark);
    if (!landmark) return std::nullopt;
    it.node = renumbered_.node(it.node);
    it.landmark = *landmark;
    return it;
  }
  // of a map that was loaded, which only the first session may have
  Result operator()(const Session::PointPrior&) { return std::nullopt; }
  Result operator()(const Session::JointPrior&) { return std::nullopt; }

 private:
  static Eigen::Matrix3d covarianceOf(const Eigen::Matrix3d& weight) {
    return (weight.transpose() * weight).inverse();
  }

  const Renumbering& renumbered_;
  std::optional<Session::PosePrior> first_;
};

/// @return the numbers of the second session's factors in the joined one
std::vector<std::optional<Index>> appendFactors(const Session& second,
                                                const Renumbering& renumbered, Session& joined) {
  std::vector<std::optional<Index>> numbers;
  FactorTransfer transfer(renumbered);
  for (const auto& factor : second.factors) {
    const auto taken = std::visit(transfer, factor);
    numbers.emplace_back();
    if (!taken) continue;
    numbers.back() = static_cast<Index>(joined.factors.size());
    joined.factors.push_back(*taken);
  }
  return numbers;
}

void append(const Session& second, const Renumbering& renumbered, const Pose2& first_second,
            Session& joined) {
  for (const auto& node : second.nodes) joined.nodes.push_back(first_second * node);
  for (const auto& [number, id] : renumbered.addedLandmarks()) {
    joined.landmarks.push_back(second.landmarks[number]);
    joined.landmarks.back().id = id;
    joined.landmarks.back().position = first_second.transform(second.landmarks[number].position);
  }
  for (auto loop : second.loops) {
    loop.between = renumbered.between(loop.between);
    joined.loops.push_back(loop);
  }
  for (auto scan : second.scans) {
    scan.node = renumbered.node(scan.node);
    scan.drawn = first_second * scan.drawn;
    joined.scans.push_back(scan);
  }
}

/// A path has one pose for each stamp: drives of the same time are not one path.
void appendMarks(const Session& second, const Renumbering& renumbered, const Pose2& first_second,
                 GoesOn goes_on, std::vector<Session::Mark>& marks) {
  auto others = second.path;
  for (auto& mark : others) {
    if (!mark.node) mark.pose = first_second * mark.pose;
    mark.node = renumbered.node(mark.node);
  }
  if (marks.empty() || others.empty() || marks.back().stamp < others.front().stamp)
    marks.insert(marks.end(), others.begin(), others.end());
  else if (others.back().stamp < marks.front().stamp)
    marks.insert(marks.begin(), others.begin(), others.end());
  else if (goes_on == GoesOn::kSecond)
    marks = std::move(others);
}

Session::Submaps renumberedSubmaps(const Session& second, const Renumbering& renumbered) {
  auto submaps = second.submaps;
  for (auto& submap : submaps.finished) submap = renumbered.submap(submap);
  if (submaps.older) submaps.older = renumbered.submap(*submaps.older);
  if (submaps.younger) submaps.younger = renumbered.submap(*submaps.younger);
  for (auto* place : {&submaps.last, &submaps.reference})
    if (*place) (*place)->node = renumbered.node((*place)->node);
  return submaps;
}

/// The submaps of the robot that goes on, behind those of the other one, all of them finished.
Session::Submaps joinedSubmaps(Session::Submaps other, Session::Submaps goes_on) {
  auto finished = std::move(other.finished);
  if (other.older) finished.push_back(*other.older);
  if (other.younger) finished.push_back(*other.younger);
  for (auto& submap : finished) submap.ended = goes_on.gone - kLongAgo;
  finished.insert(finished.end(), goes_on.finished.begin(), goes_on.finished.end());
  goes_on.finished = std::move(finished);
  return goes_on;
}

/// @param factors the numbers of the second session's factors in the joined one
void goOnWithSecond(const Session& second, const Renumbering& renumbered, const Pose2& first_second,
                    const std::vector<std::optional<Index>>& factors, Session& joined) {
  joined.stamp = second.stamp;
  joined.last_motion = second.last_motion;
  const auto nodes = joined.robot.nodes;
  joined.robot = second.robot;
  joined.robot.nodes = nodes;
  joined.robot.node = renumbered.node(second.robot.node);
  auto& start = joined.robot.start;
  start = {first_second * start.pose, coordinateCovariance(first_second, start.covariance)};
  joined.sightings_node = renumbered.node(second.sightings_node);
  joined.sightings.clear();
  for (auto sighting : second.sightings) {
    const auto& factor = factors[sighting.factor];
    if (!factor) continue;
    sighting.factor = *factor;
    joined.sightings.push_back(sighting);
  }
}

}  // namespace

bool hasLoadedMap(const Session& session) {
  return session.base || std::any_of(session.factors.begin(), session.factors.end(),
                                     [](const Session::Factor& factor) {
                                       return std::holds_alternative<Session::PointPrior>(factor) ||
                                              std::holds_alternative<Session::JointPrior>(factor);
                                     });
}

void requireJoinable(const Session& first, const Session& second) {
  if (first.kind.has_grid != second.kind.has_grid)
    throw std::invalid_argument("one session has a grid and the other one has none");
  if (first.kind.has_grid && first.kind.resolution != second.kind.resolution)
    throw std::invalid_argument("the sessions' grids have different resolutions");
  if (first.kind.has_own_ids != second.kind.has_own_ids)
    throw std::invalid_argument(
        "the landmarks of one session have ids of its own making and those of the other one the "
        "ids that were observed: run both drives with the same association");
  if (hasLoadedMap(second))
    throw std::invalid_argument(
        "the second session began with a map that was loaded: give it as the first one");
}

Session joined(const Session& first, const Session& second, const SessionLinks& links,
               GoesOn goes_on) {
  requireJoinable(first, second);
  const Renumbering renumbered(first, second, links);
  auto joined = first;
  append(second, renumbered, links.first_second, joined);
  const auto factors = appendFactors(second, renumbered, joined);
  for (const auto chord : second.chords) joined.chords.push_back(*factors[chord]);
  for (const auto& place : links.places)
    if (&place == &links.places.front())
      joined.factors.emplace_back(place);
    else
      joined.loops.push_back({place, true, 1.0, false});
  appendMarks(second, renumbered, links.first_second, goes_on, joined.path);
  joined.robot.nodes += second.robot.nodes;
  auto submaps = renumberedSubmaps(second, renumbered);
  if (goes_on == GoesOn::kSecond) {
    joined.submaps = joinedSubmaps(first.submaps, std::move(submaps));
    goOnWithSecond(second, renumbered, links.first_second, factors, joined);
  } else {
    joined.submaps = joinedSubmaps(std::move(submaps), first.submaps);
  }
  return joined;
}

}  // namespace slam::graph_slam
