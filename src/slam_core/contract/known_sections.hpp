// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <string>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/settings.hpp"

namespace slam {

/// The configuration sections of all components there are. One robot file serves every product, and
/// one product file several detectors: a section whose component is not used is no leftover, but it
/// is checked like the others.
class KnownSections {
 public:
  static KnownSections& instance() {
    static KnownSections sections;
    return sections;
  }

  template <class Config>
  void add() {
    checks_[Config::kSection] = [](Settings& settings) { settings.checkUnused<Config>(); };
  }

  /// To be called when all components of a product have read theirs.
  /// @throw ConfigError listing the faults of the sections that nobody has read
  void checkUnused(Settings& settings) const {
    FaultCollector faults;
    for (const auto& entry : checks_) faults.attempt([&] { entry.second(settings); });
    faults.raise();
  }

 private:
  std::map<std::string, std::function<void(Settings&)>> checks_;
};

/// A static object of this type beside a component's Registrar declares a section it reads.
template <class Config>
struct SectionRegistrar {
  SectionRegistrar() { KnownSections::instance().add<Config>(); }
};

}  // namespace slam
