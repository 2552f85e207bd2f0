// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/features.hpp"

#include <algorithm>
#include <utility>

namespace slam::mono_graph {
namespace {

constexpr double kCell = 24.0;   // edge [px]
constexpr int kMostCells = 128;  // in a row or column; a wide lens's corners share the last one

int cellsOf(double length, double focal) {
  return static_cast<int>(std::min(length * focal / kCell, kMostCells - 1.0)) + 1;
}

}  // namespace

Features::Features(std::vector<Feature> features, const NormalisedCamera& camera, double focal)
    : features_(std::move(features)), camera_(camera), focal_(focal) {
  sort();
}

int Features::column(double x) const {
  return std::clamp(static_cast<int>((x - least_.x()) * focal_ / kCell), 0, columns_ - 1);
}

int Features::row(double y) const {
  return std::clamp(static_cast<int>((y - least_.y()) * focal_ / kCell), 0, rows_ - 1);
}

/// Counts each cell's features, then puts them where they belong.
void Features::sort() {
  if (features_.empty()) return;
  least_ = most_ = features_.front().seen;
  for (const auto& feature : features_) {
    least_ = least_.cwiseMin(feature.seen);
    most_ = most_.cwiseMax(feature.seen);
  }
  columns_ = cellsOf(most_.x() - least_.x(), focal_);
  rows_ = cellsOf(most_.y() - least_.y(), focal_);
  const auto cellOf = [this](const Feature& feature) {
    return static_cast<std::size_t>(row(feature.seen.y()) * columns_ + column(feature.seen.x()));
  };
  begins_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const auto& feature : features_) ++begins_[cellOf(feature) + 1];
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  members_.resize(features_.size());
  auto next = begins_;
  for (std::size_t i = 0; i < features_.size(); ++i) members_[next[cellOf(features_[i])]++] = i;
}

bool Features::covers(const Eigen::Vector2d& seen) const {
  return (seen.array() >= least_.array()).all() && (seen.array() <= most_.array()).all();
}

void Features::within(const Eigen::AlignedBox2d& box, std::vector<std::size_t>& found) const {
  if (features_.empty() || !box.intersects({least_, most_})) return;
  const int left = column(box.min().x()), right = column(box.max().x());
  const int top = row(box.min().y()), bottom = row(box.max().y());
  for (int r = top; r <= bottom; ++r)
    for (int c = left; c <= right; ++c) {
      const auto cell = static_cast<std::size_t>(r * columns_ + c);
      for (std::size_t k = begins_[cell]; k < begins_[cell + 1]; ++k)
        if (box.contains(features_[members_[k]].seen)) found.push_back(members_[k]);
    }
}

void Features::near(const Eigen::Vector2d& seen, double radius,
                    std::vector<std::size_t>& found) const {
  const double reach = radius / focal_;
  const std::size_t before = found.size();
  const Eigen::Vector2d corner = Eigen::Vector2d::Constant(reach);
  within({seen - corner, seen + corner}, found);
  const auto is_far = [&](std::size_t i) {
    return (features_[i].seen - seen).squaredNorm() > reach * reach;
  };
  found.erase(
      std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(), is_far),
      found.end());
}

}  // namespace slam::mono_graph
