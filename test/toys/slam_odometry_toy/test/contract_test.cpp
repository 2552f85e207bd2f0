// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/odometry_contract.hpp"

namespace slam::test {

INSTANTIATE_ODOMETRY_CONTRACT(Toy, (std::vector<RoleVariant>{{"toy", "toy"}}));

}  // namespace slam::test
