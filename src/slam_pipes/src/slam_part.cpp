// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sys/prctl.h>

#include <charconv>
#include <csignal>

#include "exit_code.hpp"
#include "part_process.hpp"
#include "slam_ros/command_line.hpp"

namespace {

using slam_pipes::PartOptions;

/// "odometry=4"
PartOptions::Pipe pipeIn(const std::string& text) {
  const auto begin = text.find('=') + 1;  // 0 where there is none
  const char* const end = text.data() + text.size();
  int descriptor = -1;
  const auto read = std::from_chars(text.data() + begin, end, descriptor);
  if (begin == 0 || read.ec != std::errc() || read.ptr != end)
    throw slam_ros::WrongUse("'" + text + "' is no pipe: write PART=DESCRIPTOR");
  return {text.substr(0, begin - 1), descriptor};
}

struct PipeTexts {
  std::vector<std::string> from, to;
};

void addOptions(slam_ros::CommandLine& line, PartOptions& options, PipeTexts& pipes) {
  line.add("PRODUCT", options.product, "the product's file").required();
  line.add("ROBOT", options.robot, "the robot's file").required();
  line.add(
          "--part", options.part,
          "odometry, detector, second_detector, rear_detector, rear_second_detector, backend, or a "
          "module's name")
      .required();
  line.add("--from", pipes.from, "PART=DESCRIPTOR of a pipe to read; PART may be bag");
  line.add("--to", pipes.to, "PART=DESCRIPTOR of a pipe to write");
  line.add("--set", options.overrides, "section.key=value, instead of the files' value");
  line.add("--status", options.status,
           "descriptor of the pipe that takes reports; default: standard error");
  line.add("--out", options.folder, "the folder that takes the run's files");
  line.add("--without", options.without, "an input of the back-end without data");
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
  slam_ros::CommandLine line("slam_part", "Runs one component of a SLAM product between pipes.");
  PartOptions options;
  PipeTexts pipes;
  addOptions(line, options, pipes);
  return line.run(argc, argv, [&]() -> int {
    for (const auto& text : pipes.from) options.from.push_back(pipeIn(text));
    for (const auto& text : pipes.to) options.to.push_back(pipeIn(text));
    return run(options);
  });
}
