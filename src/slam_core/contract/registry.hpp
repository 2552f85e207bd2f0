// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"

namespace slam {

/// The components of one role by name. A component registers itself from its own library, so that
/// adding one edits no existing file; linking or loading the library is enough.
template <class Role>
class Registry {
 public:
  using Factory = std::function<std::unique_ptr<Role>()>;

  static Registry& instance() {
    static Registry registry;
    return registry;
  }

  void add(const std::string& name, Factory factory) { factories_[name] = std::move(factory); }

  /// @throw ConfigError naming the role, the known names and the nearest one
  std::unique_ptr<Role> create(const std::string& name) const {
    const auto found = factories_.find(name);
    if (found != factories_.end()) return found->second();
    throw ConfigError(std::string(Role::kRole) + " '" + name +
                      "' is not known; there are: " + join(names()) + didYouMean(name, names()));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : factories_) names.push_back(entry.first);
    return names;
  }

 private:
  std::map<std::string, Factory> factories_;
};

/// A static object of this type in a component's source file registers the component.
template <class Role, class Component>
struct Registrar {
  explicit Registrar(const std::string& name) {
    Registry<Role>::instance().add(name, [] { return std::make_unique<Component>(); });
  }
};

}  // namespace slam
