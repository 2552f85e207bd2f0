// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam::grid_map {
namespace {

using test::requireThat;

void check(const OccupancyGrid& grid) {
  requireThat(grid.resolution > 0.0 && std::isfinite(grid.resolution), "no resolution");
  requireThat(grid.origin.allFinite(), "an origin that is not finite");
  requireThat(grid.cells.size() == std::size_t{grid.width} * grid.height && !grid.cells.empty(),
              "another number of cells");
  requireThat(std::all_of(grid.cells.begin(), grid.cells.end(),
                          [](auto cell) { return cell >= OccupancyGrid::kUnknown && cell <= 100; }),
              "a cell that is no percentage");
}

/// What was read can be written, and is the same when it is read again.
void checkThatItComesBack(const OccupancyGrid& grid, const test::TemporaryFolder& folder) {
  saveGrid(folder / "saved.yaml", grid);
  const auto once = loadGrid(folder / "saved.yaml");
  saveGrid(folder / "again.yaml", once);
  const auto again = loadGrid(folder / "again.yaml");
  requireThat(once.width == grid.width && once.height == grid.height &&
                  once.resolution == grid.resolution && once.origin == grid.origin,
              "a saved map of another size");
  requireThat(again.cells == once.cells, "a saved map with other cells");
}

}  // namespace
}  // namespace slam::grid_map

/// A map of map_server: the input is its YAML and, from the first "P5" on, its image map.pgm. It is
/// refused with a sentence, or it is a grid.
SLAM_FUZZ_TARGET(grid_file) {
  static const slam::test::TemporaryFolder kFolder;
  const auto input = slam::test::contentOf(bytes, size);
  const auto image = std::min(input.find("P5"), input.size());
  const auto path = kFolder.write("map.yaml", input.substr(0, image));
  kFolder.write("map.pgm", input.substr(image));
  std::optional<slam::OccupancyGrid> grid;
  try {
    grid = slam::grid_map::loadGrid(path);
  } catch (const std::runtime_error& refused) {
    slam::test::requireSentence(refused);
    return;
  }
  slam::grid_map::check(*grid);
  slam::grid_map::checkThatItComesBack(*grid, kFolder);
}
