// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {

/// One sentence for a command line that cannot be read: an option that does not exist is named with
/// the one that was meant, not with the words that followed from it.
inline std::string sentenceOf(const CLI::App& app, const CLI::ParseError& error) {
  constexpr const char* kHint = "; --help lists the options";
  std::vector<std::string> names;
  for (const auto* option : app.get_options()) names.push_back(option->get_name());
  for (const auto& extra : app.remaining()) {
    const auto option = extra.substr(0, extra.find('='));
    if (option.rfind("--", 0) == 0)
      return "there is no option " + option + slam::didYouMean(option, names) + kHint;
  }
  return error.what() + std::string(kHint);
}

}  // namespace slam_ros
