// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace slam_ros {

/// A name that stands for no file; the message lists those that there are.
class UnknownName : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file of a product, given by its name in slam_launch's products/ or as a path.
/// @throw UnknownName
std::string productFile(const std::string& name_or_path);

/// The same for robots/.
std::string robotFile(const std::string& name_or_path);

/// The file `name`.yaml of a folder; what ends in .yaml or holds a slash is a path already.
/// `kind` ("product") is for the message. @throw UnknownName
std::string findConfigFile(const std::string& folder, const std::string& kind,
                           const std::string& name_or_path);

}  // namespace slam_ros
