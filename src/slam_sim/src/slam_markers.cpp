// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <stdexcept>

#include "marker_sheets.hpp"
#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_sim/marker_family.hpp"

// Sheets of fiducial markers to be printed, as a PDF.

namespace {

using slam::sim::MarkerSheets;

void print(MarkerSheets sheets, const std::string& ids, const std::string& path) {
  if (slam::sim::findMarkerFamily(sheets.family) == nullptr)
    throw std::invalid_argument("there is no family '" + sheets.family + "'" +
                                slam::didYouMean(sheets.family, slam::sim::markerFamilyNames()) +
                                "; there are: " + slam::join(slam::sim::markerFamilyNames()));
  sheets.ids = slam::sim::readIds(ids);
  const auto printed = slam::sim::printed(sheets);
  slam::writeFileAtomically(path, printed.pdf);
  fmt::print(
      "{}: {} markers of {:g} m on {} {}. Print at 100 %, not fitted to the page, and measure "
      "the ruler and a black square.\n",
      path, sheets.ids.size(), sheets.size, printed.pages, printed.pages == 1 ? "page" : "pages");
  if (printed.has_narrow_margin)
    fmt::print(
        "The white margin is one cell wide: on a dark wall leave the paper around it, or take a "
        "larger paper.\n");
}

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line("slam_markers", "Draws fiducial markers as a PDF to be printed.");
  MarkerSheets sheets;
  sheets.family = "36h11";
  std::string ids = "0-11", path = "markers.pdf";
  line.add("--family", sheets.family, "an AprilTag family or a dictionary of OpenCV").withDefault();
  line.add("--ids", ids, "which ones").withDefault();
  line.add("--size", sheets.size, "edge of the black square [m]").withDefault();
  line.add("--paper", sheets.paper, "A5 to A0, letter, legal, tabloid").withDefault();
  line.add("--out", path, "the file to write").withDefault();
  return line.run(argc, argv, [&] {
    try {
      print(sheets, ids, path);
    } catch (const std::invalid_argument& error) {
      throw slam_ros::WrongUse(error.what());
    }
  });
}
