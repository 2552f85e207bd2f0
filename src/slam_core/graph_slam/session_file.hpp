// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/graph_slam/session.hpp"

namespace slam::graph_slam {

/// A session as the bytes of a file, the same for the same session: the magic "SLAMGRPH", the
/// version (32 bits), the length of the content (64 bits), the content, and the CRC-64/XZ of all
/// before it. Where scans are joined ones, what the further lasers saw follows the records of all
/// else; the sessions of a robot with one laser end there. Numbers are little-endian, doubles IEEE
/// 754 to the bit. docs/graph.md tells more.
std::string bytesOf(const Session& session);

/// @throw std::runtime_error with what is wrong with the bytes and what to do, to stand behind the
/// file's name ("it is cut: ...")
Session sessionOf(const std::string& bytes);

/// Replaces the file as a whole. @throw std::runtime_error with a sentence
void writeSession(const std::string& path, const Session& session);
/// @throw std::runtime_error with a sentence that names the file
Session readSession(const std::string& path);

}  // namespace slam::graph_slam
