// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_check.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

#include "slam_core/geometry/principal_axes.hpp"

namespace slam::graph_slam {
namespace {

void require(bool holds, const std::string& fault) {
  if (!holds) throw std::runtime_error(fault);
}

/// Whether W^T W is an information matrix.
bool isWeight(const Eigen::MatrixXd& W) {
  if (W.rows() != W.cols()) return false;
  const Eigen::MatrixXd information = W.transpose() * W;
  return information.allFinite() &&
         Eigen::LLT<Eigen::MatrixXd>(information).info() == Eigen::Success;
}

/// Whether it may be what is known of a pose or a motion, which may be all.
bool isSpread(const Eigen::Matrix3d& P) {
  constexpr double kRounding = 1e-9;
  const double most = P.cwiseAbs().maxCoeff();
  if (!(P - P.transpose()).isZero(kRounding * most)) return false;
  return principalAxes(P).values(0) >= -kRounding * most;
}

/// Which nodes and landmarks hang together (disjoint sets), and with the map.
class Ties {
 public:
  explicit Ties(std::size_t variables) : parent_(variables + 1) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void tie(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  void tieToMap(std::size_t a) { tie(a, parent_.size() - 1); }
  bool areAllTied() {
    const auto map = root(parent_.size() - 1);
    for (std::size_t i = 0; i < parent_.size(); ++i)
      if (root(i) != map) return false;
    return true;
  }

 private:
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<std::size_t> parent_;
};

/// Looks at the parts of a session one by one; the first fault is thrown.
class SessionCheck {
 public:
  explicit SessionCheck(const Session& session)
      : it_(session), ties_(session.nodes.size() + session.landmarks.size()) {}

  void run() {
    const auto most = static_cast<std::size_t>(std::numeric_limits<graph::Key>::max());
    require(it_.nodes.size() + it_.landmarks.size() + it_.factors.size() < most,
            "it holds more nodes, landmarks and factors than a graph can have");
    checkIds();
    for (const auto& factor : it_.factors)
      std::visit([this](const auto& record) { check(record); }, factor);
    require(ties_.areAllTied(),
            "its graph does not hang together: nodes or landmarks are tied to "
            "nothing that lies in the map");
    checkChords();
    for (const auto& loop : it_.loops) check(loop);
    checkSightings();
    for (const auto& mark : it_.path) requireNode(mark.node);
    checkRobot();
    checkScans();
  }

 private:
  void requireNode(std::optional<Session::Index> node) const {
    require(!node || *node < it_.nodes.size(), "it names a node that it does not hold");
  }
  void requireLandmark(Session::Index landmark) const {
    require(landmark < it_.landmarks.size(), "it names a landmark that it does not hold");
  }
  static void requireWeight(const Eigen::MatrixXd& W) {
    require(isWeight(W), "it holds a covariance that is not positive definite");
  }
  static void requireSpread(const Eigen::Matrix3d& P) {
    require(isSpread(P), "it holds a covariance that is not symmetric or is negative");
  }
  void requireMotion(const std::optional<Motion>& motion) const {
    if (motion) requireSpread(motion->covariance);
  }
  std::size_t ofLandmark(Session::Index landmark) const { return it_.nodes.size() + landmark; }

