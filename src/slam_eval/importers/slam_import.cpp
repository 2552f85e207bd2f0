// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <vector>

#include "import_error.hpp"
#include "importer.hpp"
#include "slam_core/common/child_process.hpp"
#include "slam_ros/command_line.hpp"

namespace {

using slam::Progress;
using slam::eval::BagWriter;
using slam::eval::Importer;

int runImport(Importer& importer, const std::string& output) {
  Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  BagWriter bag;
  const std::string summary = importer.import(bag, progress);
  bag.write(output, progress);
  std::printf("%s: %zu messages, %.1f s. %s\n", output.c_str(), bag.size(), bag.duration(),
              summary.c_str());
  return 0;
}

int fail(const std::exception& error, int code) {
  std::cerr << "slam_import: " << error.what() << std::endl;
  return code;
}

/// @return the exit code
int runAndTell(Importer& importer, const std::string& output) {
  try {
    return runImport(importer, output);
  } catch (const slam::eval::UsageError& error) {
    return fail(error, 2);
  } catch (const std::bad_alloc&) {
    return fail(slam::eval::ImportError("there is not enough memory for the log; is it damaged?"),
                1);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
}

/// Where a foreign library reads the log, all is done in a process of its own, which may crash.
int runGuarded(Importer& importer, const std::string& output) {
  constexpr std::uint64_t kMemory = 2ull << 30, kMemoryPerByte = 100, kBytesPerSecond = 1u << 16;
  const auto file = importer.fileOfLibrary();
  if (file.empty()) return runAndTell(importer, output);
  slam::eval::requireFile(file);
  const auto size = std::filesystem::file_size(file);
  std::fflush(stdout);
  slam::ChildProcess child({kMemory + kMemoryPerByte * size, 60 + size / kBytesPerSecond, false},
                           [&](int) {
                             const int code = runAndTell(importer, output);
                             std::fflush(stdout);
                             return code;
                           });
  const auto end = child.wait();
  if (end.crash.empty()) return end.exit_code;
  throw slam::eval::ImportError(file + " is damaged: reading it ends with " + end.crash);
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit then shows as a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  slam_ros::CommandLine line("slam_import",
                             "Turns foreign logs into bags of the SLAM product line.");
  std::vector<std::unique_ptr<Importer>> importers;
  importers.push_back(slam::eval::makeCarmenImporter());
  importers.push_back(slam::eval::makeCirclesImporter());
  importers.push_back(slam::eval::makeMrclamImporter());
  importers.push_back(slam::eval::makeRawlogImporter());
  importers.push_back(slam::eval::makeVictoriaParkImporter());
  std::string output;
  std::vector<slam_ros::CommandLine> commands;
  for (const auto& importer : importers) {
    auto& command = commands.emplace_back(importer->name(), importer->description());
    importer->addOptions(command);
    command.add("OUT.bag", output, "the bag to write").required();
    line.addCommand(command, "format");
  }
  return line.run(argc, argv, [&] {
    std::size_t chosen = 0;
    while (!commands[chosen].isChosen()) ++chosen;
    return runGuarded(*importers[chosen], output);
  });
}
