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

/// Of a back-end that does not choose: a grid where that is all it makes, else point landmarks.
std::vector<std::string> mapsOf(Backend& backend) {
  const auto capabilities = capabilitiesOf(backend);
  if (const auto* chooser = capabilities.find<MapChooser>()) return chooser->maps();
  const bool makes_grid_alone =
      capabilities.find<GridMapper>() != nullptr && capabilities.find<LandmarkMapper>() == nullptr;
  return {makes_grid_alone ? "grid" : "landmarks"};
}

bool makes(Backend& backend, const std::string& map) {
  const auto maps = mapsOf(backend);
  return std::find(maps.begin(), maps.end(), map) != maps.end();
}

std::vector<std::string> backendsThatMake(const std::string& map) {
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
      product.map == "grid"
          ? ": a grid needs a non-parametric state representation, which can not be used with an "
            "EKF back-end"
          : "";
  throw ConfigError("map: the back-end '" + product.backend + "' makes no " + product.map + reason +
                    "; choose backend: " + join(backendsThatMake(product.map), " or ") +
                    ", or map: " + join(mapsOf(backend), " or "));
}

}  // namespace slam
