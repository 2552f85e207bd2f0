// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

// A laser of few beams in a hall whose aisles all look alike: what the graph says of its own
// uncertainty, and whether it takes one aisle for another.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::graph_slam {
namespace {

struct Box {
  Eigen::Vector2d least, most;  ///< [m]
};

/// Racks of the same length and distance; aisles between them and on both sides.
struct Hall {
  static constexpr double kAisle = 2.2, kRack = 1.2, kPitch = kAisle + kRack;  // [m]
  double length;                                                               ///< of a rack [m]
  int racks;

  double middleOf(int aisle) const { return 0.5 * kAisle + aisle * kPitch; }
  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    for (int i = 0; i < racks; ++i) {
      const double y = kAisle + i * kPitch;
      boxes.push_back({{kMargin, y}, {kMargin + length, y + kRack}});
    }
    return boxes;
  }
  Box walls() const { return {{0, 0}, {length + 2 * kMargin, racks * kPitch + kAisle}}; }

  static constexpr double kMargin = 3.0;  // between the racks' ends and the walls [m]
};

/// Where a ray enters and leaves a box; entered after left where it passes by.
std::pair<double, double> crossing(const Box& box, const Eigen::Vector2d& from,
                                   const Eigen::Vector2d& ray) {
  const Eigen::Array2d a = (box.least - from).array() / ray.array(),
                       b = (box.most - from).array() / ray.array();
  return {a.min(b).maxCoeff(), a.max(b).minCoeff()};
}

/// A robot that drives through all aisles and back along the wall, lap after lap.
class HallDrive {
 public:
  struct Step {
    Motion motion;
    LaserScan scan;
    Pose2 truth;  ///< in the frame of the first pose
  };

  HallDrive(const Hall& hall, std::uint64_t seed)
      : hall_(hall), boxes_(hall.boxes()), random_(seed, 0), corners_(lap()) {}

  Step next() {
    const Pose2 way = stamp_ == Stamp() ? Pose2() : nextWay();
    Step step;
    step.motion.start = stamp_;
    stamp_ += std::chrono::milliseconds(200);
    step.motion.end = stamp_;
    const double along = std::abs(way.x()), turn = std::abs(way.theta());
    const Eigen::Vector3d variance(1e-8 + kAlong * along, 1e-8 + 0.2 * kAlong * along,
                                   1e-8 + kTurn * (along + turn));
    step.motion.covariance = variance.asDiagonal();
    const Eigen::Vector3d white(random_.gaussian(), random_.gaussian(), random_.gaussian());
    step.motion.increment =
        Pose2::fromVector(way.vector() + variance.cwiseSqrt().cwiseProduct(white));
    truth_ = truth_ * way;
    step.scan = scan();
    step.truth = first_.between(truth_);
    return step;
  }
  int laps() const { return laps_; }

 private:
  static constexpr double kStep = 0.15, kTurnOfStep = 0.2;  // [m], [rad]
  static constexpr double kAlong = 2e-4, kTurn = 4e-4;      // [m^2/m], [rad^2/m] and [rad^2/rad]
  static constexpr int kBeams = 360;
  static constexpr double kMostRange = 3.5, kNoise = 0.015;  // [m], [1]

