// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam {

/// What a section's fields may be, as a table in Markdown: name, default (the value in force),
/// unit, type, allowed values and sentence. Where some fields belong in a product file and some in
/// a robot file, a column says which.
std::string parameterTable(const Fields& fields);

/// "product", "robot" or "product, robot": the files that the fields belong in.
std::string filesOf(const Fields& fields);

}  // namespace slam
