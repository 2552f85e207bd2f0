// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nodelet/loader.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/ros.h>

#include <csignal>

// A nodelet manager that ends clean on Ctrl-C: it unloads the nodelets while ROS still runs, so
// that they complete their files and no thread meets a queue that is gone, and exits with 0.

namespace {

constexpr int kGraceRounds = 10;  // of 0.1 s

volatile std::sig_atomic_t stop = 0;

void onSignal(int) { stop = 1; }

void spinOnce() { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1)); }

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "slam_manager", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  ros::NodeHandle handle;  // keeps ROS up until the end
  {
    nodelet::Loader loader;
    while (stop == 0 && ros::ok()) spinOnce();
    // who loaded a nodelet mostly unloads it at the same signal; the loader calls it an error when
    // it is gone already, which it is when a bag's end was the signal
    ros::console::set_logger_level("ros.nodelet", ros::console::levels::Fatal);
    ros::console::notifyLoggerLevelsChanged();
    for (int i = 0; i < kGraceRounds && ros::ok() && !loader.listLoadedNodelets().empty(); ++i)
      spinOnce();
    loader.clear();
  }
  ros::shutdown();
  return 0;
}
