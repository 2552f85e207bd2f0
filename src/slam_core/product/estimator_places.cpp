// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

// This file has what gives an estimator a place: a pose, a map or a session, at the start or later.

#include <stdexcept>
#include <utility>

#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/session_merger.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/place_fault.hpp"

namespace slam {

using relocalisation::Belief;

Status Estimator::set(const PoseEstimate& initial_pose) {
  if (const auto fault = faultOf(initial_pose); !fault.empty())
    return Status::error(fault + "; it is left out");
  backend_->set(bounded(initial_pose, largestSigmas()));
  const auto status = backend_->execute();
  relocaliser_.assume(Belief::kSure);
  fragment_.setAside();
  events_.relocate("the robot was put there");
  dead_reckoning_.correct();
  doubt_.put(backend_->pose().pose);
  consistency_.add(statistics());
  return status;
}

/// What was judged until then was of another map.
Status Estimator::set(const MapState& map) {
  auto* keeper = capabilities_.find<MapKeeper>();
  if (keeper == nullptr) return Status::error("this back-end keeps no map that could be loaded");
  if (const auto fault = faultOf(map); !fault.empty())
    return Status::error(fault + "; all stays as it is");
  const auto used = takesLines() ? map : withoutLines(map);
  keeper->set(used);
  auto status = backend_->execute();
  if (status.level == Status::Level::kError) return status;
  if (used.landmarks.size() < map.landmarks.size())
    status = together(status, Status::warning("the map's lines are left out, since this back-end "
                                              "maps points only: use backend=ekf"));
  status = together(status, expected_.judge(used.landmarks));
  fragment_.setAside();
  events_.relocate("a map was loaded");
  dead_reckoning_.correct();
  dead_reckoning_.know(map.landmarks);
  doubt_.load(backend_->pose().pose);
  consistency_ = ConsistencyMonitor(consistency_config_);
  intake_.knowOnly(map.landmarks);
  return together(status, relocaliser_.assume(Belief::kUnconfirmed, &used));
}

Status Estimator::set(const SavedSession& session) {
  auto* keeper = capabilities_.find<SessionKeeper>();
  if (keeper == nullptr) return Status::error("this back-end keeps no session: use the graph");
  try {
    keeper->set(session);
  } catch (const std::runtime_error& error) {
    return Status::error(error.what());
  }
  const auto status = backend_->execute();
  if (status.level == Status::Level::kError) return status;
  events_.relocate("a session was loaded");
  dead_reckoning_.correct();
  doubt_.load(backend_->pose().pose);
  relocaliser_.reset();
  fragment_.setAside();
  consistency_ = ConsistencyMonitor(consistency_config_);
  const auto* mapper = capabilities_.find<LandmarkMapper>();
  const auto landmarks = mapper == nullptr ? LandmarkMap() : mapper->landmarks();
  intake_.knowOnly(landmarks);
  dead_reckoning_.know(landmarks);
  searchBy(relocaliser_, landmarks);
  return status;
}

Status merge(const SavedSession& session, const Estimator& estimator) {
  auto* merger = estimator.capabilities().find<SessionMerger>();
  if (merger == nullptr) return Status::error("this back-end merges no sessions: use the graph");
  try {
    merger->merge(session);
  } catch (const std::runtime_error& error) {
    return Status::error(error.what());
  }
  return Status::ok();
}

Status removeLandmark(LandmarkId id, const Estimator& estimator) {
  auto* remover = estimator.capabilities().find<LandmarkRemover>();
  if (remover == nullptr)
    return Status::error("this back-end removes no landmarks: use ekf, pf or graph");
  return remover->remove(id);
}

Status Estimator::startWith(SavedSession session) {
  start_session_ = std::move(session);
  return resetBackend();
}

Status Estimator::startWith(MapState map) {
  start_map_ = std::move(map);
  return resetBackend();
}

}  // namespace slam
