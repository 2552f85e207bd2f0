// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <csignal>

#include "slam_ros/bag_run_arguments.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/offline_run.hpp"

namespace {

volatile std::sig_atomic_t is_stopped = 0;

/// The run is saved at the next message and ends; a second signal ends it at once.
void stopOnSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, [](int number) {
      is_stopped = 1;
      std::signal(number, SIG_DFL);
    });
}

void addOptions(slam_ros::CommandLine& line, slam_ros::OfflineOptions& options,
                std::string& resumed) {
  const auto out = line.add("--out", options.folder, "the folder that takes the run's files");
  line.add("--resume", resumed, "the folder of a run that was cut off, to go on with")
      .excludes(out);
  line.add("--autosave", options.autosave,
           "seconds of stamps between the checkpoints that a run can be resumed from")
      .nonNegative();
  line.add("--load-map", options.load_map,
           "a landmarks' file, a grid's yaml with its landmarks, or a folder, to start with");
  line.add("--load-session", options.load_session,
           "a session to go on from, or to localise in with graph.mode=localization");
  line.add("--merge-session", options.merge_session,
           "a session whose map is put onto this one when it is recognised");
  line.add("--save-session", options.save_session,
           "the file that takes the session at the end, to go on from");
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit then shows as a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  slam_ros::CommandLine line("slam_offline", "Runs a SLAM product on a bag as fast as it goes.");
  slam_ros::OfflineOptions options;
  std::string resumed;
  slam_ros::BagRunArguments arguments;
  arguments.addTo(line, options);
  addOptions(line, options, resumed);
  return line.run(argc, argv, [&] {
    arguments.complete(options);
    options.resumes = !resumed.empty();
    if (options.resumes) options.folder = resumed;
    if (options.folder.empty())
      throw slam_ros::WrongUse("--out or --resume is required; --help lists the options");
    if (options.autosave.value_or(0.0) > 0.0 || options.resumes) {
      stopOnSignals();
      options.is_stopped = [] { return is_stopped != 0; };
    }
    slam_ros::OfflineRun(options).run();
  });
}
