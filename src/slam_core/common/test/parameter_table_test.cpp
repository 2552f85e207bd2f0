// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/parameter_table.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

class ParameterTable : public testing::Test {
 protected:
  double speed_ = 0.5;
  std::string mode_ = "slow", name_;
  bool loud_ = false;
  Fields fields_;
};

TEST_F(ParameterTable, HasARowForEachFieldWithAllThatIsKnownOfIt) {
  fields_.add("speed", &speed_, "how fast").unit("m/s").in(Range::closed(0, 2));
  fields_.add("mode", &mode_, "slow|fast, as it is driven").oneOf({"slow", "fast"});
  fields_.add("name", &name_, "of the robot");
  EXPECT_EQ(parameterTable(fields_),
            "| name | default | unit | type | allowed | meaning |\n"
            "| --- | --- | --- | --- | --- | --- |\n"
            "| `speed` | `0.5` | m/s | number | [0, 2] | how fast |\n"
            "| `mode` | `slow` | | text | `slow`, `fast` | slow\\|fast, as it is driven |\n"
            "| `name` | | | text | | of the robot |\n");
}

TEST_F(ParameterTable, TellsTheFileOnlyWhereThereAreTwo) {
  fields_.add("loud", &loud_, "beeps").ofRobot();
  EXPECT_EQ(filesOf(fields_), "robot");
  EXPECT_EQ(parameterTable(fields_).find("file"), std::string::npos);
  fields_.add("speed", &speed_, "how fast");
  EXPECT_EQ(filesOf(fields_), "product, robot");
  EXPECT_NE(parameterTable(fields_).find("| `loud` | robot | `false` |"), std::string::npos);
  EXPECT_NE(parameterTable(fields_).find("| `speed` | product | `0.5` |"), std::string::npos);
}

}  // namespace
}  // namespace slam
