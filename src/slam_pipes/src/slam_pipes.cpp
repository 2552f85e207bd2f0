// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>

#include "pipe_run.hpp"
#include "slam_ros/command_line.hpp"

namespace {

void addOptions(CLI::App& app, slam_pipes::RunOptions& options, std::string& seed,
                std::string& origin) {
  app.add_option("PRODUCT", options.product, "a product's name, or its file")->required();
  app.add_option("--bag", options.bag, "the recorded data")->required();
  app.add_option("--out", options.folder, "the folder that takes the run's files")->required();
  app.add_option("--robot", options.robot, "a robot's name or file; default: the bag's");
  app.add_option("--seed", seed, "of every random stream; default: the product's");
  app.add_option("--set", options.overrides, "section.key=value, instead of the files' value");
  app.add_option("--remap", options.remaps, "input:=topic of the bag");
  app.add_option(
      "--origin", origin,
      "JSON that metrics.json and config.yaml get as `run`: version, bag, date, command");
}

}  // namespace

int main(int argc, char** argv) {
  // A process that has ended, and a file size limit, then show as write errors.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Runs a SLAM product on a bag, each component a process, joined by pipes.",
               "slam_pipes");
  slam_pipes::RunOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "slam_part";
  std::string seed, origin;
  addOptions(app, options, seed, origin);
  return slam_ros::runProgram(app, argc, argv, [&] {
    if (!seed.empty()) options.overrides.push_back("seed=" + seed);
    options.origin = slam_ros::RunOrigin(origin);
    slam_pipes::PipeRun(options).run();
  });
}
