// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <memory>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam::graph_slam {
namespace {

using test::oneSays;
using test::sentenceOf;
using test::TemporaryFolder;

/// Two nodes that see a landmark, the second one with a scan.
Session small() {
  Session session;
  session.kind = {true, 0.05};
  session.nodes = {Pose2(), Pose2(1.0, 0.0, 0.1)};
  session.landmarks = {{7, {3.0, 1.0}, 2, 1}};
  const Eigen::Matrix3d W = 10.0 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix2d V = 5.0 * Eigen::Matrix2d::Identity();
  session.factors = {
      Session::PosePrior{0, Pose2(), W},
      Session::Between{0, 1, session.nodes[1], W},
      Session::RangeBearing{1, 0, Pose2(0.1, 0.0, 0.0), {2.0, 0.3}, V},
      Session::PointPrior{0, {3.0, 1.0}, V},
      Session::JointPrior{0, {0}, Pose2(), {{3.0, 1.0}}, Eigen::MatrixXd::Identity(5, 5)},
      Session::Between{0, 1, session.nodes[1], 0.5 * W}};
  session.chords = {5};
  session.loops = {{{0, 1, session.nodes[1], W}, true, 0.5, false}};
  session.sightings_node = 1;
  session.sightings = {{2, {7, 2.0, 0.3, Eigen::Matrix2d::Identity()}, Pose2(0.1, 0.0, 0.0)}};
  session.path = {{stampFromNanoseconds(-5), std::nullopt, Pose2()},
                  {stampFromNanoseconds(9), 1, Pose2(0.0, 0.0, M_PI)}};
  session.robot.node = 1;
  session.robot.motion.emplace();
  session.robot.motion->odometry_frame = "odom";
  session.robot.nodes = 2;
  auto scan = std::make_shared<LaserScan>();
  scan->sensor_frame = "laser";
  scan->beams = {{0.1f, 2.0f, true}, {0.2f, 30.0f, false}};
  session.scans = {{1, session.nodes[1], scan}};
  session.submaps.last =
      Session::Place{1, {session.nodes[1], Eigen::Matrix3d::Zero()}, session.robot.motion};
  session.submaps.reference = Session::Place{0, {}, std::nullopt};
  session.submaps.older = Session::Submap{1, Pose2(), false, {{0, Pose2()}}, 0.0};
  return session;
}

std::vector<std::string> said(const std::string& bytes) {
  return {sentenceOf([&] { sessionOf(bytes); })};
}

/// @return what is said of the small session after a change, with a checksum that fits
std::vector<std::string> saidOf(const std::function<void(Session&)>& change) {
  auto session = small();
  change(session);
  return said(bytesOf(session));
}

TEST(SessionFile, ComesBackToTheBit) {
  auto session = small();
  session.nodes[1] = Pose2(1.0 / 3.0, -0.0, std::nextafter(M_PI, 0.0));
  const auto bytes = bytesOf(session);
  EXPECT_EQ(bytesOf(sessionOf(bytes)), bytes);
  const auto back = sessionOf(bytes);
  EXPECT_EQ(back.nodes[1].x(), 1.0 / 3.0);
  EXPECT_TRUE(std::signbit(back.nodes[1].y()));
  EXPECT_EQ(back.scans[0].scan->beams[1].range, 30.0f);
  EXPECT_EQ(back.robot.motion->odometry_frame, "odom");
  EXPECT_EQ(nanoseconds(back.path[0].stamp), -5);
}

TEST(SessionFile, HasTheScansOfASecondLaserBehindAllElse) {
  auto session = small();
  const auto of_one = bytesOf(session);
  auto joined = std::make_shared<LaserScan>(*session.scans[0].scan);
  joined->further = {{}};
  joined->further[0].sensor_pose = Pose2(-0.2, 0.1, 3.0);
  joined->further[0].relative_sigma = 0.02;
  joined->further[0].beams = {{-0.5f, 1.5f, true}};
  session.scans[0].scan = joined;
  const auto bytes = bytesOf(session);
  EXPECT_GT(bytes.size(), of_one.size());
  EXPECT_EQ(bytesOf(sessionOf(bytes)), bytes);
  const auto back = sessionOf(bytes).scans[0].scan;
  ASSERT_EQ(back->further.size(), 1u);
  EXPECT_EQ(back->further[0].sensor_pose.vector(), joined->further[0].sensor_pose.vector());
  EXPECT_EQ(back->further[0].beams[0].range, 1.5f);
  EXPECT_TRUE(sessionOf(of_one).scans[0].scan->further.empty());
  joined = std::make_shared<LaserScan>(*joined);
  joined->further[0].beams[0].range = -1.0f;
  session.scans[0].scan = joined;
  EXPECT_TRUE(oneSays(said(bytesOf(session)), {"a negative range"}));
}

TEST(SessionFile, IsLittleEndian) {
  const auto bytes = bytesOf(Session());
  EXPECT_EQ(bytes.substr(0, 8), "SLAMGRPH");
  EXPECT_EQ(bytes.substr(8, 4), std::string("\3\0\0\0", 4));
  const auto size = bytes.size() - 28;  // of the content
  EXPECT_EQ(static_cast<unsigned char>(bytes[12]), size % 256);
  EXPECT_EQ(static_cast<unsigned char>(bytes[13]), size / 256);
}

TEST(SessionFile, IsWrittenAndReadByName) {
  const TemporaryFolder folder;
  writeSession(folder / "a.session", small());
  EXPECT_EQ(bytesOf(readSession(folder / "a.session")), bytesOf(small()));
  std::ofstream(folder / "b.session") << "no such thing";
  EXPECT_TRUE(oneSays({sentenceOf([&] { readSession(folder / "b.session"); })},
                      {"cannot use the session", "b.session", "no session", "save_session"}));
  EXPECT_TRUE(oneSays({sentenceOf([&] { readSession(folder / "c.session"); })},
                      {"cannot read the session", "does it exist?"}));
}

TEST(SessionFile, ThatIsCutOrLongerIsRefused) {
  const auto bytes = bytesOf(small());
  for (std::size_t size = 8; size < bytes.size(); size += 7)
    EXPECT_TRUE(oneSays(said(bytes.substr(0, size)), {"cut", "copy it again"})) << size;
  EXPECT_TRUE(oneSays(said(bytes + "x"), {"cut or has grown"}));
  EXPECT_TRUE(oneSays(said(""), {"no session of the graph"}));
}

TEST(SessionFile, WithAFlippedBitIsRefused) {
  const auto bytes = bytesOf(small());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 4);
    EXPECT_NE(said(flipped).front(), "") << "byte " << i;
  }
}