  void checkIds() const {
    std::set<LandmarkId> ids;
    for (const auto& landmark : it_.landmarks) {
      require(landmark.id >= 0, "it holds a landmark without an id");
      require(landmark.is_retired || ids.insert(landmark.id).second,
              "it holds landmark " + std::to_string(landmark.id) + " twice");
      require(landmark.fits >= 0 && landmark.misses >= 0,
              "it holds a landmark that was seen less than never");
      const auto fault = faultOf(landmark.descriptor);
      require(fault.empty(), "landmark " + std::to_string(landmark.id) + " of it" + fault);
    }
  }
  void check(const Session::PosePrior& prior) {
    requireNode(prior.node);
    requireWeight(prior.weight);
    ties_.tieToMap(prior.node);
  }
  void check(const Session::PointPrior& prior) {
    requireLandmark(prior.landmark);
    requireWeight(prior.weight);
    ties_.tieToMap(ofLandmark(prior.landmark));
  }
  void check(const Session::JointPrior& prior) {
    requireNode(prior.node);
    std::set<Session::Index> landmarks;
    for (const auto landmark : prior.landmarks) {
      requireLandmark(landmark);
      require(landmarks.insert(landmark).second, "a prior of it names a landmark twice");
      ties_.tieToMap(ofLandmark(landmark));
    }
    const auto rows = static_cast<std::size_t>(prior.weight.rows());
    require(prior.points.size() == landmarks.size() && rows == 3 + 2 * landmarks.size(),
            "a prior of it is not as large as the landmarks that it names");
    requireWeight(prior.weight);
    ties_.tieToMap(prior.node);
  }
  void check(const Session::Between& between) {
    checkAlone(between);
    ties_.tie(between.from, between.to);
  }
  void check(const Session::RangeBearing& seen) {
    requireNode(seen.node);
    requireLandmark(seen.landmark);
    requireWeight(seen.weight);
    require(seen.z.x() > 0.0, "it holds a range that is not positive");
    ties_.tie(seen.node, ofLandmark(seen.landmark));
  }
  void checkAlone(const Session::Between& between) const {
    requireNode(between.from);
    requireNode(between.to);
    require(between.from != between.to, "it ties a node to itself");
    requireWeight(between.weight);
  }
  void check(const Session::Loop& loop) const {
    checkAlone(loop.between);
    require(loop.share > 0.0 && loop.share <= 1.0, "it holds a loop whose weight is no share");
  }
  void checkChords() const {
    for (std::size_t i = 0; i < it_.chords.size(); ++i) {
      const auto chord = it_.chords[i];
      require(chord < it_.factors.size() &&
                  std::holds_alternative<Session::Between>(it_.factors[chord]) &&
                  (i == 0 || it_.chords[i - 1] < chord),
              "it names a second motion to a node that it does not hold");
    }
  }
  void checkSightings() const {
    requireNode(it_.sightings_node);
    std::set<Session::Index> seen;
    for (const auto& sighting : it_.sightings) {
      const auto* factor = sighting.factor < it_.factors.size()
                               ? std::get_if<Session::RangeBearing>(&it_.factors[sighting.factor])
                               : nullptr;
      require(factor != nullptr && it_.sightings_node == factor->node &&
                  seen.insert(factor->landmark).second,
              "what its last node has seen does not fit its factors");
      require(faultOf(sighting.z).empty(), "it holds an observation that cannot be used");
    }
  }
  void checkRobot() const {
    requireNode(it_.robot.node);
    requireSpread(it_.robot.start.covariance);
    requireMotion(it_.robot.motion);
    requireMotion(it_.last_motion);
  }

  void checkScans() {
    const auto& submaps = it_.submaps;
    const bool is_empty = it_.scans.empty() && it_.loops.empty() && submaps.finished.empty() &&
                          !submaps.older && !submaps.younger && !it_.base;
    require(it_.kind.has_grid || is_empty, "it holds scans although it has no grid");
    require(!it_.kind.has_grid || it_.kind.resolution > 0.0,
            "the resolution of its grid is not positive");
    for (const auto& scan : it_.scans) check(scan);
    for (const auto& submap : submaps.finished) check(submap);
    for (const auto* submap : {&submaps.older, &submaps.younger})
      if (*submap) check(**submap);
    require(!submaps.younger || submaps.older, "a submap of it was begun before the one before");
    require(bases_ == (it_.base ? 1 : 0), "its submaps do not fit the grid it began with");
    if (it_.base) checkBase(*it_.base);
    requireSpread(submaps.robot.covariance);
    requireMotion(submaps.carried);
    for (const auto* place : {&submaps.last, &submaps.reference})
      if (*place) check(**place);
    const bool has_last = submaps.last.has_value();
    require(has_last == submaps.reference.has_value() && (!has_last || it_.robot.node),
            "the nodes that its scans go by are not those of its path");
  }
  void check(const Session::Place& place) const {
    requireNode(place.node);
    requireSpread(place.in_odom.covariance);
    requireMotion(place.told);
  }
  void check(const Session::Scan& scan) const {
    requireNode(scan.node);
    forEachFan(*scan.scan, [&](const LaserFan& fan) {
      const bool is_fit = fan.relative_sigma >= 0.0 &&
                          std::all_of(fan.beams.begin(), fan.beams.end(),
                                      [](const LaserBeam& beam) { return beam.range >= 0.0F; });
      require(is_fit, "it holds a scan with a negative range");
    });
  }
  void check(const Session::Submap& submap) {
    requireNode(submap.origin);
    bases_ += submap.is_base ? 1 : 0;
    require(submap.is_base || !submap.scans.empty(), "it holds a submap without scans");
    for (const auto& placed : submap.scans)
      require(placed.scan < it_.scans.size(), "a submap of it names a scan that it does not hold");
  }
  static void checkBase(const OccupancyGrid& grid) {
    require(grid.resolution > 0.0 && std::uint64_t{grid.width} * grid.height == grid.cells.size(),
            "the grid it began with has not as many cells as it should");
  }

  const Session& it_;
  Ties ties_;
  int bases_ = 0;
};

}  // namespace

std::string faultOf(const Session& session) {
  try {
    SessionCheck(session).run();
    return "";
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
}

}  // namespace slam::graph_slam
