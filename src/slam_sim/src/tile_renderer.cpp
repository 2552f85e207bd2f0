// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tile_renderer.hpp"

#include <algorithm>

#include "texture_sampler.hpp"

namespace slam::sim {
namespace {

constexpr float kFarthest = 1e-3F;  // inverse depth; nothing is seen beyond [1/m]
constexpr float kNothing = 0.3F;    // light from where there is nothing
constexpr int kPixels = CameraRays::kTilePixels;
constexpr int kTileEdge = CameraRays::kTileEdge;

/// Light on the surface where a ray meets it, or at its edge nearest to there.
float lightAt(const Surface& surface, const PlaneView& view, float x, float y) {
  const double w = std::max(view.w.at(x, y), kFarthest);
  return surface.light.at(view.uw.at(x, y) / w, view.vw.at(x, y) / w);
}

/// A ray that meets the surface, if one of five does.
Eigen::Vector2f rayOnto(const ViewedSurface& viewed, const PlaneView& view, const RayBounds& rays) {
  const Eigen::Vector2f places[] = {
      {(rays.x_min + rays.x_max) / 2.0F, (rays.y_min + rays.y_max) / 2.0F},
      {rays.x_min, rays.y_min},
      {rays.x_max, rays.y_min},
      {rays.x_min, rays.y_max},
      {rays.x_max, rays.y_max}};
  for (const auto& ray : places) {
    if (viewed.coverOf({ray.x(), ray.x(), ray.y(), ray.y()},
                       static_cast<std::size_t>(&view - viewed.views.data())) ==
        ViewedSurface::Cover::kFull) {
      return ray;
    }
  }
  return *std::max_element(std::begin(places), std::end(places), [&](const auto& a, const auto& b) {
    return view.w.at(a.x(), a.y()) < view.w.at(b.x(), b.y());
  });
}

}  // namespace

const TileValues& TileRenderer::render(int tile,
                                       const std::vector<const ViewedSurface*>& candidates) {
  tile_ = tile;
  entries_.clear();
  for (const ViewedSurface* viewed : candidates) {
    entries_.emplace_back();
    entries_.back().viewed = viewed;
  }
  sum_.fill(0.0F);
  const auto samples = static_cast<std::size_t>(rays_.samples());
  for (std::size_t sample = 0; sample < samples; ++sample) renderSample(sample);
  for (float& value : sum_) value /= static_cast<float>(samples);
  return sum_;
}

void TileRenderer::prepare(Entry& entry) const {
  entry.prepared = true;
  const Surface& surface = *entry.viewed->surface;
  const PlaneView& view = entry.viewed->views[entry.viewed->views.size() / 2];
  const RayBounds& rays = rays_.bounds(tile_);
  const Eigen::Vector2f ray = rayOnto(*entry.viewed, view, rays);
  entry.level = levelFor(surface, view, ray.x(), ray.y(), ray_step_);

  // Light changes slowly: interpolated between the tile's corners.
  const auto scale = static_cast<float>(surface.gain / 255.0);
  const float upper_left = scale * lightAt(surface, view, rays.x_min, rays.y_min);
  const float upper_right = scale * lightAt(surface, view, rays.x_max, rays.y_min);
  const float lower_left = scale * lightAt(surface, view, rays.x_min, rays.y_max);
  const float lower_right = scale * lightAt(surface, view, rays.x_max, rays.y_max);
  for (int row = 0; row < kTileEdge; ++row) {
    const float down = (static_cast<float>(row) + 0.5F) / kTileEdge;
    const float left = upper_left + down * (lower_left - upper_left);
    const float right = upper_right + down * (lower_right - upper_right);
    float* out = &entry.light[static_cast<std::size_t>(row * kTileEdge)];
    for (int column = 0; column < kTileEdge; ++column) {
      out[column] = left + (static_cast<float>(column) + 0.5F) / kTileEdge * (right - left);
    }
  }
}

void TileRenderer::renderSample(std::size_t sample) {
  if (selectSeen(sample)) {
    addAll(*seen_.front(), sample);
    return;
  }
  findNearest(sample);
  for (int i = 0; i < static_cast<int>(seen_.size()); ++i) addWhereNearest(i, sample);
}

bool TileRenderer::selectSeen(std::size_t sample) {
  using Cover = ViewedSurface::Cover;
  const RayBounds& rays = rays_.bounds(tile_);
  seen_.clear();
  float filled = 0.0F;  // everything beyond this inverse depth is hidden
  const Entry* filling = nullptr;
  for (Entry& entry : entries_) {
    const Cover cover = entry.viewed->coverOf(rays, sample);
    if (cover == Cover::kNone) continue;
    seen_.push_back(&entry);
    const float farthest = entry.viewed->views[sample].w.minOver(rays);
    if (cover == Cover::kFull && farthest > filled) {
      filled = farthest;
      filling = &entry;
    }
  }
  const auto hidden = [&](const Entry* entry) {
    return entry != filling && entry->viewed->views[sample].w.maxOver(rays) < filled;
  };
  seen_.erase(std::remove_if(seen_.begin(), seen_.end(), hidden), seen_.end());
  return filling != nullptr && seen_.size() == 1;
}

void TileRenderer::findNearest(std::size_t sample) {
  const float* x = rays_.x(tile_, static_cast<int>(sample));
  const float* y = rays_.y(tile_, static_cast<int>(sample));
  depth_.fill(kFarthest);
  nearest_.fill(-1);
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const ViewedSurface& viewed = *seen_[k]->viewed;
    const LinearForm w = viewed.views[sample].w, uw = viewed.views[sample].uw,
                     vw = viewed.views[sample].vw;
    const float width = viewed.width, height = viewed.height;
    const auto index = static_cast<std::int32_t>(k);
    float* depth = depth_.data();
    std::int32_t* nearest = nearest_.data();
    for (int i = 0; i < kPixels; ++i) {
      const float here = w.x * x[i] + w.y * y[i] + w.c;
      const float u = uw.x * x[i] + uw.y * y[i] + uw.c;
      const float v = vw.x * x[i] + vw.y * y[i] + vw.c;
      const bool met = (here > depth[i]) & (u >= 0.0F) & (v >= 0.0F) & (u <= width * here) &
                       (v <= height * here);
      depth[i] = met ? here : depth[i];
      nearest[i] = met ? index : nearest[i];
    }
  }
  for (std::size_t i = 0; i < kPixels; ++i) sum_[i] += nearest_[i] < 0 ? kNothing : 0.0F;
}

