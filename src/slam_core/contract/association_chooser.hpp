// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// The capability of a back-end whose policy of association can be chosen.
class AssociationChooser {
 public:
  virtual ~AssociationChooser() = default;
  /// Uses this policy from the next configure() on, which throws a ConfigError if the name is not
  /// known.
  /// @param policy one of association::policyNames()
  virtual void useAssociation(const std::string& policy) = 0;
};

}  // namespace slam
