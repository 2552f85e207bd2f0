// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/active_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slam::mono_ekf {
namespace {

constexpr double kNearShare = 0.2;  // of the largest search: where most features should be
constexpr std::size_t kFew = 10;

bool isInside(const Eigen::Vector2d& pixel, const cv::Mat& gray) {
  constexpr double kBorder = Patch::kRadius + 2.0;
  return pixel.x() >= kBorder && pixel.y() >= kBorder && pixel.x() < gray.cols - kBorder &&
         pixel.y() < gray.rows - kBorder;
}

/// Semi-axis of the ellipse in which a feature is searched [px].
double reachOf(const Search& search) {
  const double half_trace = 0.5 * search.S.trace();
  const double square = half_trace * half_trace - search.S.determinant();
  return std::sqrt(kPixelGate * (half_trace + std::sqrt(std::max(square, 0.0))));
}

}  // namespace

std::vector<Search> ActiveSearch::searchFar(const MonoState& state, const PlanarCamera& camera,
                                            const cv::Mat& gray, double pixel_sigma) const {
  auto candidates = expected(state, camera, gray, pixel_sigma);
  const auto near = std::count_if(candidates.begin(), candidates.end(), [&](const auto& search) {
    return reachOf(search) <= kNearShare * config_.largest_search;
  });
  if (2 * static_cast<std::size_t>(near) >= candidates.size()) return {};
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return reachOf(a) < reachOf(b); });
  return find(std::move(candidates), {kFew, config_.largest_search}, state, camera, gray, {});
}

std::vector<Search> ActiveSearch::searchNear(const MonoState& state, const PlanarCamera& camera,
                                             const cv::Mat& gray, double pixel_sigma,
                                             const std::vector<Search>& before) const {
  const auto most = static_cast<std::size_t>(config_.features_in_view);
  return find(expected(state, camera, gray, pixel_sigma),
              {most - std::min(most, before.size()), kNearShare * config_.largest_search}, state,
              camera, gray, before);
}

/// @return searches for the features in sight, oldest first
std::vector<Search> ActiveSearch::expected(const MonoState& state, const PlanarCamera& camera,
                                           const cv::Mat& gray, double pixel_sigma) const {
  std::vector<Search> expected;
  for (std::size_t i = 0; i < state.features().size(); ++i) {
    const auto& feature = state.features()[i];
    const auto prediction =
        predictedPixel(camera, state.robot().pose, feature, coordinatesOf(state, feature));
    if (!prediction || !isInside(prediction->pixel, gray)) continue;
    Search search;
    search.feature = i;
    search.predicted = prediction->pixel;
    search.S = predictedCovariance(state, feature.offset, *prediction);
    search.S.diagonal().array() += pixel_sigma * pixel_sigma;
    expected.push_back(search);
  }
  return expected;
}

std::vector<Search> ActiveSearch::find(std::vector<Search> candidates, const Effort& effort,
                                       const MonoState& state, const PlanarCamera& camera,
                                       const cv::Mat& gray,
                                       const std::vector<Search>& before) const {
  std::vector<Search> searches;
  const auto is_near = [&](const Search& a, const Search& b) {
    return a.feature == b.feature || (a.predicted - b.predicted).norm() < 0.5 * config_.spacing;
  };
  for (auto& search : candidates) {
    if (searches.size() >= effort.most) break;
    const auto is_near_it = [&](const Search& other) { return is_near(search, other); };
    if (!(reachOf(search) <= effort.largest_reach) ||
        std::any_of(before.begin(), before.end(), is_near_it) ||
        std::any_of(searches.begin(), searches.end(), is_near_it))
      continue;
    const auto patch = patchOf(state, search.feature, camera);
    if (!patch) continue;
    const auto found = patch->find(gray, search.predicted, search.S, kPixelGate);
    if (found && found->correlation >= config_.least_correlation) {
      search.outcome = Search::Outcome::kRejected;
      search.found = found->pixel;
    }
    searches.push_back(search);
  }
  return searches;
}

/// @return nothing where the feature is seen from too different a place
std::optional<Patch> ActiveSearch::patchOf(const MonoState& state, std::size_t which,
                                           const PlanarCamera& camera) const {
  constexpr double kFar = 100.0;  // [m], as good as infinity
  const auto& feature = state.features()[which];
  const auto& first = feature.first;
  const auto known = pointOf(feature, coordinatesOf(state, feature));
  const Eigen::Vector3d point = known ? *known : first.centre + kFar * first.ray;
  const Eigen::Vector3d vector = point - camera.centre(state.robot().pose);
  const double distance = (point - first.centre).norm();
  const double cos_change = (point - first.centre).dot(vector) / (distance * vector.norm());
  if (!(cos_change >= std::cos(config_.largest_view_change))) return std::nullopt;
  const auto projection = camera.project(state.robot().pose, vector);
  if (!projection) return std::nullopt;
  return Patch::seen(first, projection->J_vector * first.tangents, distance);
}

}  // namespace slam::mono_ekf
