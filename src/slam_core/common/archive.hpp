// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/archive_reader.hpp"
#include "slam_core/common/archive_writer.hpp"

// Archives hold the state of objects bit by bit, so that who reads one goes on as if never
// stopped. A class with state lists its members once, for writing and reading alike:
//
//     template <class Archive>
//     void persist(Archive& archive) {
//       archive(mean_, covariance_);
//     }
//
// What a configuration says is not listed: who reads was configured in the same way. Known are
// numbers, enumerations, strings, the containers of the standard library, Eigen's matrices and
// classes that have persist(). Objects that std::shared_ptr share are written once and are shared
// again by those who read. Unordered containers are written sorted.
