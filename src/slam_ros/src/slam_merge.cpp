// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <iostream>

#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/graph_slam/session_merge.hpp"
#include "slam_ros/command_line.hpp"

namespace {

namespace graph_slam = slam::graph_slam;

struct Options {
  std::string first, second, out;
};

void merge(const Options& options) {
  const auto first = graph_slam::readSession(options.first);
  const auto second = graph_slam::readSession(options.second);
  graph_slam::ScanSettings settings;
  if (first.kind.has_grid) settings.grid.resolution = first.kind.resolution;
  const auto goes_on =
      second.stamp < first.stamp ? graph_slam::GoesOn::kFirst : graph_slam::GoesOn::kSecond;
  const auto merged = graph_slam::merged(first, second, settings, goes_on);
  graph_slam::writeSession(options.out, merged.session);
  const auto& shift = merged.first_second;
  std::cout << fmt::format(
      "recognised by {} landmarks and {} scans that both have\n"
      "the second map lies at x {:.2f} m, y {:.2f} m, heading {:.3f} rad in the first\n"
      "{}: {} nodes, {} landmarks, {} scans; the robot goes on from the end of {}\n",
      merged.landmarks, merged.scans, shift.x(), shift.y(), shift.theta(), options.out,
      merged.session.nodes.size(), merged.session.landmarks.size(), merged.session.scans.size(),
      goes_on == graph_slam::GoesOn::kFirst ? options.first : options.second);
}

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_merge",
      "Puts the map of one graph session onto that of another one, by the landmarks and scans that "
      "both have. The result is in the map frame of the first one.");
  Options options;
  line.add("FIRST", options.first, "a session's file, as --save-session writes it").required();
  line.add("SECOND", options.second, "the session to put onto it").required();
  line.add("--out", options.out, "the file to write").required();
  return line.run(argc, argv, [&] { merge(options); });
}
