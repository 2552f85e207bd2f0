// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/map_module.hpp"

namespace slam_ros {

/// Publishes what an additional module has made. All calls come from the thread of the module,
/// which outlives this.
class ModulePublisher {
 public:
  struct Context {
    ros::NodeHandle handle;  ///< the product's namespace
    std::string map_frame;
    double rate;  ///< at most [1/s of stamps]
  };

  virtual ~ModulePublisher() = default;
  /// The module may have changed: publishes when it is time.
  virtual void update() = 0;
};

/// The publishers there are. One registers itself beside its class, so that a package brings one
/// for a module of its own.
class ModulePublishers {
 public:
  /// Null where the module is none that it knows.
  using Factory = std::function<std::unique_ptr<ModulePublisher>(
      const slam::MapModule& module, const ModulePublisher::Context& context)>;

  static ModulePublishers& instance();
  void add(Factory factory) { factories_.push_back(std::move(factory)); }
  /// Null where nothing is to be published of the module.
  std::unique_ptr<ModulePublisher> create(const slam::MapModule& module,
                                          const ModulePublisher::Context& context) const;

 private:
  std::vector<Factory> factories_;
};

/// A static object of this type registers a publisher with the constructor (Module, context).
template <class Module, class Publisher>
struct ModulePublisherRegistrar {
  ModulePublisherRegistrar() {
    ModulePublishers::instance().add(
        [](const auto& module, const auto& context) -> std::unique_ptr<ModulePublisher> {
          const auto* known = dynamic_cast<const Module*>(&module);
          return known == nullptr ? nullptr : std::make_unique<Publisher>(*known, context);
        });
  }
};

}  // namespace slam_ros
