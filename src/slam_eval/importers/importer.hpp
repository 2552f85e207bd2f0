// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "bag_writer.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_ros/command_line.hpp"

namespace slam::eval {

/// One foreign log format, a sub-command of slam_import.
///
/// The program calls addOptions() once before the command line is parsed, and import() once after
/// it if the sub-command was chosen. An importer reads its input into messages and leaves writing
/// the bag to the program.
class Importer {
 public:
  virtual ~Importer() = default;

  /// The sub-command, e.g. "mrclam".
  virtual std::string name() const = 0;

  /// One line for --help.
  virtual std::string description() const = 0;

  /// Declares the input's positional argument and the format's own options.
  virtual void addOptions(slam_ros::CommandLine& command) = 0;

  /// The file that a foreign library reads, which may crash where it is damaged; empty where none
  /// does. After the command line is parsed.
  virtual std::string fileOfLibrary() const { return ""; }

  /// Reads the input and adds all its messages to the bag.
  /// @return what was read and what was left out, sentences for the summary
  /// @throw UsageError, ImportError
  virtual std::string import(BagWriter& bag, Progress& progress) = 0;
};

std::unique_ptr<Importer> makeCarmenImporter();
std::unique_ptr<Importer> makeCirclesImporter();
std::unique_ptr<Importer> makeMrclamImporter();
std::unique_ptr<Importer> makeRawlogImporter();
std::unique_ptr<Importer> makeVictoriaParkImporter();

}  // namespace slam::eval
