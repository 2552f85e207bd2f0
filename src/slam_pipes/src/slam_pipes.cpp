// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>
#include <filesystem>

#include "pipe_run.hpp"
#include "slam_ros/bag_run_arguments.hpp"
#include "slam_ros/command_line.hpp"

int main(int argc, char** argv) {
  // A process that has ended, and a file size limit, then show as write errors.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  slam_ros::CommandLine line(
      "slam_pipes", "Runs a SLAM product on a bag, each component a process, joined by pipes.");
  slam_pipes::RunOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "slam_part";
  slam_ros::BagRunArguments arguments;
  arguments.addTo(line, options);
  line.add("--out", options.folder, "the folder that takes the run's files").required();
  return line.run(argc, argv, [&] {
    arguments.complete(options);
    slam_pipes::PipeRun(options).run();
  });
}
