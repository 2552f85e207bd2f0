// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_fragment.hpp"

#include <exception>
#include <utility>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/lost_reporter.hpp"

namespace slam {
namespace {

/// @return whether the back-end has mapped anything
bool hasMap(Backend& backend) {
  const auto capabilities = capabilitiesOf(backend);
  const auto* landmarks = capabilities.find<LandmarkMapper>();
  if (landmarks != nullptr && !landmarks->landmarks().empty()) return true;
  const auto* gridder = capabilities.find<GridMapper>();
  const auto grid = gridder == nullptr ? std::nullopt : gridder->grid();
  return grid && !grid->cells.empty();
}

}  // namespace

void MapFragment::use(SessionMerger* merger) {
  merger_ = merger;
  reset();
}

void MapFragment::reset() {
  drop();
  ended_.clear();
  aside_.clear();
  since_found_ = 0.0;
  robot_.reset();
  counters_.clear();
}

void MapFragment::restart(bool grows) {
  drop();
  if (grows) begin();
}

void MapFragment::begin() {
  if (merger_ != nullptr) backend_ = merger_->makeAlike();
  if (backend_) ports_ = portsOf(*backend_);
}

void MapFragment::drop() {
  ports_ = Ports();
  backend_.reset();
  way_ = 0.0;
  last_.reset();
  gating_ = GatingRate(kWindow);
  doubt_.forget();
  scan_change_.forget();
  was_carried_ = false;
}

void MapFragment::predict(const Motion& motion) {
  if (!backend_) return;
  doubt_.move(motion);
  scan_change_.move(motion);
  see(kindOf<Motion>(), &motion);
}

void MapFragment::see(Kind kind, const void* value) {
  if (!backend_) return;
  if (kind == kindOf<LandmarkObservationArray>())
    doubt_.see(*static_cast<const LandmarkObservationArray*>(value));
  if (kind == kindOf<LaserScan>() && !admit(*static_cast<const LaserScan*>(value))) return;
  for (const auto& input : ports_.inputs()) {
    if (input.kind != kind) continue;
    input.set(value);
    return;
  }
}

/// @return whether the scan may be mapped
bool MapFragment::admit(const LaserScan& scan) {
  using Verdict = relocalisation::ScanChange::Verdict;
  const auto verdict = scan_change_.judge(scan);
  was_carried_ = was_carried_ || verdict == Verdict::kChanged;
  return verdict == Verdict::kGoesOn;
}

Status MapFragment::judge(const Situation& now) {
  constexpr double kProven = 10.0;  // way on which a wrong place is noticed [m]
  if (now.is_lost) {
    since_found_ = 0.0;
    robot_.reset();
    map(now.stamp);
    return Status::ok();
  }
  end();
  if (ended_.empty()) return Status::ok();
  if (robot_) since_found_ += robot_->between(now.robot).position().norm();
  robot_ = now.robot;
  return now.is_tested || since_found_ < kProven ? Status::ok() : handOver();
}

/// Grows the fragment by a step. A fault in it must not end the product's own step.
void MapFragment::map(Stamp stamp) {
  if (!backend_) return begin();
  try {
    backend_->execute();
  } catch (const std::exception&) {
    return drop();
  }
  const auto robot = backend_->pose();
  if (!robot.pose.isFinite() || !robot.covariance.allFinite()) return drop();
  if (last_) way_ += last_->between(robot.pose).position().norm();
  last_ = robot.pose;
  if (isLostItself(stamp)) setAside();
}

/// Judges the fragment as the product's map is judged: the robot may be carried a second time.
bool MapFragment::isLostItself(Stamp stamp) {
  const auto capabilities = capabilitiesOf(*backend_);
  if (const auto* mapper = capabilities.find<LandmarkMapper>()) {
    gating_.add(mapper->statistics());
    doubt_.judge(mapper->statistics(), *last_, stamp);
  }
  const auto* reporter = capabilities.find<LostReporter>();
  const bool is_lost_by_scans = reporter != nullptr && reporter->lostSince().has_value();
  return was_carried_ || is_lost_by_scans || gating_.isExcessive() || doubt_.isLost();
}

/// @return what has been mapped, if it is worth keeping
std::optional<SavedSession> MapFragment::session() const {
  constexpr double kLeastWay = 10.0;  // [m]
  if (!backend_ || way_ < kLeastWay || !hasMap(*backend_)) return std::nullopt;
  try {
    return as<SessionKeeper>(*backend_).session();
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void MapFragment::keep(SavedSession session, Sessions& sessions) {
  constexpr std::size_t kMost = 5;
  sessions.push_back(std::move(session));
  if (sessions.size() <= kMost) return;
  sessions.erase(sessions.begin());
  counters_.add("fragments_left_out");
}

void MapFragment::end() {
  if (auto ended = session()) keep(std::move(*ended), ended_);
  drop();
}

void MapFragment::setAside() {
  end();
  for (auto& session : std::exchange(ended_, {})) keep(std::move(session), aside_);
}

Status MapFragment::handOver() {
  Status status;
  for (auto& session : std::exchange(ended_, {})) {
    try {
      merger_->merge(session);
      counters_.add("map_fragments");
    } catch (const std::exception& error) {
      keep(std::move(session), aside_);
      status = Status::warning(
          std::string("what was mapped while the robot was lost is not merged: ") + error.what());
    }
  }
  return status;
}

MapFragment::Sessions MapFragment::unmerged() const {
  if (merger_ == nullptr) return {};
  auto sessions = merger_->unmerged();
  for (const auto* kept : {&ended_, &aside_})
    sessions.insert(sessions.end(), kept->begin(), kept->end());
  if (auto growing = session()) sessions.push_back(std::move(*growing));
  return sessions;
}

}  // namespace slam
