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

/// Publishes the output of an additional module. All calls come from the thread of the module,
/// which outlives this.
class ModulePublisher {
 public:
  struct Context {
    ros::NodeHandle handle;  ///< the product's namespace
    std::string map_frame;
    double rate;  ///< at most [1/s of stamps]
  };

  virtual ~ModulePublisher() = default;
  /// To be called when the module may have changed: publishes if it is time.
  virtual void update() = 0;
};

/// The registry of publishers. A publisher registers itself beside its class, so that a package can
/// bring one for its own module.
class ModulePublishers {
 public:
  /// Returns null for a module that it does not know.
  using Factory = std::function<std::unique_ptr<ModulePublisher>(
      const slam::MapModule& module, const ModulePublisher::Context& context)>;

  static ModulePublishers& instance();
  void add(Factory factory) { factories_.push_back(std::move(factory)); }
  /// Null if nothing of the module is to be published.
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
