// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_choice.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {
namespace {

bool makes(const Backend& backend, const std::string& map) {
  const auto maps = backend.maps();
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
  if (makes(backend, product.map)) return backend.useMap(product.map);
  const std::string reason =
      product.map == "grid"
          ? ": a grid needs a non-parametric state representation, which can not be used with an "
            "EKF back-end"
          : "";
  throw ConfigError("map: the back-end '" + product.backend + "' makes no " + product.map + reason +
                    "; choose backend: " + join(backendsThatMake(product.map), " or ") +
                    ", or map: " + join(backend.maps(), " or "));
}

}  // namespace slam
