// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

class EstimatorMapsTest : public testing::Test {
 protected:
  void configure(const std::string& mode) {
    Settings settings(
        {"product.yaml", YAML::Load("{version: 1, backend: pf, map: grid, pf: {particles: 5}, "
                                    "grid_map: {resolution: 0.1, largest_area: 400.0}}")},
        {"robot.yaml", YAML::Load("version: 1")}, {"pf.mode=" + mode});
    estimator.use(Registry<Backend>::instance().create("pf"));
    estimator.configure(settings);
  }
  /// A free square about (x, 0).
  static MapState square(double edge, double x = 0.0) {
    MapState map;
    map.robot = {Pose2(1, 2, 0.5), 0.01 * Eigen::Matrix3d::Identity()};
    auto& grid = map.grid.emplace();
    grid.resolution = 0.1;
    grid.width = grid.height = static_cast<std::uint32_t>(std::lround(edge / grid.resolution));
    grid.origin = {x - 0.5 * edge, -0.5 * edge};
    grid.cells.assign(std::size_t{grid.width} * grid.height, 0);
    return map;
  }
  std::vector<std::int8_t> grid() const {
    return estimator.capabilities().find<GridMapper>()->grid()->cells;
  }

  Estimator estimator;
};

TEST_F(EstimatorMapsTest, SaysThatAMapIsTooLarge) {
  for (const std::string mode : {"slam", "localization"}) {
    configure(mode);
    const auto status = estimator.set(square(40.0));
    EXPECT_EQ(status.level, Status::Level::kWarning) << "what has room is used";
    EXPECT_NE(status.message.find("larger than grid_map.largest_area"), std::string::npos)
        << status.message;
    EXPECT_GT(grid().size(), 0u);
    EXPECT_EQ(estimator.startWith(square(40.0)).message, status.message);
    estimator.reset();
    EXPECT_EQ(estimator.execute().message, status.message) << "once more it is cut";
    EXPECT_EQ(estimator.execute().message, "");
  }
}

TEST_F(EstimatorMapsTest, AMapThatIsNoneLeavesThatBeforeAsItIs) {
  configure("slam");
  EXPECT_TRUE(estimator.set(square(4.0)).isOk());
  const auto before = grid();
  auto map = square(2.0, 1e12);
  map.robot.pose = Pose2(7, 7, 0);
  map.landmarks = {{900, {5, 5}, 0.01 * Eigen::Matrix2d::Identity()}};
  const auto status = estimator.set(map);
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_NE(status.message.find("the grid's origin is more than"), std::string::npos);
  EXPECT_EQ(grid(), before);
  EXPECT_EQ(estimator.backend().pose().pose.x(), 1.0);
  EXPECT_TRUE(estimator.capabilities().find<LandmarkMapper>()->landmarks().empty());
}

}  // namespace
}  // namespace slam
