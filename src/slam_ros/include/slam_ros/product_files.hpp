// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_ros/wrong_use.hpp"

namespace slam_ros {

/// A name for which there is no file; the message lists the names that exist.
class UnknownName : public WrongUse {
 public:
  using WrongUse::WrongUse;
};

/// The file of a product, given as a path or by its name: in slam_launch's products/, in the
/// folders that other packages export (an element `slam_launch` with the attribute `products` in
/// their package.xml), or in the user's own, ~/.config/slam/products. @throw UnknownName
std::string productFile(const std::string& name_or_path);

/// The same for a robot, in slam_launch's robots/.
std::string robotFile(const std::string& name_or_path);

/// The file `name`.yaml of a folder; a name that ends in .yaml or contains a slash is taken as a
/// path. `kind` ("product") is for the message. @throw UnknownName
std::string findConfigFile(const std::string& folder, const std::string& kind,
                           const std::string& name_or_path);
/// The same in several folders; the first one that has the name is used.
std::string findConfigFile(const std::vector<std::string>& folders, const std::string& kind,
                           const std::string& name_or_path);

}  // namespace slam_ros
