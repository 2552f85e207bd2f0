// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/contract/component.hpp"

namespace slam {

/// The role of an additional module (thesis 5.6): it makes something to look at from the data of
/// the sensors and the back-end, and has no effect on them. The key of the product that has its
/// name turns it on.
class MapModule : public Component {
 public:
  static constexpr const char* kRole = "additional module";

  /// What it makes, in one line.
  virtual std::string sentence() const = 0;
  /// Writes what it has made into a run's folder. @throw std::runtime_error naming the file
  virtual void save(const std::string& folder) const = 0;
};

}  // namespace slam
