// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "exit_code.hpp"
#include "frame.hpp"
#include "slam_core/contract/data.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam_pipes {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::string read(const fs::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/// slam_part by hand, between two files in the place of pipes.
class SlamPart : public testing::Test {
 protected:
  SlamPart() {
    fs::create_directories(folder_);
    write(folder_ / "product.yaml", "version: 1\nproduct: p\n");
    write(folder_ / "robot.yaml", "version: 1\nrobot: r\n");
  }
  ~SlamPart() override { fs::remove_all(folder_); }

  int run(const std::string& arguments = "--part odometry --from bag=0") {
    write(folder_ / "in", input_);
    const auto command = "cd '" + folder_.string() + "' && " SLAM_PART " product.yaml robot.yaml " +
                         arguments + " < in > out 2> err";
    const int status = std::system(command.c_str());
    said_ = read(folder_ / "err");
    return WEXITSTATUS(status);
  }

  void put(const Frame& frame) { input_ += encoder_.bytesOf(frame); }
  void putMark(Frame::Type type) { put({type, "", "", ""}); }
  /// The odometry at a second, and its turn's mark.
  void putOdometryAt(int second) {
    slam::OdometrySample sample;
    sample.stamp = slam::Stamp(std::chrono::seconds(second));
    sample.pose = {double(second), 0.0, 0.0};
    put({Frame::Type::kDatum, "odom", slam::nameOf(slam::kindOf<slam::OdometrySample>()),
         bytesOf(sample)});
    putMark(Frame::Type::kTurn);
  }

  const fs::path folder_ = fs::temp_directory_path() / ("slam_part_" + std::to_string(::getpid()));
  FrameEncoder encoder_;
  std::string input_, said_;
};

TEST_F(SlamPart, MakesMotionOfOdometry) {
  putOdometryAt(1);
  putOdometryAt(2);
  putMark(Frame::Type::kEnd);
  ASSERT_EQ(run("--part odometry --from bag=0 --to backend=1"), kDone) << said_;
  const auto made = read(folder_ / "out");
  FrameDecoder decoder;
  decoder.append(made.data(), made.size());
  EXPECT_EQ(decoder.next()->type, Frame::Type::kTurn);
  const auto motion = decoder.next();
  ASSERT_EQ(motion->port, "motion");
  EXPECT_NEAR(valueOf<slam::Motion>(motion->value).increment.x(), 1.0, 1e-9);
  EXPECT_EQ(decoder.next()->type, Frame::Type::kTurn);
  EXPECT_EQ(decoder.next()->type, Frame::Type::kEnd);
  EXPECT_FALSE(decoder.isWithinFrame());
}

TEST_F(SlamPart, EndsWhereItsInputWasClosed) {
  putOdometryAt(1);
  EXPECT_EQ(run(), kPipeClosed);
  EXPECT_EQ(said_,
            "slam_part: the pipe from the bag was closed before the end of its data: start the run "
            "again\n");
}

TEST_F(SlamPart, RefusesAFrameThatIsCut) {
  putOdometryAt(1);
  input_.resize(input_.size() - 5);
  EXPECT_EQ(run(), kFailed);
  EXPECT_EQ(said_, "slam_part: the pipe from the bag ends within a frame: start the run again\n");
}

TEST_F(SlamPart, RefusesAFrameOfAnotherVersion) {
  putOdometryAt(1);
  input_[8] = 2;
  EXPECT_EQ(run(), kFailed);
  EXPECT_EQ(said_,
            "slam_part: the pipe from the bag cannot be read: its frames are of version 2 and this "
            "program reads version 1: start both of its ends from one installation\n");
}

TEST_F(SlamPart, RefusesADamagedFrame) {
  putOdometryAt(1);
  input_[60] = static_cast<char>(input_[60] ^ 1);
  EXPECT_EQ(run(), kFailed);
  EXPECT_EQ(said_,
            "slam_part: the pipe from the bag cannot be read: it is damaged, its checksum does not "
            "fit: start the run again\n");
}

TEST_F(SlamPart, RefusesDataThatItDoesNotTake) {
  put({Frame::Type::kDatum, "scan", "slam::LaserSweep", ""});
  putMark(Frame::Type::kTurn);
  EXPECT_EQ(run(), kFailed);
  EXPECT_EQ(said_,
            "slam_part: 'scan' (slam::LaserSweep) comes by a pipe, but the odometry source 'wheel' "
            "does not take it: start both from one installation\n");
}

TEST_F(SlamPart, RefusesAValueThatIsNoneOfItsKind) {
  put({Frame::Type::kDatum, "odom", "slam::OdometrySample", "x"});
  putMark(Frame::Type::kTurn);
  EXPECT_EQ(run(), kFailed);
  EXPECT_EQ(
      said_,
      "slam_part: 'odom' (slam::OdometrySample) comes by a pipe and cannot be read: start both "
      "of its ends from one installation\n");
}

TEST_F(SlamPart, RefusesWrongUse) {
  EXPECT_EQ(run("--part odometry --from bag"), kWrongUse);
  EXPECT_EQ(said_, "slam_part: 'bag' is no pipe: write PART=DESCRIPTOR\n");
  EXPECT_EQ(run("--part wheels --from bag=0"), kFailed);
  EXPECT_EQ(said_, "slam_part: the product has no part 'wheels'; it has: odometry, backend\n");
  EXPECT_EQ(run("--part odometry"), kFailed);
  EXPECT_EQ(said_, "slam_part: no pipe comes from a part that there is: give --from\n");
}

}  // namespace
}  // namespace slam_pipes