TEST(SessionFile, OfAnotherVersionIsRefused) {
  auto bytes = bytesOf(small());
  for (const char version : {1, 2, 4}) {
    bytes[8] = version;
    const auto number = "is of version " + std::to_string(version);
    EXPECT_TRUE(
        oneSays(said(bytes), {number.c_str(), "reads version 3", "the program that has saved it"}));
  }
}

TEST(SessionFile, WithValuesThatAreNotFiniteIsRefused) {
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.nodes[1] = Pose2(NAN, 0, 0); }), {"not finite"}));
  EXPECT_TRUE(oneSays(
      saidOf([](Session& it) { std::get<Session::RangeBearing>(it.factors[2]).z.x() = INFINITY; }),
      {"not finite"}));
}

TEST(SessionFile, WithNumbersOfWhatIsNotThereIsRefused) {
  const auto node = {"names a node"}, landmark = {"names a landmark"};
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { std::get<Session::Between>(it.factors[1]).to = 2; }), node));
  EXPECT_TRUE(oneSays(
      saidOf([](Session& it) { std::get<Session::RangeBearing>(it.factors[2]).landmark = 9; }),
      landmark));
  EXPECT_TRUE(oneSays(
      saidOf([](Session& it) { std::get<Session::PointPrior>(it.factors[3]).landmark = 1; }),
      landmark));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.loops[0].between.from = 5; }), node));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.path[1].node = 5; }), node));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.robot.node = 5; }), node));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.scans[0].node = 5; }), node));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.last->node = 5; }), node));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.reference->node = 5; }), node));
  const auto chord = {"second motion to a node that it does not hold"};
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.chords[0] = 6; }), chord));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.chords[0] = 2; }), chord));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.chords.push_back(5); }), chord));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.older->origin = 5; }), node));
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.submaps.older->scans[0].scan = 5; }), {"names a scan"}));
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.sightings[0].factor = 1; }), {"last node has seen"}));
}

TEST(SessionFile, WithCovariancesThatAreNoneIsRefused) {
  const auto none = {"covariance that is not positive definite"};
  EXPECT_TRUE(oneSays(
      saidOf([](Session& it) { std::get<Session::PosePrior>(it.factors[0]).weight.setZero(); }),
      none));
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.loops[0].between.weight.col(1).setZero(); }), none));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.robot.motion->covariance(0, 0) = -1.0; }),
                      {"not symmetric or is negative"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.robot.start.covariance(0, 1) = 1.0; }),
                      {"not symmetric or is negative"}));
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.submaps.reference->in_odom.covariance(0, 1) = 1.0; }),
              {"not symmetric or is negative"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.last->told->covariance(0, 0) = -1.0; }),
                      {"not symmetric or is negative"}));
}

TEST(SessionFile, OfWhatDoesNotHangTogetherIsRefused) {
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.nodes.emplace_back(); }), {"does not hang together"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) {
                        it.landmarks.push_back({8, {0, 0}, 0, 0});
                      }),
                      {"does not hang together"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { std::get<Session::Between>(it.factors[1]).to = 0; }),
                      {"ties a node to itself"}));
}

TEST(SessionFile, WithIdsThatRepeatIsRefused) {
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.landmarks.push_back(it.landmarks[0]); }),
                      {"landmark 7 twice"}));
  EXPECT_TRUE(
      oneSays(saidOf([](Session& it) { it.landmarks[0].id = kUnknownId; }), {"without an id"}));
}

TEST(SessionFile, WithPartsThatDoNotFitIsRefused) {
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.kind.has_grid = false; }), {"has no grid"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.kind.resolution = -1.0; }), {"resolution"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.older->scans.clear(); }),
                      {"submap without scans"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.older->is_base = true; }),
                      {"grid it began with"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) {
                        it.submaps.older->is_base = true;
                        it.base.emplace();
                        it.base->resolution = 0.05;
                        it.base->width = it.base->height = 4000000000u;
                      }),
                      {"as many cells"}));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.loops[0].share = 1.5; }), {"no share"}));
  const auto places = {"nodes that its scans go by"};
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.submaps.reference.reset(); }), places));
  EXPECT_TRUE(oneSays(saidOf([](Session& it) { it.robot.node.reset(); }), places));
  EXPECT_TRUE(oneSays(
      saidOf([](Session& it) { std::get<Session::JointPrior>(it.factors[4]).points.clear(); }),
      {"not as large as the landmarks"}));
}

}  // namespace
}  // namespace slam::graph_slam
