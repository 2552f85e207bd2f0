// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/backend_contract.hpp"

#include <memory>

#include "slam_core/mono_ekf/test/room_drive.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"
#include "slam_core/rat/test/circle_of_views.hpp"

namespace slam::test {
namespace {

/// All that are registered, those of the EKF's settings that change how it works, and what the
/// particle filter does with a grid.
std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const auto& name : Registry<Backend>::instance().names()) all.push_back({name, name, {}});
  for (auto& variant : all) {
    if (variant.backend == "mono_ekf")  // which is driven by images
      variant.drive = [](std::uint64_t seed) { return std::make_unique<RoomWithView>(seed); };
    if (variant.backend == "mono_graph")  // so is this one
      variant.drive = [](std::uint64_t seed) { return std::make_unique<RoundOfPictures>(seed); };
    if (variant.backend == "rat")  // which is driven by pose cells
      variant.drive = [](std::uint64_t seed) { return std::make_unique<CircleOfViews>(seed); };
  }
  for (const std::string linearization :
       {"textbook", "first_estimates", "observability_constrained", "right_invariant"})
    all.push_back({"ekf", "ekf_" + linearization, {"ekf.linearization=" + linearization}});
  all.push_back({"ekf", "ekf_unscented", {"ekf.filter=unscented"}});
  all.push_back({"ekf", "ekf_dense", {"ekf.update=dense"}});
  all.push_back({"ekf", "ekf_neighbourhood_of_one", {"ekf.neighbourhood=1"}});
  all.push_back(
      {"pf", "pf_grid", {"pf.particles=8", "pf.resampling_threshold=0.5"}, MapKind::kGrid});
  all.push_back({"seif", "seif_of_short_intervals",
                 {"seif.active_landmarks=4", "seif.interval_nodes=8"}});
  all.push_back({"graph", "graph_grid", {}, MapKind::kGrid});
  return all;
}

INSTANTIATE_BACKEND_CONTRACTS(All, variants());

}  // namespace
}  // namespace slam::test
