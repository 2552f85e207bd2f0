// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/contract/map_module.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/stage.hpp"
#include "slam_core/product/detector_place.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/wiring.hpp"

namespace slam {

/// What of a product runs in one place: in composition pubsub each nodelet runs a part.
struct ProductPart {
  enum class Extent { kWhole, kOdometry, kDetector, kStage, kBackend, kModule };

  Extent extent = Extent::kWhole;
  /// It names the component if this is not the one that the product names, and always names a stage
  /// or a module.
  std::string name;
  /// Where a product has several detectors, the prefix tells which one it is (DetectorPlace).
  std::string place = "";

  bool has(Extent role) const { return extent == Extent::kWhole || extent == role; }
};

/// A detector and where it stands in the product.
struct ProductDetector {
  DetectorPlace place;
  std::unique_ptr<LandmarkDetector> component;
};

/// A stage, and the product's keys that bring who takes in what it makes.
struct ProductStage {
  std::unique_ptr<Stage> component;
  std::vector<std::string> features;
};

/// Components that a product names, and the stages that these need.
struct ProductComponents {
  ProductConfig product;  ///< what names them
  FramesConfig frames;
  std::unique_ptr<OdometrySource> odometry;  ///< null in a product without
  std::vector<ProductDetector> detectors;    ///< the first one first
  std::vector<ProductStage> stages;          ///< makers before takers
  std::unique_ptr<Estimator> estimator;      ///< with the back-end
  std::map<std::string, std::unique_ptr<MapModule>> modules;
  bool is_complete = true;  ///< all components that the product names are known
};

/// A component of a product, and what it is called.
struct ProductComponent {
  std::string role;  ///< "odometry source"
  std::string key;   ///< "odometry", as the product's key that names it; of a module its name
  std::string name;  ///< in the registry
  Component* component = nullptr;
  std::vector<std::string> features;  ///< the product's keys that bring it
  bool takes_joined_scans = false;    ///< it takes those of two lasers in where it takes in scans

  /// "odometry source 'wheel'", for sentences
  std::string title() const { return role + " '" + name + "'"; }
};

/// The component's ports, with the names that they have in the product.
Ports portsOf(const ProductComponent& part);

/// Loads a product's libraries and creates all components that it names, without configuring them.
/// @throw ConfigError naming a library that cannot be loaded, or the components that there are
ProductComponents createComponents(const ProductConfig& product, const ProductPart& part = {});

/// The components that there are, in the order of the data's flow.
std::vector<ProductComponent> inOrder(const ProductComponents& parts);

/// Creates and configures a part of what the product names. What cannot be made is null.
/// @param faults takes those of all sections that the part reads
ProductComponents makeComponents(Settings& settings, const ProductPart& part,
                                 FaultCollector& faults);

/// Adds the components to a wiring, which refers to them.
/// @param is_whole of a whole product's components the counters have prefixes
void connect(ProductComponents& parts, bool is_whole, Wiring& wiring);

/// The ports of the components and of the gates before them, as a wiring of the whole has them.
/// @param parts outlive the result @throw ConfigError where two gates have one name
WiredPorts wiredPortsOf(const ProductComponents& parts);

/// The inputs of all components that the product names, or of a part of them, whoever makes the
/// data; of the same name and kind one, mandatory where it is so for anyone. Nothing is configured
/// for this. @throw ConfigError naming the components that there are
std::vector<InputPort> inputsOf(const ProductConfig& product, const ProductPart& part = {});

}  // namespace slam
