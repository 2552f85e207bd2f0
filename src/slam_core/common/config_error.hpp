// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam {

/// All that is wrong with a configuration, a sentence each.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(std::vector<std::string> faults)
      : std::runtime_error(join(faults, "\n")), faults_(std::move(faults)) {}
  explicit ConfigError(const std::string& fault) : ConfigError(std::vector<std::string>{fault}) {}

  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

/// Runs several steps of a configuration and throws the faults of all of them at once.
class FaultCollector {
 public:
  template <class Step>
  void attempt(Step&& step) {
    try {
      step();
    } catch (const ConfigError& error) {
      for (const auto& fault : error.faults()) add(fault);
    }
  }
  /// A fault that is there already counts once: several components may read one section.
  void add(const std::string& fault) {
    if (std::find(faults_.begin(), faults_.end(), fault) == faults_.end()) faults_.push_back(fault);
  }
  bool isEmpty() const { return faults_.empty(); }
  /// @throw ConfigError when there was any fault
  void raise() const {
    if (!faults_.empty()) throw ConfigError(faults_);
  }

 private:
  std::vector<std::string> faults_;
};

}  // namespace slam
