// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/loaded_grid.hpp"
#include "slam_core/graph_slam/scan_graph.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

// How scans, submaps and loops go into a session and out of it: the part of each class that writes
// and reads its own members.

namespace slam::graph_slam {
namespace {

Session::Submap recordOf(const Submap& submap, const SessionNumbers& numbers,
                         const ScanNumbers& scans, double ended) {
  Session::Submap record{
      numbers.variable(submap.origin()), submap.odomOrigin(), submap.isLoaded(), {}, ended};
  const auto first = submap.places().size() - submap.scans().size();
  for (std::size_t i = 0; i < submap.scans().size(); ++i)
    record.scans.push_back({scans.at(submap.scans()[i].get()), submap.places()[first + i]});
  return record;
}

}  // namespace

void GridRenderer::write(const SessionNumbers& numbers, Session& session) const {
  for (const auto& [node, pose, scan] : scans_)
    session.scans.push_back({numbers.variable(node), pose, scan});
  session.base = base_;
}

void GridRenderer::read(const Session& session) {
  if (session.base) startWith(*session.base);
  for (const auto& [node, drawn, scan] : session.scans) add(keyOfNode(node), drawn, scan);
}

void Submaps::write(const SessionNumbers& numbers, const ScanNumbers& scans,
                    Session& session) const {
  auto& to = session.submaps;
  for (const auto& [submap, ended, used] : finished_)
    to.finished.push_back(recordOf(submap, numbers, scans, ended));
  if (!older_.isEmpty()) to.older = recordOf(older_, numbers, scans, 0.0);
  if (younger_) to.younger = recordOf(*younger_, numbers, scans, 0.0);
  to.gone = gone_;
  to.renewed = renewed_;
  to.last = last_;
}

void Submaps::read(const Session& session, std::unique_ptr<scan_matching::ScanMap> base) {
  const auto models = scan_matching::levelModels(config_);
  const auto restored = [&](const Session::Submap& record) {
    std::vector<SharedScan> scans;
    std::vector<Pose2> poses;
    for (const auto& [scan, pose] : record.scans) {
      scans.push_back(session.scans[scan].scan);
      poses.push_back(pose);
    }
    if (!record.is_base)
      return Submap(config_, keyOfNode(record.origin), record.odom_origin, std::move(scans),
                    std::move(poses));
    Submap submap(std::move(base), keyOfNode(record.origin), placesIn(*session.base));
    constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
    for (std::size_t i = 0; i < scans.size(); ++i)
      submap.insert(scans[i], scan_matching::pointsOf(*scans[i], models, kNoMatter),
                    keyOfNode(record.origin), poses[i]);
    return submap;
  };
  const auto& from = session.submaps;
  for (const auto& record : from.finished) finished_.push_back({restored(record), record.ended, 0});
  if (from.older) older_ = restored(*from.older);
  if (from.younger) younger_ = restored(*from.younger);
  older_.map();  // these two are drawn on
  if (younger_) younger_->map();
  gone_ = from.gone;
  renewed_ = from.renewed;
  last_ = from.last;
}

void ScanGraph::write(const SessionNumbers& numbers, Session& session) const {
  renderer_.write(numbers, session);
  ScanNumbers scans;
  for (std::size_t i = 0; i < session.scans.size(); ++i)
    scans[session.scans[i].scan.get()] = static_cast<Session::Index>(i);
  submaps_.write(numbers, scans, session);
  for (const auto& [factor, is_believed, weight, is_alone] : loops_.states()) {
    const auto& between = static_cast<const graph::Between&>(*factor);
    session.loops.push_back(
        {graph_slam::recordOf(between, numbers), is_believed, weight, is_alone});
  }
  auto& to = session.submaps;
  to.robot = tracker_.robot();
  to.node = numbers.variable(node_);
  to.node_in_odom = node_in_odom_;
  to.carried = carried_;
}

Status ScanGraph::read(const Session& session) {
  Status status;
  std::unique_ptr<scan_matching::ScanMap> base;
  if (session.base) {
    auto loaded = drawn(*session.base, grid_config_);
    status = loaded.status;
    if (status.level == Status::Level::kError) return status;
    base = std::move(loaded.map);
  }
  const auto& from = session.submaps;
  submaps_.read(session, std::move(base));
  renderer_.read(session);
  loops_.restore(loopsOf(session));
  tracker_.restart(from.robot);
  if (!session.scans.empty()) trigger_.note(from.last);
  node_.reset();
  if (from.node) node_ = keyOfNode(*from.node);
  node_in_odom_ = from.node_in_odom;
  carried_ = from.carried;
  return status;
}

}  // namespace slam::graph_slam
