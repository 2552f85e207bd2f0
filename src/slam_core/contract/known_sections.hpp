// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <string>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/contract/registration.hpp"

namespace slam {

/// The configuration sections of all components that are loaded. One robot file serves every
/// product, and one product file several detectors. So a section whose component is not used is
/// allowed, and is checked like the others.
class KnownSections {
 public:
  static KnownSections& instance() {
    static KnownSections sections;
    return sections;
  }

  /// A function that gets a section's name and the fields of its configuration, with their
  /// defaults.
  using Visitor = std::function<void(const std::string&, const Fields&)>;

  /// Two configurations of one section are refused only when the sections are read or checked,
  /// since static objects register before anybody can catch an exception.
  template <class Config>
  void add(const char* file) {
    const std::string name = Config::kSection;
    const auto registration = Registration::of<Config>(file);
    const auto found = sections_.find(name);
    if (found != sections_.end() && !found->second.registration.isSameAs(registration)) {
      faults_[name] = "the section " + name + " is read in two ways, as " +
                      found->second.registration.text() + " and as " + registration.text() +
                      "; leave one of the two libraries out of the product's `libraries`, or give "
                      "one of the sections another name";
      return;
    }
    sections_.insert_or_assign(
        name, Section{registration, [](Settings& settings) { settings.checkUnused<Config>(); },
                      [](Settings& settings) { settings.read<Config>(); },
                      [](const Visitor& visit) { visitSection<Config>(visit); }});
  }

  /// Visits all sections in the order of their names.
  void visit(const Visitor& visit) const {
    for (const auto& entry : sections_) entry.second.show(visit);
  }

  template <class Config>
  static void visitSection(const Visitor& visit) {
    Config config;
    Fields fields;
    config.describe(fields);
    visit(Config::kSection, fields);
  }

  /// Reads the sections of all components, used or not, with their overrides, to check files
  /// without running anything. @throw ConfigError listing the faults of all of them
  void readAll(Settings& settings) const {
    auto faults = this->faults();
    for (const auto& entry : sections_) faults.attempt([&] { entry.second.read(settings); });
    faults.raise();
  }

  /// To be called when all components of a product have read their sections.
  /// @throw ConfigError listing the faults of the sections that no component has read
  void checkUnused(Settings& settings) const {
    auto faults = this->faults();
    for (const auto& entry : sections_) faults.attempt([&] { entry.second.check(settings); });
    faults.raise();
  }

 private:
  struct Section {
    Registration registration;
    std::function<void(Settings&)> check;
    std::function<void(Settings&)> read;
    std::function<void(const Visitor&)> show;
  };

  FaultCollector faults() const {
    FaultCollector faults;
    for (const auto& entry : faults_) faults.add(entry.second);
    return faults;
  }

  std::map<std::string, Section> sections_;
  std::map<std::string, std::string> faults_;  ///< by the section that two configurations have
};

/// A static object of this type beside a component's Registrar declares a section it reads.
template <class Config>
struct SectionRegistrar {
  /// @param file is filled in by the compiler
  explicit SectionRegistrar(const char* file = __builtin_FILE()) {
    KnownSections::instance().add<Config>(file);
  }
};

}  // namespace slam
