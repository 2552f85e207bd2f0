// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/laser_landmarks/wall_lines.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/laser_landmarks/scan_segments.hpp"
#include "slam_core/models/line_model.hpp"

namespace slam::laser_landmarks {
namespace {

using Beams = std::vector<LaserBeam>;

constexpr double kSplitSigmas = 4.0;  // large, as the chord's two end beams err as well
constexpr std::size_t kTrimmed = 1;   // beams left out at either end of a line

/// Beams [begin, end) of a segment.
struct Piece {
  std::size_t begin, end;

  std::size_t size() const { return end - begin; }
};

class Splitter {
 public:
  Splitter(const Beams& beams, const LaserLinesConfig& config, const BeamNoise& noise)
      : beams_(beams), config_(config), noise_(noise) {}

  std::vector<Piece> pieces() {
    split({0, beams_.size()});
    merge();
    return pieces_;
  }

  std::optional<Line> fit(const Piece& piece) const {
    if (piece.size() < kTrimmed + kTrimmed) return std::nullopt;
    const auto at = [this](std::size_t i) {
      return beams_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    return fitLine({at(piece.begin + kTrimmed), at(piece.end - kTrimmed)}, noise_);
  }

 private:
  void split(const Piece& piece) {
    const auto corner = farthest(piece);
    if (!corner) return pieces_.push_back(piece);
    split({piece.begin, *corner + 1});
    split({*corner, piece.end});  // the beam at a corner belongs to both
  }

  /// The beam that ends farthest from the straight line between the first and the last one, if it
  /// is too far away to belong to that line.
  std::optional<std::size_t> farthest(const Piece& piece) const {
    const Eigen::Vector2d from = beams_[piece.begin].end();
    const Eigen::Vector2d way = beams_[piece.end - 1].end() - from;
    const double length = way.norm();
    std::optional<std::size_t> corner;
    double most = 1.0;
    for (std::size_t i = piece.begin + 1; i + 1 < piece.end && length > 0.0; ++i) {
      const Eigen::Vector2d d = beams_[i].end() - from;
      const double off = std::abs(way.x() * d.y() - way.y() * d.x()) / length;
      const double share = off / (config_.split_distance + kSplitSigmas * sigma(beams_[i]));
      if (share <= most) continue;
      most = share;
      corner = i;
    }
    return corner;
  }

  double sigma(const LaserBeam& beam) const { return std::sqrt(noise_.rangeVariance(beam.range)); }

  /// Merges neighbours that one line fits: a split may have gone too far.
  void merge() {
    for (std::size_t i = 0; i + 1 < pieces_.size();) {
      const Piece both{pieces_[i].begin, pieces_[i + 1].end};
      const auto line = fit(both);
      if (line && line->misfit <= config_.max_misfit && !farthest(both)) {
        pieces_[i] = both;
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      } else {
        ++i;
      }
    }
  }

  const Beams& beams_;
  const LaserLinesConfig& config_;
  const BeamNoise noise_;
  std::vector<Piece> pieces_;
};

std::string rejectionOf(const Piece& piece, const std::optional<Line>& line,
                        const LaserLinesConfig& config) {
  if (piece.size() < static_cast<std::size_t>(config.min_points) + 2 * kTrimmed || !line)
    return "few_points";
  if (line->length() < config.min_length) return "short";
  return line->misfit > config.max_misfit ? "not_straight" : "";
}

Beams withinRange(const LaserScan& scan, double max_range) {
  Beams beams = scan.beams;
  for (auto& beam : beams) beam.hit = beam.hit && beam.range <= max_range;
  return beams;
}

/// Whether two lines follow each other in the sweep and end where they cross.
/// @param most distance of an end from the crossing [m]
bool meet(const WallLine& a, const WallLine& b, const Crossing& crossing, double most) {
  const auto gap = [&](const Line& line, double end) {
    return std::abs(line.along().dot(crossing.position) - end);
  };
  return a.segment == b.segment && b.begin <= a.end + 2 * kTrimmed &&
         gap(a.line, a.line.extent.end) <= most && gap(b.line, b.line.extent.begin) <= most;
}

Eigen::Vector2d difference(const Line& a, const Line& b) {
  return {a.range - b.range, wrapAngle(a.bearing - b.bearing)};
}

bool areOneWall(const Line& a, const Line& b, double sigma_wall) {
  constexpr double kSameLine = 9.2;  // squared Mahalanobis distance
  const Eigen::Vector2d nu = difference(a, b);
  const Eigen::Matrix2d S =
      withWallNoise(a, sigma_wall).covariance + withWallNoise(b, sigma_wall).covariance;
  return gapBetween(a.extent, b.extent) <= kLargestLineGap && nu.dot(S.inverse() * nu) <= kSameLine;
}

Line fused(const Line& a, const Line& b) {
  const Eigen::Matrix2d K = a.covariance * (a.covariance + b.covariance).inverse();
  const Eigen::Vector2d change = K * difference(b, a);
  const Eigen::Matrix2d P = (Eigen::Matrix2d::Identity() - K) * a.covariance;
  Line line;
  line.range = a.range + change.x();
  line.bearing = wrapAngle(a.bearing + change.y());
  line.covariance = 0.5 * (P + P.transpose());
  line.extent = united(a.extent, b.extent);
  line.misfit = std::max(a.misfit, b.misfit);
  return line;
}

}  // namespace

std::vector<WallLine> wallLinesOf(const LaserScan& scan, const LaserLinesConfig& config,
                                  Counters& counters) {
  const BeamNoise noise{config.sigma_range, scan.relative_sigma, config.sigma_bearing};
  const auto found =
      segmentsOf(withinRange(scan, config.max_range), config.max_jump, scan.relative_sigma);
  std::vector<WallLine> lines;
  for (std::size_t s = 0; s < found.segments.size(); ++s) {
    Splitter splitter(found.segments[s].beams, config, noise);
    for (const auto& piece : splitter.pieces()) {
      const auto line = splitter.fit(piece);
      const auto rejection = rejectionOf(piece, line, config);
      if (!rejection.empty()) {
        counters.add(rejection);
        continue;
      }
      lines.push_back({*line, s, piece.begin, piece.end});
    }
  }
  return lines;
}

Line withWallNoise(const Line& line, double sigma) {
  const double variance = sigma * sigma, turn = 4.0 * variance / std::pow(line.length(), 2);
  const double lever = (line.extent.begin + line.extent.end) / 2.0;
  Line noisy = line;
  noisy.covariance(0, 0) += variance + lever * lever * turn;
  noisy.covariance(0, 1) += lever * turn;
  noisy.covariance(1, 0) += lever * turn;
  noisy.covariance(1, 1) += turn;
  return noisy;
}

std::vector<Line> wallsOf(const std::vector<WallLine>& lines, double sigma_wall) {
  std::vector<Line> walls;
  for (const auto& part : lines) {
    const auto same = std::find_if(walls.begin(), walls.end(), [&](const Line& wall) {
      return areOneWall(wall, part.line, sigma_wall);
    });
    if (same == walls.end())
      walls.push_back(part.line);
    else
      *same = fused(*same, part.line);
  }
  for (auto& wall : walls) wall = withWallNoise(wall, sigma_wall);
  return walls;
}

std::vector<Crossing> cornersOf(const std::vector<WallLine>& lines,
                                const LaserLinesConfig& config) {
  std::vector<Crossing> corners;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const auto &a = lines[i], &b = lines[i + 1];
    const double angle = std::abs(wrapAngle(a.line.bearing - b.line.bearing));
    if (angle < config.min_corner_angle || angle > M_PI - config.min_corner_angle) continue;
    const auto crossing = crossingOf(withWallNoise(a.line, config.sigma_wall),
                                     withWallNoise(b.line, config.sigma_wall));
    if (crossing && meet(a, b, *crossing, config.max_corner_gap)) corners.push_back(*crossing);
  }
  return corners;
}

}  // namespace slam::laser_landmarks
