// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/backend_contract.hpp"

namespace slam::test {

INSTANTIATE_BACKEND_CONTRACTS(Toy, (std::vector<Variant>{{"toy", "toy", {}}}));

}  // namespace slam::test
