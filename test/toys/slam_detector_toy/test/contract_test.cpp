// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/detector_contract.hpp"

namespace slam::test {

INSTANTIATE_DETECTOR_CONTRACT(Toy, (std::vector<RoleVariant>{{"toy", "toy"}}));

}  // namespace slam::test
