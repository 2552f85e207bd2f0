// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/descriptor.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slam {

std::string faultOf(const Descriptor& descriptor) {
  constexpr float kLargest = 1e9F;  // the square of it is a number still
  const auto& [values, sigmas] = descriptor;
  if (values.size() > Descriptor::kMostElements || sigmas.size() > Descriptor::kMostElements)
    return fmt::format(" has a descriptor of more than {} elements", Descriptor::kMostElements);
  if (values.size() != sigmas.size())
    return fmt::format(" has a descriptor of {} elements and sigmas of {}", values.size(),
                       sigmas.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values(i)) || !std::isfinite(sigmas(i)))
      return " has a descriptor that holds a value that is not a number";
    if (!(sigmas(i) > 0.0F)) return " has a descriptor with a sigma that is not positive";
    if (std::abs(values(i)) > kLargest || sigmas(i) > kLargest || sigmas(i) < 1.0F / kLargest)
      return fmt::format(" has a descriptor beyond {:g}, or a sigma below {:g}", kLargest,
                         1.0F / kLargest);
  }
  return "";
}

}  // namespace slam
