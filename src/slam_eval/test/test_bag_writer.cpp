// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bag_contents.hpp"
#include "bag_writer.hpp"
#include "import_error.hpp"
#include "messages.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

/// While it lives, this process cannot write files above a size: a full disk without one.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

class BagWriterTest : public testing::Test {
 protected:
  void addPoses(int count) {
    for (int i = 0; i < count; ++i) {
      writer_.add("/pose", makeTruthPose(1'000'000'000 + i * 7919, 0.1 * i, 0.2 * i, 0.3 * i));
    }
  }

  TempFolder folder_;
  BagWriter writer_;
  std::ostringstream log_;
  Progress progress_{log_, false};
};

TEST_F(BagWriterTest, WritesInStampOrderAndKeepsTheOrderOfEqualStamps) {
  for (const auto& [stamp, x] : {std::pair{30, 1.0}, {10, 2.0}, {30, 3.0}, {20, 4.0}}) {
    writer_.add("/pose", makeTruthPose(stamp, x, 0.0, 0.0));
  }
  writer_.write(folder_.file("a.bag"), progress_);
  std::vector<double> order;
  for (const auto& pose : messagesOf<geometry_msgs::PoseStamped>(folder_.file("a.bag"), "/pose")) {
    order.push_back(pose.pose.position.x);
  }
  EXPECT_EQ(order, (std::vector<double>{2.0, 4.0, 1.0, 3.0}));
}

TEST_F(BagWriterTest, ReceivesEveryMessageAtItsStampAndTheRobotsNameBeforeAll) {
  writer_.add("/pose", makeTruthPose(20, 0.0, 0.0, 0.0));
  writer_.add("/pose", makeTruthPose(10, 0.0, 0.0, 0.0));
  addRobotName(writer_, "some_robot");
  writer_.write(folder_.file("a.bag"), progress_);
  rosbag::Bag bag(folder_.file("a.bag"));
  rosbag::View view(bag);
  std::vector<std::string> topics;
  std::vector<std::uint64_t> times;
  for (const rosbag::MessageInstance& instance : view) {
    topics.push_back(instance.getTopic());
    times.push_back(instance.getTime().toNSec());
  }
  EXPECT_EQ(topics, (std::vector<std::string>{"/robot", "/pose", "/pose"}));
  EXPECT_EQ(times, (std::vector<std::uint64_t>{9, 10, 20}));
}

TEST_F(BagWriterTest, LeavesNothingButTheBag) {
  addPoses(10);
  writer_.write(folder_.file("a.bag"), progress_);
  EXPECT_TRUE(std::filesystem::exists(folder_.file("a.bag")));
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(BagWriterTest, WritesWhatBelongsBesideTheBagWithItOrNothing) {
  addPoses(1);
  writer_.addBeside(".stamps.csv", "a table\n");
  writer_.write(folder_.file("a.bag"), progress_);
  std::ifstream table(folder_.file("a.bag.stamps.csv"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(table), {}), "a table\n");
  EXPECT_EQ(folder_.count(), 2);
  std::filesystem::create_directory(folder_.file("b.bag.stamps.csv"));
  const auto message =
      messageOf<ImportError>([this] { writer_.write(folder_.file("b.bag"), progress_); });
  EXPECT_NE(message.find("b.bag.stamps.csv"), std::string::npos) << message;
  EXPECT_EQ(folder_.count(), 3) << "no bag without its table";
}

TEST_F(BagWriterTest, KeepsTheFormerBagAndNoPartWhenTheDiskIsFull) {
  folder_.write("a.bag", "the former one");
  addPoses(20000);
  std::string message;
  {
    const FileSizeLimit limit(20'000);
    message = messageOf<ImportError>([this] { writer_.write(folder_.file("a.bag"), progress_); });
  }
  EXPECT_NE(message.find("cannot write " + folder_.file("a.bag")), std::string::npos) << message;
  EXPECT_EQ(folder_.count(), 1);
  EXPECT_EQ(std::filesystem::file_size(folder_.file("a.bag")), 14u);
}

TEST_F(BagWriterTest, ReportsADiskThatIsFullOnlyAtTheEnd) {
  addPoses(10);
  std::string message;
  {
    const FileSizeLimit limit(100);
    message = messageOf<ImportError>([this] { writer_.write(folder_.file("a.bag"), progress_); });
  }
  EXPECT_NE(message.find("no bag was left"), std::string::npos) << message;
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(BagWriterTest, WritesThroughNoLinkThatLiesBesideTheBag) {
  addPoses(10);
  const auto victim = folder_.file("victim"), part = folder_.file("a.bag.part");
  folder_.write("victim", "of another person");
  for (const auto& link : {part, part + std::to_string(::getpid())})
    std::filesystem::create_symlink(victim, link);
  writer_.write(folder_.file("a.bag"), progress_);
  EXPECT_EQ(std::filesystem::file_size(victim), 17u);
  EXPECT_FALSE(std::filesystem::is_symlink(folder_.file("a.bag")));
}

TEST_F(BagWriterTest, RefusesAFolderThatIsNotThere) {
  addPoses(1);
  EXPECT_THROW(writer_.write(folder_.file("none/a.bag"), progress_), UsageError);
  EXPECT_THROW(writer_.write(folder_.path(), progress_), UsageError);
}

TEST_F(BagWriterTest, RefusesAnImportWithoutMessages) {
  EXPECT_THROW(writer_.write(folder_.file("a.bag"), progress_), ImportError);
  EXPECT_EQ(folder_.count(), 0);
}

}  // namespace
}  // namespace slam::eval
