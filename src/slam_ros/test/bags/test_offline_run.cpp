// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <map>
#include <nlohmann/json.hpp>

#include "bag_maker.hpp"
#include "slam_ros/ground_truth.hpp"
#include "slam_ros/offline_run.hpp"

namespace slam_ros {
namespace {

using test::BagMaker;
using test::contains;
using test::messageOf;

struct Offline : ::testing::Test {
  Offline() {
    product = folder.write("product.yaml", "version: 1\nproduct: test\nbackend: ekf\n");
    robot = folder.write("robot.yaml", "version: 1\nrobot: test\n");
    BagMaker(folder / "x.bag").addOdometry().addObservations().addTruth();
  }
  OfflineOptions options(const std::string& bag = "x.bag", const std::string& out = "run") const {
    return {{product, robot, folder / bag, folder / out, {}, {}}, {}, {}, {}, {}};
  }
  std::string faultOf(const OfflineOptions& options) const {
    return messageOf([&] { OfflineRun(options).run(); });
  }
  int exitCode(const std::string& arguments) const {
    const auto command = std::string(SLAM_OFFLINE) + " " + arguments + " 2> " +
                         (folder / "stderr") + " > " + (folder / "stdout");
    return WEXITSTATUS(std::system(command.c_str()));
  }
  test::Folder folder;
  std::string product, robot;
};

TEST_F(Offline, RefusesOneTopicForTwoCameras) {
  auto with = options();
  with.overrides = {"detector=apriltag", "second_camera=true",
                    "topics.rear_camera=camera/image_raw"};
  EXPECT_TRUE(contains(
      faultOf(with),
      "topics.rear_camera: 'camera/image_raw' is the topic of camera already; name that of the"));
}

TEST_F(Offline, WritesATrajectoryLineForEachObservationArrayThatOdometryCovers) {
  ASSERT_EQ(faultOf(options()), "");
  const auto trajectory = folder.read("run/trajectory.tum");
  EXPECT_EQ(std::count(trajectory.begin(), trajectory.end(), '\n'), 17);
  EXPECT_TRUE(contains(trajectory, "100.200000000 "));
  for (const auto* name : {"odometry.tum", "updates.csv", "landmarks.yaml", "config.yaml",
                           "trajectory_final.tum", "ground_truth.tum"})
    EXPECT_TRUE(folder.has(std::string("run/") + name)) << name;
}

TEST_F(Offline, TellsWhatWasNeverSteppedBecauseTheOdometryEnds) {
  BagMaker(folder / "dead.bag").addOdometry().addObservations("/observations", 12.0);
  const auto run = [&](const std::string& bag) {
    return exitCode(product + " --robot " + robot + " --bag " + (folder / bag) + " --out " +
                    (folder / "run"));
  };
  ASSERT_EQ(run("dead.bag"), 0);
  EXPECT_TRUE(contains(folder.read("stderr"), "40 messages of landmarks were never used"))
      << folder.read("stderr");
  EXPECT_TRUE(contains(folder.read("stderr"), "landmarks since 104.2 wait for motion"));
  EXPECT_TRUE(contains(folder.read("stdout"), "never_stepped 40")) << folder.read("stdout");
  ASSERT_EQ(run("x.bag"), 0);
  EXPECT_EQ(folder.read("stderr"), "");
  EXPECT_FALSE(contains(folder.read("stdout"), "never_stepped"));
}

TEST_F(Offline, WarnsWhereNothingCorrectsThePose) {
  {
    BagMaker bag(folder / "strange.bag");
    bag.addOdometry();
    for (int i = 1; i <= 36; ++i) {
      auto message = test::observations(0.1 * i, static_cast<std::uint64_t>(i - 1));
      for (auto& each : message.observations) each.id += 100 * i;  // each is seen once
      bag.add("/observations", 0.1 * i, message);
    }
  }
  ASSERT_EQ(exitCode(product + " --robot " + robot + " --bag " + (folder / "strange.bag") +
                     " --out " + (folder / "run")),
            0);
  EXPECT_TRUE(contains(folder.read("stderr"), "nothing that the sensors saw has corrected"))
      << folder.read("stderr");
}

TEST_F(Offline, WarnsWhereASensorHasSaidSomethingOnlyOnce) {
  BagMaker(folder / "once.bag").addOdometry().add("/observations", 1.0, test::observations(1.0, 0));
  ASSERT_EQ(exitCode(product + " --robot " + robot + " --bag " + (folder / "once.bag") + " --out " +
                     (folder / "run")),
            0);
  EXPECT_TRUE(contains(folder.read("stderr"), "one step could be taken in the whole bag"))
      << folder.read("stderr");
}

TEST_F(Offline, ObservationsThatAreStampedAheadCostOnlyThemselves) {
  {
    BagMaker bag(folder / "ahead.bag");
    bag.addOdometry();
    for (int i = 1; i <= 17; ++i) {
      auto message = test::observations(0.2 * i, static_cast<std::uint64_t>(i - 1));
      if (i == 5 || i == 6) message.header.stamp += ros::Duration(100.0);
      bag.add("/observations", 0.2 * i, message);
    }
  }
  ASSERT_EQ(faultOf(options("ahead.bag")), "");
  const auto trajectory = folder.read("run/trajectory.tum");
  EXPECT_EQ(std::count(trajectory.begin(), trajectory.end(), '\n'), 15);
  EXPECT_EQ(nlohmann::json::parse(folder.read("run/metrics.json"))["dropped_messages"], 2);
}

TEST_F(Offline, TellsWhatIsSetAsideAtTheEnd) {
  {
    BagMaker bag(folder / "back.bag");
    bag.addOdometry().addObservations();
    for (int i = 0; i < 20; ++i)
      bag.add("/observations", 3.6 + 0.01 * i,
              test::observations(-50.0 + 0.2 * i, static_cast<std::uint64_t>(17 + i)));
  }
  ASSERT_EQ(exitCode(product + " --robot " + robot + " --bag " + (folder / "back.bag") + " --out " +
                     (folder / "run")),
            0);
  EXPECT_TRUE(contains(folder.read("stderr"), "20 messages at the end were not used"))
      << folder.read("stderr");
  EXPECT_TRUE(contains(folder.read("stderr"), "20 of 118 messages had no effect"))
      << folder.read("stderr");
  EXPECT_TRUE(contains(folder.read("stdout"), "set_aside 20")) << folder.read("stdout");
  EXPECT_EQ(nlohmann::json::parse(folder.read("run/metrics.json"))["dropped_messages"], 20);
}

TEST_F(Offline, ARestartKeepsTheTrajectoryUntilThen) {
  {
    BagMaker bag(folder / "twice.bag");
    for (const double begin : {0.0, -50.0})
      for (int i = 0; i <= 40; ++i) {
        const double t = 0.1 * i, written = t + (begin < 0.0 ? 10.0 : 0.0);
        bag.add("/odom", written, test::odometry(begin + t));
        bag.add("/observations", written,
                test::observations(begin + t, static_cast<std::uint64_t>(i)));
      }
  }
  ASSERT_EQ(faultOf(options("twice.bag")), "");
  const auto kept = folder.read("run/trajectory.before_restart_1.tum");
  EXPECT_EQ(std::count(kept.begin(), kept.end(), '\n'), 41);
  EXPECT_TRUE(contains(kept, "103.900000000 "));
  EXPECT_TRUE(contains(folder.read("run/trajectory.tum"), "53.900000000 "));
}

/// From `moved` on every other one of 24 landmarks is elsewhere, from `lost` on all are, somewhere
/// else.
void addTroubledObservations(BagMaker& bag, int steps, int moved, int lost) {
  for (int i = 1; i <= steps; ++i) {
    auto message = test::observations(0.2 * i, static_cast<std::uint64_t>(i - 1));
    message.observations.resize(24, message.observations.front());
    for (int k = 0; k < 24; ++k) {
      auto& seen = message.observations[static_cast<std::size_t>(k)];
      seen.id = k;
      const double shift = i >= lost ? 8.0 : i >= moved && k % 2 == 0 ? 3.0 : 0.0;
      const double x = 20.0 - 0.2 * i, y = k - 12.0 + shift;
      seen.range = std::hypot(x, y);
      seen.bearing = std::atan2(y, x);
    }
    bag.add("/observations", 0.2 * i, message);
  }
}

TEST_F(Offline, AWarningThatComesWithManyNumbersLeavesRoomForThatThePoseMayBeLost) {
  {
    BagMaker bag(folder / "moved.bag");
    addTroubledObservations(bag.addOdometry("/odom", 14.0), 65, 20, 50);
  }
  ASSERT_EQ(exitCode(product + " --robot " + robot + " --bag " + (folder / "moved.bag") +
                     " --out " + (folder / "run")),
            0);
  const auto said = folder.read("stderr"), counted = folder.read("stdout");
  EXPECT_TRUE(contains(said, "landmark 0 was repeatedly seen elsewhere")) << said;
  EXPECT_FALSE(contains(said, "landmark 2 was seen elsewhere")) << "the same with another number";
  EXPECT_TRUE(contains(said, "the pose may be lost")) << said;
  EXPECT_TRUE(contains(counted, "times: no observation fits the map")) << counted;
}

TEST_F(Offline, TwiceGivesTheSameBytes) {
  ASSERT_EQ(faultOf(options("x.bag", "a")), "");
  ASSERT_EQ(faultOf(options("x.bag", "b")), "");
  for (const auto* name : {"trajectory.tum", "updates.csv", "odometry.tum", "landmarks.yaml"}) {
    EXPECT_FALSE(folder.read(std::string("a/") + name).empty()) << name;
    EXPECT_EQ(folder.read(std::string("a/") + name), folder.read(std::string("b/") + name)) << name;
  }
}

TEST_F(Offline, MotionAndTransformsDriveItAsOdometryDoes) {
  {
    BagMaker motion(folder / "motion.bag"), edge(folder / "tf.bag");
    for (int i = 0; i < 40; ++i) {
      motion.add("/motion", 0.1 * i, test::motion(0.1 * i, 0.1, static_cast<std::uint64_t>(i)));
      edge.add("/tf", 0.1 * i, test::transform("odom", "base_link", 0.1 * i));
    }
    motion.addObservations();
    edge.addObservations();
  }
  for (const auto* bag : {"motion.bag", "tf.bag"}) {
    ASSERT_EQ(faultOf(options(bag)), "") << bag;
    const auto trajectory = folder.read("run/trajectory.tum");
    EXPECT_EQ(std::count(trajectory.begin(), trajectory.end(), '\n'), 17) << bag;
  }
}

TEST_F(Offline, MetricsCountUpdatesAndCost) {
  ASSERT_EQ(faultOf(options()), "");
  const auto metrics = nlohmann::json::parse(folder.read("run/metrics.json"));
  EXPECT_EQ(metrics["updates"], 17);
  EXPECT_EQ(metrics["dropped_messages"], 0);
  for (const auto* key : {"update_ms_p50", "update_ms_p99", "latency_ms_p50", "latency_ms_p99",
                          "cpu_s", "wall_s", "realtime_factor", "max_rss_mb"})
    EXPECT_GT(metrics[key].get<double>(), 0.0) << key;
}

TEST_F(Offline, OverridesCountAndMisspeltOnesAreNamed) {
  auto changed = options();
  changed.overrides = {"ekf.initial_sigma_position=0.5"};
  ASSERT_EQ(faultOf(changed), "");
  EXPECT_TRUE(contains(folder.read("run/config.yaml"), "initial_sigma_position: 0.5"));
  changed.overrides = {"ekf.initial_sigma_positon=0.5"};
  EXPECT_TRUE(contains(faultOf(changed), "did you mean 'initial_sigma_position'"));
}

TEST_F(Offline, AModuleOfAForeignLibraryIsAKeyOfTheProduct) {
  auto odd = options();
  odd.product = folder.write("odd.yaml",
                             std::string("version: 1\nproduct: odd\necho_map: true\nlibraries: [") +
                                 ODD_COMPONENTS + "]\n");
  EXPECT_EQ(faultOf(odd), "");
  EXPECT_TRUE(contains(folder.read("run/config.yaml"), "echo_map: true"));
}

TEST_F(Offline, AnInputThatNoTopicCanBringIsRefusedBeforeTheRun) {
  auto odd = options();
  odd.product = folder.write(
      "odd.yaml", std::string("version: 1\nproduct: odd\nodometry: inertial\nlibraries: [") +
                      ODD_COMPONENTS + "]\n");
  const auto fault = faultOf(odd);
  EXPECT_TRUE(contains(fault, "the odometry source 'inertial' needs 'imu'")) << fault;
  EXPECT_FALSE(folder.has("run"));
}

TEST_F(Offline, TheBagNamesItsRobotUnlessOneIsGiven) {
  const auto other = folder.write("other.yaml", "version: 1\nrobot: other\n");
  BagMaker(folder / "named.bag").addOdometry().addObservations().addRobot(other);
  auto named = options("named.bag");
  ASSERT_EQ(faultOf(named), "");
  EXPECT_TRUE(contains(folder.read("run/config.yaml"), "robot: \"test\""));
  named.robot.clear();
  ASSERT_EQ(faultOf(named), "");
  EXPECT_TRUE(contains(folder.read("run/config.yaml"), "robot: \"other\""));
}

TEST_F(Offline, WithoutAnyRobotAsksForOne) {
  auto nameless = options();
  nameless.robot.clear();
  EXPECT_TRUE(contains(faultOf(nameless), "does not name its robot; give one with --robot"));
}

TEST_F(Offline, OtherTopicNamesComeFromTheRobotFileOrARemapping) {
  BagMaker(folder / "y.bag").addOdometry("/a").addOdometry("/b").addObservations("/seen");
  auto other = options("y.bag");
  EXPECT_TRUE(contains(faultOf(other), "could be any of /a"));
  other.remaps = {"odom:=/b"};
  EXPECT_EQ(faultOf(other), "");
  other.remaps.clear();
  other.overrides = {"topics.odom=b"};
  EXPECT_EQ(faultOf(other), "");
}

TEST_F(Offline, WrongNamesOfTopicsAreRefusedBeforeTheRun) {
  auto wrong = options();
  wrong.overrides = {"topics.odom="};
  EXPECT_TRUE(contains(faultOf(wrong), "topics.odom: '' is no name of a topic")) << faultOf(wrong);
  wrong.overrides = {"topics.odom=wheel odometry"};
  EXPECT_TRUE(contains(faultOf(wrong), "'wheel odometry' is no name of a topic")) << faultOf(wrong);
  wrong.overrides.clear();
  for (const auto& [remaps, fault] : std::map<std::string, std::string>{
           {"odom:=/observations", "the topic /observations cannot be the input odom"},
           {"scan:=/odom", "the topic /odom cannot be the input scan"},
           {"motion:=/nowhere", "joins no input with a topic of the bag"}}) {
    wrong.remaps = {remaps};
    EXPECT_TRUE(contains(faultOf(wrong), fault)) << faultOf(wrong);
  }
  wrong.remaps = {"odom:=/odom", "odom=/odom"};
  EXPECT_TRUE(contains(faultOf(wrong), "are of the same input 'odom'")) << faultOf(wrong);
  EXPECT_FALSE(folder.has("run"));
}

TEST_F(Offline, ObservationsThatNoOdometryCoversAreAFailureNotAnEmptyRun) {
  BagMaker(folder / "early.bag").addOdometry("/odom", 0.1).addObservations();
  testing::internal::CaptureStdout();
  EXPECT_TRUE(contains(faultOf(options("early.bag")), "no step could be taken"));
  EXPECT_TRUE(contains(testing::internal::GetCapturedStdout(), "counted: ")) << "what tells why";
  EXPECT_FALSE(folder.has("run/config.yaml"));
}

TEST_F(Offline, ExitCodesTellFailureFromWrongUse) {
  const auto rest = " --robot " + robot + " --out " + (folder / "run") + " --bag ";
  EXPECT_EQ(exitCode(product + rest + (folder / "x.bag")), 0) << folder.read("stderr");
  EXPECT_EQ(exitCode("--help"), 0);
  EXPECT_EQ(exitCode(product + rest + (folder / "missing.bag")), 1);
  EXPECT_TRUE(contains(folder.read("stderr"), "there is no such file"));
  EXPECT_EQ(exitCode(product + rest + (folder / "x.bag") + " --sed 3"), 2);
  EXPECT_TRUE(contains(folder.read("stderr"), "did you mean '--se"));
  EXPECT_EQ(exitCode(product), 2);
}

TEST_F(Offline, TruthIsWrittenAndThatOfAnEarlierRunTakenAway) {
  const auto counts = writeGroundTruth(BagReader(folder / "x.bag"), folder / "");
  EXPECT_EQ(counts.poses, 41u);
  EXPECT_EQ(counts.landmarks, 1u);
  EXPECT_TRUE(contains(folder.read("ground_truth.tum"),
                       "\n100.100000000 0.100000000 0.000000000 0.000000000 0.000000000 "
                       "0.000000000 0.000000000 1.000000000\n"));
  EXPECT_TRUE(contains(folder.read("ground_truth_landmarks.yaml"),
                       "frame: world\nunits: {position: m, angle: rad}\nlandmarks:\n  - {id: 1, "
                       "x: 5, y: 2, covariance: [0, 0, 0, 0]}\n"));
  BagMaker(folder / "untrue.bag").addOdometry();
  EXPECT_EQ(writeGroundTruth(BagReader(folder / "untrue.bag"), folder / "").poses, 0u);
  EXPECT_FALSE(folder.has("ground_truth.tum"));
  EXPECT_FALSE(folder.has("ground_truth_landmarks.yaml"));
}

TEST_F(Offline, TruthWithoutHeadingStaysWithoutOneAndNamesItsPoint) {
  geometry_msgs::PoseStamped fix;
  fix.header.stamp = ros::Time(101);
  fix.pose.position.x = 3.0;
  geometry_msgs::PointStamped antenna;
  antenna.point.x = 3.78;
  antenna.point.y = 0.5;
  BagMaker(folder / "gps.bag")
      .addOdometry()
      .add("/ground_truth/point", 0, antenna)
      .add("/ground_truth/pose", 1, fix);
  EXPECT_EQ(writeGroundTruth(BagReader(folder / "gps.bag"), folder / "").poses, 1u);
  EXPECT_EQ(folder.read("ground_truth.tum"),
            "# point of the robot: 3.780000000 0.500000000\n"
            "101.000000000 3.000000000 0.000000000 0.000000000 0 0 0 0\n");
}

TEST_F(Offline, TheStampsOfTheLogFollowItsBagIntoTheRun) {
  std::ofstream(folder / "x.bag.stamps.csv") << "source_stamp,written_stamp\n1.0,100.0\n";
  writeGroundTruth(BagReader(folder / "x.bag"), folder / "");
  EXPECT_EQ(folder.read("stamps.csv"), "source_stamp,written_stamp\n1.0,100.0\n");
  std::filesystem::remove(folder / "x.bag.stamps.csv");
  writeGroundTruth(BagReader(folder / "x.bag"), folder / "");
  EXPECT_FALSE(folder.has("stamps.csv")) << "that of an earlier run";
}

TEST_F(Offline, WheelsAreWrittenForRunsWhoseOdometryIsAnother) {
  EXPECT_FALSE(folder.has("run/wheel_odometry.tum")) << "this run's odometry is the wheels'";
  writeWheelOdometry(BagReader(folder / "x.bag"), folder / "");
  EXPECT_TRUE(contains(folder.read("wheel_odometry.tum"),
                       "\n100.100000000 0.100000000 0.000000000 0.000000000 0.000000000 "
                       "0.000000000 0.000000000 1.000000000\n"));
  BagMaker(folder / "other.bag").addOdometry("/elsewhere");
  writeWheelOdometry(BagReader(folder / "other.bag"), folder / "");
  EXPECT_FALSE(folder.has("wheel_odometry.tum")) << "of an earlier run";
}

}  // namespace
}  // namespace slam_ros
