// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/laser/scan_gate.hpp"
#include "slam_core/point_map/point_map.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// The components that a product names, configured.
struct ProductComponents {
  FramesConfig frames;
  std::unique_ptr<OdometrySource> odometry;
  std::unique_ptr<LandmarkDetector> detector;      ///< none where the product looks at no images
  ScanGate laser;                                  ///< of the scans, where the product uses them
  Estimator estimator;                             ///< with the back-end
  std::unique_ptr<point_map::PointMap> point_map;  ///< none where the product has none
};

/// Creates and configures what the product names.
/// @throw ConfigError listing the faults of all sections, those of unused components and leftovers
/// included
ProductComponents makeComponents(Settings& settings);

/// For who runs only a part of a product: finds the faults of the sections that others read.
/// @throw ConfigError as makeComponents()
inline void validateProduct(Settings& settings) { makeComponents(settings); }

/// The product's odometry source, not configured. @throw ConfigError naming those there are
std::unique_ptr<OdometrySource> makeOdometry(const ProductConfig& product);

/// The product's detector, not configured; nothing for "none".
/// @throw ConfigError naming those there are
std::unique_ptr<LandmarkDetector> makeDetector(const ProductConfig& product);

}  // namespace slam
