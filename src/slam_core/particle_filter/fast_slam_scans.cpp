// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <utility>

#include "slam_core/grid_map/grid_conversion.hpp"
#include "slam_core/particle_filter/fast_slam.hpp"

namespace slam::particle_filter {

void FastSlam::takeScan(Step& step) {
  if (!inputs_.scan) return;
  const auto scan = *std::exchange(inputs_.scan, std::nullopt);
  step.stamp = scan.stamp;
  if (scans_) step.scan = scans_->take(scan);
}

/// The particles stay where they are; what is told of them moves on.
Status FastSlam::carry(const Step& step) {
  auto& [pose, covariance] = told_.estimate;
  if (step.latest) {
    const auto& [increment, Q] = std::tie(step.latest->increment, step.latest->covariance);
    bound_.move(pose, *step.latest);
    Eigen::Matrix3d J_pose, J_u;
    pose = pose.compose(increment, &J_pose, &J_u);
    covariance = J_pose * covariance * J_pose.transpose() + J_u * Q * J_u.transpose();
  }
  if (step.stamp != Stamp())
    particles_->record(step.stamp, step.latest ? step.latest->increment : Pose2(), false);
  told_.statistics.landmarks = static_cast<int>(index_.size());
  return status(true);
}

void FastSlam::judgeScan(const Step& step) {
  if (!step.scan) return;
  const auto& best = particles_->best();
  scans_->judge(*step.scan, best.pose, best.grid);
  told_.figures["contradicting_ends"] = scans_->fit().contradictingShare();
}

void FastSlam::insertScan(Step& step) {
  if (!step.scan || mapIsFixed()) return;
  if (!scans_->hasRoomFor(*step.scan, particles_->size(), particles_->gridMemory())) {
    told_.grid_status = Status::warning(
        "the particles' grid maps would need more than grid_map.largest_memory and are kept as "
        "they are: raise it or grid_map.resolution, or lower pf.particles");
    told_.counters.add("scans_without_memory");
    return;
  }
  std::atomic<std::size_t> beyond{0};
  workers_->forEach(particles_->size(), [&](std::size_t i, unsigned) {
    auto& particle = (*particles_)[i];
    beyond += scans_->insert(*step.scan, particle.pose, particle.grid);
  });
  step.is_mapped = true;
  if (beyond == 0) return;
  told_.counters.add("beams_beyond_map", beyond);
  told_.grid_status = Status::warning(
      "beams end beyond the largest grid map, what lies there is not mapped: raise "
      "grid_map.largest_area");
}

grid_map::GridMap FastSlam::gridOf(const MapState& map) {
  auto grid = particles_->emptyGrid();
  if (!scans_) return grid;
  ++told_.grid_revision;
  if (!map.grid) return grid;
  told_.grid_status = fillFrom(*map.grid, scans_->model(), grid);
  return grid;
}

}  // namespace slam::particle_filter
