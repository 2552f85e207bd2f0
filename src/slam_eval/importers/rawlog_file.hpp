// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <vector>

#include "slam_core/common/progress.hpp"

namespace slam::eval {

/// The objects of an MRPT rawlog (gzip-compressed or not) in file order.
/// MRPT's own CRawlog takes a truncated file for a complete one; this reader does not.
/// @throw UsageError no such file; ImportError no rawlog, damaged or truncated
std::vector<mrpt::serialization::CSerializable::Ptr> readRawlogObjects(const std::string& path,
                                                                       Progress& progress);

}  // namespace slam::eval
