// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/module_contract.hpp"

namespace slam::test {

INSTANTIATE_MODULE_CONTRACT(Toy, (std::vector<RoleVariant>{{"map_toy", "map_toy"}}));

}  // namespace slam::test
