// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_files.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "slam_core/grid_map/grid_file.hpp"

namespace slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLandmarks = "landmarks.yaml";
constexpr const char* kGrid = "map.yaml";

/// Of a map that was made elsewhere.
PoseEstimate unknownStart() {
  PoseEstimate start;
  start.covariance.diagonal() << 0.25, 0.25, std::pow(M_PI / 12, 2);
  return start;
}

bool isGrid(const std::string& path) {
  try {
    return YAML::LoadFile(path)["image"].IsDefined();
  } catch (const YAML::Exception&) {
    return false;  // who reads it as landmarks will say why it cannot be read
  }
}

MapFiles filesToLoad(const std::string& path, bool has_grid) {
  if (!fs::is_directory(path)) return isGrid(path) ? MapFiles{"", path} : MapFiles{path, ""};
  auto files = mapFilesAt(path, has_grid);
  if (!fs::exists(files.grid)) files.grid.clear();
  if (!fs::exists(files.landmarks) && !files.grid.empty()) files.landmarks.clear();
  if (!fs::exists(files.landmarks) && files.grid.empty())
    throw std::runtime_error("the folder " + path + " holds no " + kLandmarks +
                             (has_grid ? std::string(" and no ") + kGrid : "") +
                             "; name the folder that a map was saved to");
  return files;
}

}  // namespace

MapFiles mapFilesAt(const std::string& path, bool has_grid) {
  const fs::path given(path);
  if (fs::is_directory(given) || given.filename().empty())
    return {(given / kLandmarks).string(), has_grid ? (given / kGrid).string() : ""};
  if (!has_grid) return {path, ""};
  const auto beside = [&](const char* name) { return (given.parent_path() / name).string(); };
  if (given.filename() == kLandmarks) return {path, beside(kGrid)};
  return {beside(kLandmarks), path};
}

std::string saveMap(const std::string& path, const LandmarkFile& file) {
  const auto& grid = file.map.grid;
  const bool has_grid = grid && !grid->cells.empty();
  const auto files = mapFilesAt(path, has_grid);
  if (has_grid) grid_map::saveGrid(files.grid, *grid);
  saveLandmarks(files.landmarks, file);
  auto text =
      std::to_string(file.map.landmarks.size()) + " landmarks written to " + files.landmarks;
  if (has_grid)
    text += ", " + std::to_string(grid->width) + " x " + std::to_string(grid->height) +
            " cells to " + files.grid;
  return text;
}

LandmarkFile loadMap(const std::string& path, const std::string& frame, bool has_grid) {
  const auto files = filesToLoad(path, has_grid);
  if (!files.grid.empty() && !has_grid)
    throw std::runtime_error("cannot use the map " + path +
                             ": it is a grid, and this product's map are landmarks");
  LandmarkFile file;
  file.frame = frame;
  if (files.landmarks.empty())
    file.map.robot = unknownStart();
  else
    file = loadLandmarks(files.landmarks, frame);
  if (!files.grid.empty()) file.map.grid = grid_map::loadGrid(files.grid);
  return file;
}

}  // namespace slam
