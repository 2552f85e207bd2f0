// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/common/yaml_file.hpp"
#include "slam_core/grid_map/pgm_image.hpp"

namespace slam::grid_map {
namespace {

namespace fs = std::filesystem;

// map_saver's grey values and, in percent, thresholds
constexpr std::uint8_t kOccupied = 0, kFree = 254, kUnknown = 205;
constexpr int kMostFree = 25, kLeastOccupied = 65;
constexpr std::int8_t kCertain = 100;
constexpr std::uint64_t kMostImageBytes = 1u << 30;

std::uint8_t greyOf(std::int8_t cell) {
  if (cell >= 0 && cell <= kMostFree) return kFree;
  return cell >= kLeastOccupied && cell <= kCertain ? kOccupied : kUnknown;
}

/// An image's first row is the top one, a grid's the bottom one.
template <class Value>
void turnOver(std::vector<Value>& rows, std::uint32_t width, std::uint32_t height) {
  const auto row = [&](std::uint32_t y) {
    return rows.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * width);
  };
  for (std::uint32_t y = 0; y < height / 2; ++y)
    std::swap_ranges(row(y), row(y + 1), row(height - 1 - y));
}

/// How grey values are read, as the YAML file has it.
struct Legend {
  std::string mode;
  bool negate;
  double occupied_thresh, free_thresh;

  std::int8_t cellOf(std::uint8_t pixel) const {
    const int grey = negate ? 255 - pixel : pixel;
    if (mode == "raw")
      return grey <= kCertain ? static_cast<std::int8_t>(grey) : OccupancyGrid::kUnknown;
    const double occupied = (255 - grey) / 255.0;
    if (occupied > occupied_thresh) return kCertain;
    if (occupied < free_thresh) return 0;
    if (mode == "trinary") return OccupancyGrid::kUnknown;
    constexpr double kUncertain = 98.0;
    const double share = (occupied - free_thresh) / (occupied_thresh - free_thresh);
    return static_cast<std::int8_t>(1.0 + kUncertain * share);
  }
};

YAML::Node required(const YAML::Node& root, const std::string& key) {
  if (!root[key]) throw std::runtime_error("it has no " + key);
  return root[key];
}

double finite(const YAML::Node& node, const std::string& name) {
  double value = NAN;
  if (!YAML::convert<double>::decode(node, value) || !std::isfinite(value))
    throw std::runtime_error(name + " is not a finite number");
  return value;
}

/// map_server takes a number, which is what map_saver writes, or a truth value.
bool readNegate(const YAML::Node& node) {
  int value = 0;
  if (YAML::convert<int>::decode(node, value)) return value != 0;
  bool negate = false;
  if (!YAML::convert<bool>::decode(node, negate))
    throw std::runtime_error("negate is neither 0 nor 1");
  return negate;
}

Legend readLegend(const YAML::Node& root) {
  Legend legend;
  legend.mode = root["mode"] ? root["mode"].as<std::string>() : "trinary";
  if (legend.mode != "trinary" && legend.mode != "scale" && legend.mode != "raw")
    throw std::runtime_error("mode '" + legend.mode + "' is none of trinary, scale and raw");
  legend.negate = readNegate(required(root, "negate"));
  legend.occupied_thresh = finite(required(root, "occupied_thresh"), "occupied_thresh");
  legend.free_thresh = finite(required(root, "free_thresh"), "free_thresh");
  if (!(legend.free_thresh < legend.occupied_thresh))
    throw std::runtime_error("free_thresh is not less than occupied_thresh");
  return legend;
}

void readGeometry(const YAML::Node& root, OccupancyGrid& grid) {
  grid.resolution = finite(required(root, "resolution"), "resolution");
  if (!(grid.resolution > 0.0))
    throw std::runtime_error(
        fmt::format("resolution is {} and must be more than 0 m/cell", grid.resolution));
  const auto origin = required(root, "origin");
  if (!origin.IsSequence() || origin.size() != 3)
    throw std::runtime_error("origin is not [x, y, yaw]");
  grid.origin = {finite(origin[0], "origin's x"), finite(origin[1], "origin's y")};
  if (const double yaw = finite(origin[2], "origin's yaw"); yaw != 0.0)
    throw std::runtime_error(
        fmt::format("its origin is rotated by {} rad; only maps along the axes can be used", yaw));
}

PgmImage readImage(const std::string& path) {
  const auto content = readInputFile(path, "its image", kMostImageBytes);
  try {
    return fromPgm(content);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("its image " + path + " cannot be used: " + error.what());
  }
}

OccupancyGrid parse(const YAML::Node& root, const fs::path& folder) {
  if (!root.IsMap()) throw std::runtime_error("it is no map's YAML file");
  OccupancyGrid grid;
  readGeometry(root, grid);
  const auto legend = readLegend(root);
  const auto image = readImage((folder / required(root, "image").as<std::string>()).string());
  grid.width = image.width;
  grid.height = image.height;
  grid.cells.resize(image.pixels.size());
  std::transform(image.pixels.begin(), image.pixels.end(), grid.cells.begin(),
                 [&](std::uint8_t pixel) { return legend.cellOf(pixel); });
  turnOver(grid.cells, grid.width, grid.height);
  return grid;
}

}  // namespace

fs::path imagePathOf(const std::string& yaml_path) {
  const auto image = fs::path(yaml_path).replace_extension(".pgm");
  if (image == fs::path(yaml_path))
    throw std::runtime_error("cannot write " + yaml_path +
                             ": this is the name of the grid's image; name the file that describes "
                             "it, which ends with .yaml");
  return image;
}

void saveGrid(const std::string& yaml_path, const OccupancyGrid& grid) {
  if (grid.cells.empty())
    throw std::runtime_error("cannot write " + yaml_path + ": there is no grid map yet");
  const auto image_path = imagePathOf(yaml_path);
  PgmImage image{grid.width, grid.height, std::vector<std::uint8_t>(grid.cells.size())};
  std::transform(grid.cells.begin(), grid.cells.end(), image.pixels.begin(), greyOf);
  turnOver(image.pixels, image.width, image.height);
  writeFileAtomically(image_path.string(), toPgm(image, fmt::format("{} m/pix", grid.resolution)));
  writeFileAtomically(yaml_path,
                      fmt::format("image: {}\nresolution: {}\norigin: [{}, {}, 0]\nnegate: 0\n"
                                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                                  image_path.filename().string(), grid.resolution, grid.origin.x(),
                                  grid.origin.y()));
}

OccupancyGrid loadGrid(const std::string& yaml_path) {
  requireInputFile(yaml_path, "the grid map");
  try {
    const auto root = loadYamlFile(yaml_path, "the grid map", YamlLimits::configuration());
    return parse(root, fs::path(yaml_path).parent_path());
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot use the grid map " + yaml_path + ": " + error.what());
  }
}

}  // namespace slam::grid_map
