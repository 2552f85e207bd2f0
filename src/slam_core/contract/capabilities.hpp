// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <typeindex>
#include <utility>
#include <vector>

namespace slam {

/// What a back-end can do beyond stepping and reporting a pose. Each capability is a narrow
/// interface, which a back-end offers if it implements it. Topics, services, files and contract
/// suites follow from the capabilities.
class Capabilities {
 public:
  /// @param part the back-end or a part of it; it outlives this
  template <class Capability>
  void offer(Capability& part) {
    offers_.emplace_back(typeid(Capability), &part);
  }
  /// Null if it is not offered.
  template <class Capability>
  Capability* find() const {
    for (const auto& [type, part] : offers_)
      if (type == typeid(Capability)) return static_cast<Capability*>(part);
    return nullptr;
  }

 private:
  std::vector<std::pair<std::type_index, void*>> offers_;
};

}  // namespace slam
