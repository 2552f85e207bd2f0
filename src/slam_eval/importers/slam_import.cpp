// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <vector>

#include "import_error.hpp"
#include "importer.hpp"
#include "slam_core/common/child_process.hpp"
#include "slam_core/common/nearest_name.hpp"

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

/// CLI11 only says that it did not expect the word.
/// @throw UsageError that names the formats, and the nearest one
void requireKnownFormat(int argc, char** argv,
                        const std::vector<std::unique_ptr<Importer>>& importers) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const auto& importer : importers) names.push_back(importer->name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  throw slam::eval::UsageError("there is no format '" + std::string(argv[1]) + "'" +
                               slam::didYouMean(argv[1], names) +
                               "; the formats are: " + slam::join(names));
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit then shows as a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Turns foreign logs into bags of the SLAM product line.", "slam_import");
  app.require_subcommand(1);
  std::vector<std::unique_ptr<Importer>> importers;
  importers.push_back(slam::eval::makeCarmenImporter());
  importers.push_back(slam::eval::makeCirclesImporter());
  importers.push_back(slam::eval::makeMrclamImporter());
  importers.push_back(slam::eval::makeRawlogImporter());
  importers.push_back(slam::eval::makeVictoriaParkImporter());
  std::string output;
  std::vector<CLI::App*> commands;
  for (const auto& importer : importers) {
    CLI::App* command = app.add_subcommand(importer->name(), importer->description());
    importer->addOptions(*command);
    command->add_option("OUT.bag", output, "the bag to write")->required();
    commands.push_back(command);
  }
  try {
    requireKnownFormat(argc, argv, importers);
    app.parse(argc, argv);
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (commands[i]->parsed()) return runGuarded(*importers[i], output);
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const slam::eval::UsageError& error) {
    return fail(error, 2);
  } catch (const std::exception& error) {
    return fail(error, 1);
  }
  return 2;
}
