// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/product_files.hpp"

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

/// Reads the command line and calls `run`; what they throw is reported in one sentence.
/// @return the program's exit code: 0, 1 where it failed, 2 for wrong use
template <class Run>
int runProgram(CLI::App& app, int argc, char** argv, Run run) {
  constexpr int kFailed = 1, kWrongUse = 2;
  const auto fail = [&](const std::string& sentence, int code) {
    std::cerr << app.get_name() << ": " << sentence << std::endl;
    return code;
  };
  try {
    app.parse(argc, argv);
    run();
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(sentenceOf(app, error), kWrongUse);
  } catch (const UnknownName& error) {
    return fail(error.what(), kWrongUse);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
  return 0;
}

}  // namespace slam_ros
