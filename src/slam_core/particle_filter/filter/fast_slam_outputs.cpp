// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/particle_filter/particles/mixture.hpp"

namespace slam::particle_filter {

void FastSlam::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier();
  auto& observations = ports.takes<LandmarkObservationArray>("observations", "landmarks", &inputs_);
  if (!uses_grid_) return;
  observations.optional();
  ports.takes<LaserScan>("scan", "laser scans", &inputs_);
}

void FastSlam::describe(Capabilities& capabilities) {
  capabilities.offer<LandmarkMapper>(*this);
  capabilities.offer<LandmarkRemover>(*this);
  if (uses_grid_) capabilities.offer<CorrectionReporter>(*this);
  if (uses_grid_) capabilities.offer<GridMapper>(*this);
  if (uses_grid_) capabilities.offer<LostReporter>(*this);
  capabilities.offer<PoseSampler>(*this);
  capabilities.offer<PathReviser>(*this);
  capabilities.offer<MapKeeper>(*this);
  capabilities.offer<MapChooser>(*this);
  capabilities.offer<AssociationChooser>(*this);
}

Component::Figures FastSlam::figures() const {
  Figures figures(account_.figures.begin(), account_.figures.end());
  if (!scans_) return figures;
  const auto& doubt = scans_->doubt();
  figures.emplace_back("contradicting_ends", doubt.agreement().contradictingShare());
  figures.emplace_back("lost_statistic", doubt.statistic());
  figures.emplace_back("lost_for_s", seconds(doubt.lostFor()));
  return figures;
}

std::optional<Stamp> FastSlam::lostSince() const {
  return scans_ ? scans_->doubt().lostSince() : std::nullopt;
}

/// By a scan; the particles' spread and MapDrift have the errors of the map.
std::optional<Stamp> FastSlam::correctedBy() const {
  return is_corrected_ ? std::optional(Stamp()) : std::nullopt;
}

PoseEstimate FastSlam::pose() const {
  const auto& estimate = belief_.estimate;
  return tellsBest() ? about(best().pose * carriedIncrement(), estimate) : estimate;
}

Landmark FastSlam::landmark(std::size_t number) const {
  const auto id = landmarks_.index().id(number);
  if (config_.map == ToldMap::kMixture) return mixtureOf(*particles_, number, id);
  return mixtureAbout(find(number, best().map)->mean(), *particles_, number, id);
}

/// The landmarks that the most likely particle has.
std::vector<std::size_t> FastSlam::toldLandmarks() const {
  auto numbers = landmarks_.index().numbersById();
  const auto is_unknown = [&](std::size_t number) { return find(number, best().map) == nullptr; };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_unknown), numbers.end());
  return numbers;
}

std::size_t FastSlam::landmarksInMap() const {
  return landmarks_.index().hasRetired() ? toldLandmarks().size() : best().map.size();
}

LandmarkMap FastSlam::landmarks() const {
  LandmarkMap map;
  map.reserve(best().map.size());
  for (const auto number : toldLandmarks()) {
    map.push_back(landmark(number));
    map.back().covariance = belief_.bound.told(map.back().covariance, number);
  }
  landmarks_.descriptors().describe(map);
  return map;
}

/// Of a map to localise in counts how its landmarks lie to one another, not what all of them have
/// in common, which the bound holds and nobody could tell apart any more.
MapState FastSlam::state() const {
  MapState state{pose(), {}, {}, grid()};
  for (const auto number : toldLandmarks()) state.landmarks.push_back(landmark(number));
  landmarks_.descriptors().describe(state.landmarks);
  return state;
}

std::optional<OccupancyGrid> FastSlam::grid() const {
  if (!scans_) return std::nullopt;
  return occupancyGridOf(best().grid, scans_->models().front().resolution());
}

std::vector<StampedPose> FastSlam::path() const {
  auto poses = best().path.poses(best().pose * carriedIncrement());
  // landmarks and a scan of the same stamp are two steps, of which the second knows more
  const auto is_outdone = [](const StampedPose& later, const StampedPose& earlier) {
    return later.stamp == earlier.stamp;
  };
  const auto kept = std::unique(poses.rbegin(), poses.rend(), is_outdone);
  poses.erase(poses.begin(), kept.base());
  return poses;
}

std::vector<Pose2> FastSlam::particles() const {
  std::vector<Pose2> poses;
  poses.reserve(particles_->size());
  for (std::size_t i = 0; i < particles_->size(); ++i)
    poses.push_back((*particles_)[i].pose * carriedIncrement());
  return poses;
}

}  // namespace slam::particle_filter
