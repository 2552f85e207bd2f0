// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_files.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "slam_core/common/input_file.hpp"
#include "slam_core/common/yaml_file.hpp"
#include "slam_core/grid_map/grid_file.hpp"

namespace slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLandmarks = "landmarks.yaml";
constexpr const char* kGrid = "map.yaml";
const std::string kLandmarksEnding = ".landmarks.yaml";

/// Where the robot is taken to be in a map that was made elsewhere: about its origin.
PoseEstimate unknownStart() {
  PoseEstimate start;
  start.covariance.diagonal() << 0.25, 0.25, std::pow(M_PI / 12, 2);
  return start;
}

bool isGrid(const std::string& path) {
  try {
    const auto root = loadYamlFile(path, "the map", YamlLimits::configuration());
    return root.IsMap() && root["image"].IsDefined();
  } catch (const std::runtime_error&) {
    return false;  // who reads it as landmarks will say why it cannot be read
  }
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// A grid's file and that of the landmarks beside it.
MapFiles pairOf(const fs::path& given) {
  const auto name = given.filename().string();
  const auto beside = [&](const std::string& other) {
    return (given.parent_path() / other).string();
  };
  if (name == kLandmarks) return {given, beside(kGrid)};
  if (name == kGrid) return {beside(kLandmarks), given};
  if (endsWith(name, kLandmarksEnding))
    return {given, beside(name.substr(0, name.size() - kLandmarksEnding.size()) + ".yaml")};
  return {fs::path(given).replace_extension(kLandmarksEnding), given};
}

MapFiles filesInFolder(const std::string& path, bool has_grid) {
  auto files = mapFilesAt(path, has_grid);
  if (!fs::exists(files.grid)) files.grid.clear();
  if (!fs::exists(files.landmarks) && !files.grid.empty()) files.landmarks.clear();
  if (!fs::exists(files.landmarks) && files.grid.empty())
    throw std::runtime_error("the folder " + path + " holds no " + kLandmarks +
                             (has_grid ? std::string(" and no ") + kGrid : "") +
                             "; name the file or folder that a map was saved to");
  return files;
}

MapFiles filesToLoad(const std::string& path, bool has_grid) {
  if (fs::is_directory(path)) return filesInFolder(path, has_grid);
  if (isGrid(path)) {
    const auto landmarks = pairOf(path).landmarks;
    return {fs::exists(landmarks) ? landmarks : "", path};
  }
  const bool is_half = has_grid && !fs::exists(path) && fs::exists(pairOf(path).landmarks);
  return {is_half ? pairOf(path).landmarks : path, ""};  // of a map that had no grid yet
}

}  // namespace

MapFiles mapFilesAt(const std::string& path, bool has_grid) {
  const fs::path given(path);
  if (fs::is_directory(given) || given.filename().empty())
    return {given / kLandmarks, has_grid ? (given / kGrid).string() : ""};
  return has_grid ? pairOf(given) : MapFiles{path, ""};
}

std::string saveMap(const std::string& path, const LandmarkFile& file) {
  const auto& grid = file.map.grid;
  const auto files = mapFilesAt(path, grid.has_value());
  if (grid) grid_map::imagePathOf(files.grid);  // throws also where the grid is not known yet
  const bool is_known = grid && !grid->cells.empty();
  if (is_known)
    grid_map::saveGrid(files.grid, *grid);
  else if (grid && fs::exists(files.grid))
    throw std::runtime_error("cannot save the map to " + path + ": it has no grid yet, and " +
                             files.grid + " is of an earlier map; name another file or folder");
  saveLandmarks(files.landmarks, file);
  const auto text =
      std::to_string(file.map.landmarks.size()) + " landmarks written to " + files.landmarks;
  if (!grid) return text;
  if (!is_known) return text + "; there is no grid yet";
  return text + ", " + std::to_string(grid->width) + " x " + std::to_string(grid->height) +
         " cells to " + files.grid;
}

LandmarkFile loadMap(const std::string& path, const std::string& frame, bool has_grid) {
  if (path.empty()) requireInputFile(path, "the map");
  const auto files = filesToLoad(path, has_grid);
  if (!files.grid.empty() && !has_grid)
    throw std::runtime_error("cannot use the map " + path +
                             ": it is a grid, and this product's map consists of landmarks");
  LandmarkFile file;
  file.frame = frame;
  if (files.landmarks.empty())
    file.map.robot = unknownStart();
  else
    file = loadLandmarks(files.landmarks, frame);
  if (!has_grid && file.map.landmarks.empty() && fs::exists(pairOf(files.landmarks).grid))
    throw std::runtime_error("cannot use the map " + path +
                             ": it holds a grid and no landmarks, and this product's map "
                             "consists of landmarks");
  if (!files.grid.empty()) file.map.grid = grid_map::loadGrid(files.grid);
  return file;
}

}  // namespace slam