void TileRenderer::addAll(Entry& entry, std::size_t sample) {
  if (!entry.prepared) prepare(entry);
  const auto view = viewTexture(*entry.viewed->surface, entry.viewed->views[sample], entry.level);
  const int s = static_cast<int>(sample);
  sampleTexture(view, rays_.x(tile_, s), rays_.y(tile_, s), kPixels, gray_.data());
  for (std::size_t i = 0; i < kPixels; ++i) sum_[i] += gray_[i] * entry.light[i];
}

void TileRenderer::addWhereNearest(int seen_index, std::size_t sample) {
  const float* x = rays_.x(tile_, static_cast<int>(sample));
  const float* y = rays_.y(tile_, static_cast<int>(sample));
  int count = 0;
  for (int i = 0; i < kPixels; ++i) {
    const auto to = static_cast<std::size_t>(count);
    pixels_[to] = i;
    x_[to] = x[i];
    y_[to] = y[i];
    count += nearest_[static_cast<std::size_t>(i)] == seen_index ? 1 : 0;
  }
  if (count == 0) return;
  Entry& entry = *seen_[static_cast<std::size_t>(seen_index)];
  if (!entry.prepared) prepare(entry);
  const auto view = viewTexture(*entry.viewed->surface, entry.viewed->views[sample], entry.level);
  sampleTexture(view, x_.data(), y_.data(), count, gray_.data());
  for (int i = 0; i < count; ++i) {
    const auto pixel = static_cast<std::size_t>(pixels_[static_cast<std::size_t>(i)]);
    sum_[pixel] += gray_[static_cast<std::size_t>(i)] * entry.light[pixel];
  }
}

}  // namespace slam::sim
