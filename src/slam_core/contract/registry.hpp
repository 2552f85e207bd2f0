// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/registration.hpp"

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

  /// A second component of the same name is refused only when the name is asked for, since static
  /// objects register before anybody can catch an exception.
  void add(const std::string& name, const Registration& registration, Factory factory) {
    const auto found = entries_.find(name);
    if (found == entries_.end() || found->second.registration.isSameAs(registration))
      entries_.insert_or_assign(name, Entry{registration, std::move(factory)});
    else
      faults_[name] = std::string(Role::kRole) + " '" + name + "' is there twice, as " +
                      found->second.registration.text() + " and as " + registration.text() +
                      "; leave one of the two libraries out of the product's `libraries`, or give "
                      "one of the components another name";
  }

  /// @throw ConfigError naming the role, the known names and the nearest one, or the two components
  /// that have this name
  std::unique_ptr<Role> create(const std::string& name) const {
    if (const auto fault = faults_.find(name); fault != faults_.end())
      throw ConfigError(fault->second);
    const auto found = entries_.find(name);
    if (found != entries_.end()) return found->second.factory();
    throw ConfigError(std::string(Role::kRole) + " '" + name +
                      "' is not known; there are: " + join(names()) + didYouMean(name, names()));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : entries_) names.push_back(entry.first);
    return names;
  }

 private:
  struct Entry {
    Registration registration;
    Factory factory;
  };

  std::map<std::string, Entry> entries_;
  std::map<std::string, std::string> faults_;  ///< by the name that two components have
};

/// A static object of this type in a component's source file registers the component.
template <class Role, class Component>
struct Registrar {
  /// @param file is filled in by the compiler
  explicit Registrar(const std::string& name, const char* file = __builtin_FILE()) {
    Registry<Role>::instance().add(name, Registration::of<Component>(file),
                                   [] { return std::make_unique<Component>(); });
  }
};

}  // namespace slam
