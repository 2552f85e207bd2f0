// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/product_components.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

ProductComponents makeComponents(Settings& settings) {
  ProductConfig product;
  ProductComponents parts;
  FaultCollector faults;
  faults.attempt([&] { settings.read(product); });
  faults.attempt([&] { loadLibraries(product.libraries); });
  faults.attempt([&] {
    parts.frames = settings.read<FramesConfig>();
    parts.frames.requireDistinctNames();
  });
  std::unique_ptr<Backend> backend;
  faults.attempt([&] { parts.odometry = makeOdometry(product); });
  faults.attempt([&] { parts.detector = makeDetector(product); });
  faults.attempt([&] { backend = Registry<Backend>::instance().create(product.backend); });
  // else nobody knows which sections are left over
  const bool complete = parts.odometry && backend && (parts.detector || !product.usesImages());
  if (parts.odometry)
    faults.attempt([&] {
      parts.odometry->configure(settings);
      parts.odometry->seed(product.seed);
    });
  if (parts.detector) faults.attempt([&] { parts.detector->configure(settings); });
  faults.attempt([&] { parts.laser.configure(settings.read<LaserConfig>()); });
  if (product.pointmap)
    faults.attempt([&] {
      parts.point_map = std::make_unique<point_map::PointMap>();
      parts.point_map->configure(settings);
    });
  if (backend) faults.attempt([&] { parts.estimator.configure(settings, std::move(backend)); });
  if (complete) {
    faults.attempt([&] { KnownSections::instance().checkUnused(settings); });
    faults.attempt([&] { settings.requireAllRead(); });
  }
  faults.raise();
  return parts;
}

std::unique_ptr<OdometrySource> makeOdometry(const ProductConfig& product) {
  return Registry<OdometrySource>::instance().create(product.odometry);
}

std::unique_ptr<LandmarkDetector> makeDetector(const ProductConfig& product) {
  if (!product.usesImages()) return nullptr;
  const auto& registry = Registry<LandmarkDetector>::instance();
  try {
    return registry.create(product.detector);
  } catch (const ConfigError& error) {
    throw ConfigError(std::string(error.what()) + "; 'none' looks at no images");
  }
}

}  // namespace slam
