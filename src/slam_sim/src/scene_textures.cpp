// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_textures.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>

#include "painted_wall.hpp"
#include "slam_sim/surface_textures.hpp"

namespace slam::sim {
namespace {

constexpr std::uint64_t kLook = 20;       // the textures' seed: a world always looks the same
constexpr std::uint64_t kPainted = 1000;  // and that of the first painted wall

TexturePtr seamless(const std::string& name, const std::function<cv::Mat()>& paint) {
  static std::map<std::string, TexturePtr> painted;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  TexturePtr& texture = painted[name];
  if (!texture) texture = std::make_shared<const Texture>(paint(), Texture::Wrap::kRepeat);
  return texture;
}

struct Cover {
  cv::Mat (*paint)(int edge, std::uint64_t seed);
  std::uint64_t seed;
  double period;  ///< [m]
};

Seamless coverOf(const std::map<std::string, Cover>& covers, const std::string& kind,
                 const std::string& name) {
  const auto found = covers.find(name);
  if (found == covers.end()) {
    throw std::invalid_argument("no texture of a " + kind + " is called '" + name + "'");
  }
  const Cover& cover = found->second;
  return {seamless(kind + " " + name, [&] { return cover.paint(kSeamlessEdge, cover.seed); }),
          cover.period};
}

}  // namespace

Seamless wallCover(const std::string& name) {
  static const std::map<std::string, Cover> kCovers = {
      {"plaster", {plasterTexture, kLook + 2, 2.0}},
      {"wallpaper", {wallpaperTexture, kLook + 4, 2.0}},
      {"brick", {brickTexture, kLook + 8, 2.0}},
      {"panelling", {panellingTexture, kLook + 10, 1.5}}};
  return coverOf(kCovers, "wall", name);
}

Seamless floorCover(const std::string& name) {
  static const std::map<std::string, Cover> kCovers = {
      {"linoleum", {floorTexture, kLook, 1.5}},
      {"tiles", {tiledFloorTexture, kLook + 12, 1.6}},
      {"parquet", {parquetTexture, kLook + 14, 1.6}},
      {"terrazzo", {terrazzoTexture, kLook + 16, 2.0}}};
  return coverOf(kCovers, "floor", name);
}

Seamless furnitureCover(const std::string& name) {
  static const std::map<std::string, Cover> kCovers = {
      {"wood", {woodTexture, kLook + 6, 1.0}},
      {"books", {booksTexture, kLook + 18, 1.0}},
      {"panelling", {panellingTexture, kLook + 10, 1.5}}};
  return coverOf(kCovers, "piece of furniture", name);
}

TexturePtr ceilingCover(const std::string& name) {
  return seamless("ceiling " + name, [&] { return ceilingTexture(name, kCeilingEdge, kLook + 1); });
}

TexturePtr doorCover(double width, double height) {
  return std::make_shared<const Texture>(doorLeaf(width, height), Texture::Wrap::kClamp);
}

bool isPainted(const std::string& wall_texture) {
  return wall_texture == "posters" || wall_texture == "mural";
}

TexturePtr paintedCover(const std::string& name, double width, double height, std::uint64_t look) {
  const auto paint = name == "posters" ? posterWall : muralWall;
  return std::make_shared<const Texture>(paint(width, height, kPainted * (look + 1)),
                                         Texture::Wrap::kClamp);
}

}  // namespace slam::sim
