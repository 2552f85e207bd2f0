// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_ros/wrong_use.hpp"

namespace slam_ros {

/// A name that stands for no file; the message lists those that there are.
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

/// The file `name`.yaml of a folder; what ends in .yaml or holds a slash is a path already.
/// `kind` ("product") is for the message. @throw UnknownName
std::string findConfigFile(const std::string& folder, const std::string& kind,
                           const std::string& name_or_path);
/// The same in several folders; the first that has the name counts.
std::string findConfigFile(const std::vector<std::string>& folders, const std::string& kind,
                           const std::string& name_or_path);

}  // namespace slam_ros
