// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <sys/prctl.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "exit_code.hpp"
#include "part_process.hpp"

namespace {

using slam_pipes::PartOptions;

/// "odometry=4"
PartOptions::Pipe pipeIn(const std::string& text) {
  const auto equals = text.find('=');
  int descriptor = -1;
  if (equals == std::string::npos ||
      !CLI::detail::lexical_cast(text.substr(equals + 1), descriptor))
    throw CLI::ValidationError("'" + text + "' is no pipe: write PART=DESCRIPTOR");
  return {text.substr(0, equals), descriptor};
}

struct PipeTexts {
  std::vector<std::string> from, to;
};

void addOptions(CLI::App& app, PartOptions& options, PipeTexts& pipes) {
  app.add_option("PRODUCT", options.product, "the product's file")->required();
  app.add_option("ROBOT", options.robot, "the robot's file")->required();
  app.add_option(
         "--part", options.part,
         "odometry, detector, second_detector, rear_detector, rear_second_detector, backend, or a "
         "module's name")
      ->required();
  app.add_option("--from", pipes.from, "PART=DESCRIPTOR of a pipe to read; PART may be bag");
  app.add_option("--to", pipes.to, "PART=DESCRIPTOR of a pipe to write");
  app.add_option("--set", options.overrides, "section.key=value, instead of the files' value");
  app.add_option("--status", options.status,
                 "descriptor of the pipe that takes reports; default: standard error");
  app.add_option("--out", options.folder, "the folder that takes the run's files");
  app.add_option("--without", options.without, "an input of the back-end without data");
}

int run(const PartOptions& options) {
  // A process that was stopped goes on when its starter dies: it finds its pipes closed and ends.
  if (options.status) ::prctl(PR_SET_PDEATHSIG, SIGCONT);
  slam_pipes::PartProcess process(options);
  try {
    process.run();
    return slam_pipes::kDone;
  } catch (const slam_pipes::PipeClosed& end) {
    if (!options.status) process.fail(end.what());
    return slam_pipes::kPipeClosed;
  } catch (const std::exception& error) {
    process.fail(error.what());
    return slam_pipes::kFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A pipe that nobody reads, and a file size limit, then show as write errors.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Runs one component of a SLAM product between pipes.", "slam_part");
  PartOptions options;
  PipeTexts pipes;
  addOptions(app, options, pipes);
  try {
    app.parse(argc, argv);
    for (const auto& text : pipes.from) options.from.push_back(pipeIn(text));
    for (const auto& text : pipes.to) options.to.push_back(pipeIn(text));
    return run(options);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    fmt::print(stderr, "slam_part: {}\n", error.what());
    return slam_pipes::kWrongUse;
  }
}
