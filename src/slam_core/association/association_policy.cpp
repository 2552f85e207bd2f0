// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/association_policy.hpp"

#include "slam_core/contract/registry.hpp"

namespace slam::association {

std::vector<std::string> policyNames() { return Registry<AssociationPolicy>::instance().names(); }

std::unique_ptr<AssociationPolicy> makePolicy(const std::string& name, const PolicyConfig& config) {
  auto policy = Registry<AssociationPolicy>::instance().create(name);
  policy->configure(config);
  return policy;
}

}  // namespace slam::association
