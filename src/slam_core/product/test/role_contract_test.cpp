// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/test/detector_contract.hpp"
#include "slam_core/product/test/module_contract.hpp"
#include "slam_core/product/test/odometry_contract.hpp"

namespace slam::test {

INSTANTIATE_ODOMETRY_CONTRACT(All,
                              (std::vector<RoleVariant>{
                                  {"wheel", "wheel"}, {"command", "command"}, {"laser", "laser"}}));
INSTANTIATE_DETECTOR_CONTRACT(All, (std::vector<RoleVariant>{{"laser_corners", "corners"},
                                                             {"laser_lines", "lines"}}));
INSTANTIATE_MODULE_CONTRACT(All, (std::vector<RoleVariant>{{"pointmap", "pointmap"}}));

}  // namespace slam::test