  std::vector<Eigen::Vector2d> lap() const {
    const double west = 2.0, east = hall_.length + 2 * Hall::kMargin - 2.0;
    std::vector<Eigen::Vector2d> corners;
    for (int i = 0; i <= hall_.racks; ++i) {
      const double y = hall_.middleOf(i);
      corners.emplace_back(i % 2 == 0 ? west : east, y);
      corners.emplace_back(i % 2 == 0 ? east : west, y);
    }
    corners.emplace_back(1.0, hall_.middleOf(hall_.racks));
    corners.emplace_back(1.0, hall_.middleOf(0));
    return corners;
  }
  /// Turns on the spot to the next corner, then drives there.
  Pose2 nextWay() {
    Eigen::Vector2d to = truth_.inverse().transform(corners_[next_]);
    if (to.norm() < 1e-6) {
      next_ = (next_ + 1) % corners_.size();
      if (next_ == 0) ++laps_;
      to = truth_.inverse().transform(corners_[next_]);
    }
    const double turn = std::atan2(to.y(), to.x());
    if (std::abs(turn) > 1e-6) return {0, 0, std::clamp(turn, -kTurnOfStep, kTurnOfStep)};
    return {std::min(kStep, to.norm()), 0, 0};
  }
  double rangeTo(double direction) const {
    const Eigen::Vector2d ray(std::cos(direction), std::sin(direction)), from = truth_.position();
    double range = crossing(hall_.walls(), from, ray).second;
    for (const auto& box : boxes_) {
      const auto [enters, leaves] = crossing(box, from, ray);
      if (enters > 0.0 && enters < leaves) range = std::min(range, enters);
    }
    return range;
  }
  LaserScan scan() {
    LaserScan scan;
    scan.stamp = stamp_;
    scan.relative_sigma = kNoise;
    for (int i = 0; i < kBeams; ++i) {
      const double bearing = 2.0 * M_PI * (i + 0.5) / kBeams - M_PI;
      const double range = rangeTo(truth_.theta() + bearing) * (1.0 + kNoise * random_.gaussian());
      const bool hit = range < kMostRange;
      scan.beams.push_back(
          {static_cast<float>(bearing), static_cast<float>(hit ? range : kMostRange), hit});
    }
    return scan;
  }

  Hall hall_;
  std::vector<Box> boxes_;
  RandomStream random_;
  std::vector<Eigen::Vector2d> corners_;
  std::size_t next_ = 1;
  int laps_ = 0;
  Stamp stamp_;
  Pose2 first_{2.0, hall_.middleOf(0), 0.0}, truth_ = first_;
};

/// Of a drive, what has been reported on the way.
struct Reported {
  double worst = 0.0;    ///< distance between pose and truth [m]
  double nees = 0.0;     ///< of the position in the first lap, in the mean; 2 is expected
  double vaguest = 0.0;  ///< largest sigma of the position in the first lap [m]
  int wrong = 0;         ///< poses that were wrong and sure of themselves
};

/// Wrong is what the benchmarks call confidently wrong: more than 0.3 m and five sigmas off.
Reported drive(HallDrive& drive, int laps) {
  auto backend = std::make_unique<GraphSlam>();
  as<MapChooser>(*backend).useMap(MapKind::kGrid);
  backend->configure(GraphConfig(), grid_map::GridMapConfig());
  Reported reported;
  int count = 0;
  while (drive.laps() < laps) {
    const auto step = drive.next();
    give(step.motion, *backend);
    give(step.scan, *backend);
    backend->execute();
    const auto pose = backend->pose();
    const Eigen::Vector2d error = pose.pose.position() - step.truth.position();
    const Eigen::Matrix2d P = pose.covariance.topLeftCorner<2, 2>();
    const double squared = error.dot(P.inverse() * error);
    reported.worst = std::max(reported.worst, error.norm());
    if (error.norm() > 0.3 && squared > 25.0) ++reported.wrong;
    if (drive.laps() > 0) continue;
    reported.nees += squared;
    reported.vaguest = std::max(reported.vaguest, std::sqrt(P.trace()));
    ++count;
  }
  reported.nees /= count;
  return reported;
}

TEST(Aisles, ThatLookAlikeAreNotTakenForOneAnother) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    HallDrive hall({16.0, 4}, seed);
    const auto reported = drive(hall, 2);
    EXPECT_LT(reported.worst, 0.6) << "seed " << seed;
    EXPECT_EQ(reported.wrong, 0) << "seed " << seed;
    EXPECT_LT(reported.nees, 4.0) << "seed " << seed;
    EXPECT_LT(reported.vaguest, 1.5) << "nor vaguer than need be, seed " << seed;
  }
}

}  // namespace
}  // namespace slam::graph_slam
