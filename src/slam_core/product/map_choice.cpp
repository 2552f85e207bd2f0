// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_choice.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {
namespace {

/// What a back-end can make. One that does not choose makes a grid where that is all it offers,
/// else point landmarks.
std::vector<MapKind> mapsOf(Backend& backend) {
  const auto capabilities = capabilitiesOf(backend);
  if (const auto* chooser = capabilities.find<MapChooser>()) return chooser->maps();
  const bool makes_grid_alone =
      capabilities.find<GridMapper>() != nullptr && capabilities.find<LandmarkMapper>() == nullptr;
  return {makes_grid_alone ? MapKind::kGrid : MapKind::kLandmarks};
}

std::vector<std::string> namesOfMaps(Backend& backend) {
  std::vector<std::string> names;
  for (const auto map : mapsOf(backend)) names.push_back(nameOf(map, mapKindNames()));
  return names;
}

bool makes(Backend& backend, MapKind map) {
  const auto maps = mapsOf(backend);
  return std::find(maps.begin(), maps.end(), map) != maps.end();
}

std::vector<std::string> backendsThatMake(MapKind map) {
  std::vector<std::string> able;
  const auto& registry = Registry<Backend>::instance();
  for (const auto& name : registry.names())
    if (makes(*registry.create(name), map)) able.push_back(name);
  return able;
}

}  // namespace

void chooseMap(const ProductConfig& product, Backend& backend) {
  if (makes(backend, product.map)) {
    if (auto* chooser = capabilitiesOf(backend).find<MapChooser>()) chooser->useMap(product.map);
    return;
  }
  const std::string reason =
      product.map == MapKind::kGrid
          ? ": a grid needs a non-parametric state representation, which can not be used with an "
            "EKF back-end"
          : "";
  throw ConfigError("map: the back-end '" + product.backend + "' makes no " +
                    nameOf(product.map, mapKindNames()) + reason +
                    "; choose backend: " + join(backendsThatMake(product.map), " or ") +
                    ", or map: " + join(namesOfMaps(backend), " or "));
}

}  // namespace slam
