// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/grid_renderer.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/models/test/simulated_room.hpp"

namespace slam::graph_slam {
namespace {

using test::RoomDrive;

std::vector<LaserScan> scansOf(int count, double relative_sigma, int beams = 61) {
  RoomDrive drive(1);
  drive.beams = beams;
  drive.way_of_step = 0.3;
  std::vector<LaserScan> scans;
  for (int i = 0; i < count; ++i) {
    scans.push_back(drive.next().scan);
    scans.back().relative_sigma = relative_sigma;
  }
  return scans;
}

/// A renderer that is asked after each change, beside what it should have drawn.
class Drawing {
 public:
  explicit Drawing(const grid_map::GridMapConfig& config = {}) : config_(config), asked(config) {}

  void startWith(const OccupancyGrid& grid) {
    base_ = grid;
    asked.startWith(grid);
  }
  void add(const LaserScan& scan, const Pose2& pose) {
    const auto node = graph_.add(pose);
    priors_[node] = graph_.add(priorOf(node, pose));
    graph_.update({});
    scans_.emplace_back(node, std::make_shared<const LaserScan>(scan));
    asked.add(node, graph_.pose(node), scans_.back().second);
  }
  void move(std::size_t i, const Pose2& by) {
    const auto node = scans_[i].first;
    graph_.remove(priors_[node]);
    priors_[node] = graph_.add(priorOf(node, graph_.pose(node) * by));
    graph_.optimize({}, 10);
    asked.follow(graph_);
  }
  void remove(std::size_t i) {
    asked.remove(scans_[i].first);
    scans_.erase(scans_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void expectAsDrawnAnew() const {
    GridRenderer anew(config_);
    if (base_) anew.startWith(*base_);
    for (const auto& [node, scan] : scans_) anew.add(node, graph_.pose(node), scan);
    const auto grid = asked.grid(), expected = anew.grid();
    EXPECT_EQ(grid.cells, expected.cells);
    EXPECT_EQ(grid.width, expected.width);
    EXPECT_EQ(grid.origin, expected.origin);
  }

 private:
  static std::shared_ptr<const graph::Factor> priorOf(graph::Key node, const Pose2& pose) {
    return std::make_shared<graph::PosePrior>(node, pose, Eigen::Matrix3d::Identity());
  }

  grid_map::GridMapConfig config_;
  graph::Optimizer graph_;
  std::map<graph::Key, graph::FactorId> priors_;
  std::vector<std::pair<graph::Key, SharedScan>> scans_;
  std::optional<OccupancyGrid> base_;

 public:
  GridRenderer asked;
};

class GridRendererTest : public testing::TestWithParam<double> {};

/// A laser whose ranges are so noisy that cells depend on one another, and one whose are not.
INSTANTIATE_TEST_SUITE_P(NoiseOfRanges, GridRendererTest, testing::Values(0.0, 0.02));

void changeAtRandom(Drawing& drawing, double relative_sigma) {
  RandomStream random(3, 0);
  int there = 0;
  for (const auto& scan : scansOf(30, relative_sigma)) {
    const auto noise = [&random] { return 0.3 * random.gaussian(); };
    drawing.add(scan, {2.0 * noise(), 2.0 * noise(), noise()});
    ++there;
    const auto any = [&] {
      return static_cast<std::size_t>(random.uniform() * static_cast<double>(there)) %
             static_cast<std::size_t>(there);
    };
    if (there % 3 == 0) drawing.move(any(), {0.2 + noise(), 0.1, 0.3 * noise()});
    if (there % 5 == 0) drawing.move(0, {0.2, -0.1, 0.05});
    if (there % 4 == 0) drawing.expectAsDrawnAnew();
    if (there % 7 == 0) {
      drawing.remove(any());
      --there;
    }
    drawing.expectAsDrawnAnew();
  }
}

TEST_P(GridRendererTest, ShowsWhatADrawingOfAllScansShows) {
  Drawing drawing;
  changeAtRandom(drawing, GetParam());
}

TEST_P(GridRendererTest, ShowsTheSameOverALoadedGrid) {
  GridRenderer earlier{grid_map::GridMapConfig()};
  for (const auto& scan : scansOf(5, 0.0))
    earlier.add(0, {0.1, 0.2, 0.5}, std::make_shared<const LaserScan>(scan));
  Drawing drawing;
  drawing.startWith(earlier.grid());
  drawing.expectAsDrawnAnew();
  changeAtRandom(drawing, GetParam());
}

/// Which cells are left out depends on the order in which the map has grown.
TEST_P(GridRendererTest, ShowsTheSameWhereTheMapMayGrowNoFurther) {
  grid_map::GridMapConfig config;
  config.largest_area = 60.0;
  Drawing drawing(config);
  changeAtRandom(drawing, GetParam());
}

TEST(GridRenderer, KeepsTheDrawingOfAScanThatMovesByLessThanHalfACell) {
  Drawing drawing;
  for (const auto& scan : scansOf(3, 0.0)) drawing.add(scan, {});
  const auto before = drawing.asked.grid();
  const auto revision = drawing.asked.revision();
  drawing.move(1, {0.02, 0.0, 0.005});
  EXPECT_EQ(drawing.asked.revision(), revision);
  EXPECT_EQ(drawing.asked.grid().cells, before.cells);
  drawing.move(1, {0.02, 0.0, 0.005});
  EXPECT_NE(drawing.asked.revision(), revision);
  EXPECT_NE(drawing.asked.grid().cells, before.cells);
  drawing.expectAsDrawnAnew();
}

LaserScan oneBeam(double relative_sigma) {
  LaserScan scan;
  scan.beams = {{0.0F, 3.0F, true}};
  scan.relative_sigma = relative_sigma;
  return scan;
}

std::int8_t cellAt(const OccupancyGrid& grid, double x, double y) {
  const Eigen::Vector2d at = (Eigen::Vector2d(x, y) - grid.origin) / grid.resolution;
  const auto column = static_cast<std::size_t>(at.x()), row = static_cast<std::size_t>(at.y());
  return grid.cells.at(row * grid.width + column);
}

class GridDrawingTest : public testing::Test {
 protected:
  void draw(double relative_sigma) {
    const auto scan = oneBeam(relative_sigma);
    points = grid_map::pointsOf(scan, model, 1.0);
    drawing.draw(points, {0.02, 0.02, 0.0});
    drawing.draw(points, {0.02, 5.02, 0.0});
    drawing.erase(points, {0.02, 0.02, 0.0});
  }
  grid_map::GridMapConfig config;
  grid_map::BeamModel model{config};
  GridDrawing drawing{config, model, std::nullopt};
  grid_map::ScanPoints points;
};

TEST_F(GridDrawingTest, LeavesTilesAsTheyAreThatNoErasedScanTouches) {
  draw(0.0);
  ASSERT_TRUE(drawing.clearErased());
  EXPECT_FALSE(drawing.mayBeTouched({0.0, 8.0, 0.0}, 3.0));
  EXPECT_TRUE(drawing.mayBeTouched({0.0, 3.0, 0.0}, 3.0));
  const auto grid = drawing.grid();
  EXPECT_NEAR(grid.origin.y(), 5.0, 1e-9) << "nothing is left of the other one";
  EXPECT_GT(cellAt(grid, 3.03, 5.03), 50);
  EXPECT_LT(cellAt(grid, 2.03, 5.03), 50);
}

TEST_F(GridDrawingTest, WantsAllDrawnAnewWhereBeamsAreReadWithTheMapsHelp) {
  draw(0.02);
  EXPECT_FALSE(drawing.clearErased());
}

}  // namespace
}  // namespace slam::graph_slam
