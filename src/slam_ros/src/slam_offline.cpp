// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <CLI/CLI.hpp>
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

void addOptions(CLI::App& app, slam_ros::OfflineOptions& options) {
  auto* out = app.add_option("--out", options.folder, "the folder that takes the run's files");
  app.add_option("--resume", options.folder, "the folder of a run that was cut off, to go on with")
      ->excludes(out);
  app.add_option("--autosave", options.autosave,
                 "seconds of stamps between the checkpoints that a run can be resumed from")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--load-map", options.load_map,
                 "a landmarks' file, a grid's yaml with its landmarks, or a folder, to start with");
  app.add_option("--load-session", options.load_session,
                 "a session to go on from, or to localise in with graph.mode=localization");
  app.add_option("--merge-session", options.merge_session,
                 "a session whose map is put onto this one when it is recognised");
  app.add_option("--save-session", options.save_session,
                 "the file that takes the session at the end, to go on from");
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit then shows as a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Runs a SLAM product on a bag as fast as it goes.", "slam_offline");
  slam_ros::OfflineOptions options;
  slam_ros::BagRunArguments arguments;
  arguments.addTo(app, options);
  addOptions(app, options);
  return slam_ros::runProgram(app, argc, argv, [&] {
    arguments.complete(options);
    options.resumes = app.count("--resume") > 0;
    if (options.folder.empty()) throw CLI::RequiredError("--out or --resume");
    if (options.autosave.value_or(0.0) > 0.0 || options.resumes) {
      stopOnSignals();
      options.is_stopped = [] { return is_stopped != 0; };
    }
    slam_ros::OfflineRun(options).run();
  });
}
