// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph_slam/loaded_grid.hpp"
#include "slam_core/graph_slam/session_parts.hpp"

namespace slam::graph_slam {
namespace {

Session::Submap recordOf(const Submap& submap, const SessionNumbers& numbers,
                         const ScanNumbers& scans, double ended) {
  Session::Submap record{
      numbers.variable(submap.origin()), submap.odomOrigin(), submap.isLoaded(), {}, ended};
  const auto first = submap.places().size() - scansOf(submap).size();
  for (std::size_t i = 0; i < scansOf(submap).size(); ++i)
    record.scans.push_back({scans.at(scansOf(submap)[i].get()), submap.places()[first + i]});
  return record;
}

}  // namespace

void SessionParts::write(const GridRenderer& renderer, const SessionNumbers& numbers,
                         Session& session) {
  for (const auto& [node, pose, scan, reach] : renderer.scans_)
    session.scans.push_back({numbers.variable(node), pose, scan});
  session.base = renderer.base_;
}

void SessionParts::read(const Session& session, GridRenderer& renderer) {
  if (session.base) renderer.startWith(*session.base);
  for (const auto& [node, drawn, scan] : session.scans) renderer.add(keyOfNode(node), drawn, scan);
}

void SessionParts::write(const Submaps& submaps, const SessionNumbers& numbers,
                         const ScanNumbers& scans, Session& session) {
  auto& to = session.submaps;
  for (const auto& [submap, ended, used] : submaps.finished_)
    to.finished.push_back(recordOf(submap, numbers, scans, ended));
  if (!submaps.older_.isEmpty()) to.older = recordOf(submaps.older_, numbers, scans, 0.0);
  if (submaps.younger_) to.younger = recordOf(*submaps.younger_, numbers, scans, 0.0);
  to.gone = submaps.gone_;
  to.renewed = submaps.renewed_;
  to.drawn = submaps.last_;
}

void SessionParts::read(const Session& session, std::unique_ptr<scan_matching::ScanMap> base,
                        Submaps& submaps) {
  const auto models = scan_matching::levelModels(submaps.config_);
  const auto restored = [&](const Session::Submap& record) {
    std::vector<SharedScan> scans;
    std::vector<Pose2> poses;
    std::vector<graph::Key> nodes;
    for (const auto& [scan, pose] : record.scans) {
      nodes.push_back(keyOfNode(session.scans[scan].node));
      scans.push_back(session.scans[scan].scan);
      poses.push_back(pose);
    }
    if (!record.is_base)
      return Submap(submaps.config_, keyOfNode(record.origin), record.odom_origin, std::move(nodes),
                    std::move(scans), std::move(poses));
    Submap submap(std::move(base), keyOfNode(record.origin), placesIn(*session.base));
    constexpr double kNoMatter = 1.0;  // ends to match with a map are not needed to draw one
    for (std::size_t i = 0; i < scans.size(); ++i)
      submap.insert(scans[i], scan_matching::pointsOf(*scans[i], models, kNoMatter), nodes[i],
                    poses[i]);
    return submap;
  };
  const auto& from = session.submaps;
  for (const auto& record : from.finished)
    submaps.finished_.push_back({restored(record), record.ended, 0});
  if (from.older) submaps.older_ = restored(*from.older);
  if (from.younger) submaps.younger_ = restored(*from.younger);
  submaps.older_.map();  // these two are drawn on
  if (submaps.younger_) submaps.younger_->map();
  submaps.gone_ = from.gone;
  submaps.renewed_ = from.renewed;
  submaps.last_ = from.drawn;
}

void SessionParts::write(const ScanGraph& graph, const SessionNumbers& numbers, Session& session) {
  write(graph.renderer_, numbers, session);
  ScanNumbers scans;
  for (std::size_t i = 0; i < session.scans.size(); ++i)
    scans[session.scans[i].scan.get()] = static_cast<Session::Index>(i);
  write(graph.submaps_, numbers, scans, session);
  for (const auto& [factor, is_believed, weight, is_alone] : graph.loops_.states()) {
    const auto& between = static_cast<const slam::graph::Between&>(*factor);
    session.loops.push_back(
        {graph_slam::recordOf(between, numbers), is_believed, weight, is_alone});
  }
  session.submaps.robot = graph.tracker_.robot();
  write(graph.told_, numbers, session);
}

void SessionParts::write(const ScanPath& path, const SessionNumbers& numbers, Session& session) {
  const auto record = [&](const std::optional<ScanPath::Place>& place) {
    std::optional<Session::Place> of_session;
    if (place) of_session = {numbers.variable(place->node), place->in_odom, place->told};
    return of_session;
  };
  auto& to = session.submaps;
  to.carried = path.carried_;
  to.last = record(path.last_);
  to.reference = record(path.reference_);
}

void SessionParts::read(const Session& session, ScanPath& path) {
  const auto restored = [](const std::optional<Session::Place>& place) {
    std::optional<ScanPath::Place> of_path;
    if (place) of_path = {keyOfNode(place->node), place->in_odom, place->told};
    return of_path;
  };
  const auto& from = session.submaps;
  path.carried_ = from.carried;
  path.last_ = restored(from.last);
  path.reference_ = restored(from.reference);
}

Status SessionParts::read(const Session& session, ScanGraph& graph) {
  Status status;
  std::unique_ptr<scan_matching::ScanMap> base;
  if (session.base) {
    auto loaded = drawn(*session.base, graph.grid_config_);
    status = loaded.status;
    if (status.level == Status::Level::kError) return status;
    base = std::move(loaded.map);
  }
  const auto& from = session.submaps;
  read(session, std::move(base), graph.submaps_);
  read(session, graph.renderer_);
  graph.reduction_.keepAll();
  graph.loops_.restore(loopsOf(session));
  graph.tracker_.restart(from.robot);
  if (!session.scans.empty()) graph.trigger_.note(from.drawn);
  read(session, graph.told_);
  return status;
}

}  // namespace slam::graph_slam
