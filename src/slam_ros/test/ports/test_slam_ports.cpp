// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace slam_ros {
namespace {

using Json = nlohmann::json;

struct Answer {
  int code = 0;
  std::string printed;  ///< to both streams
};

Answer ask(const std::string& words) {
  Answer answer;
  auto* pipe = ::popen((std::string(SLAM_PORTS) + " " + words + " 2>&1").c_str(), "r");
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) answer.printed += part.data();
  answer.code = WEXITSTATUS(::pclose(pipe));
  return answer;
}

/// A file of lines, which stays until the next one is written.
std::string linesFile(const std::vector<std::string>& lines) {
  const auto path = ::testing::TempDir() + "slam_ports_lines." + std::to_string(::getpid());
  std::ofstream file(path);
  for (const auto& line : lines) file << line << '\n';
  return path;
}

Json portsOf(const std::string& words) { return Json::parse(ask(words).printed); }

/// The same of a product with the components of the test's library.
Answer askWithOdd(const std::string& words) { return ask(words + " --library " + ODD_COMPONENTS); }

bool ownsEdge(const std::string& odometry) {
  return Json::parse(askWithOdd("odometry=" + odometry).printed)["owns_odometry_edge"].get<bool>();
}

/// Checks that an answer is a refusal of one sentence that says all of this.
void expectRefusal(const Answer& answer, const std::vector<std::string>& words) {
  EXPECT_EQ(answer.code, 1) << answer.printed;
  EXPECT_EQ(answer.printed.find('\n'), answer.printed.size() - 1) << answer.printed;
  for (const auto& word : words)
    EXPECT_NE(answer.printed.find(word), std::string::npos) << word << " in: " << answer.printed;
}

std::vector<std::string> namesOf(const Json& ports) {
  std::vector<std::string> names;
  for (const auto& port : ports) names.push_back(port["name"]);
  return names;
}

using Names = std::vector<std::string>;

TEST(SlamPorts, AnswerALineOfProductsEach) {
  const auto answer = ask("- < " + linesFile({"backend=pf", "backend=ekf map=landmarks"}));
  ASSERT_EQ(answer.code, 0) << answer.printed;
  std::istringstream lines(answer.printed);
  for (const auto* words : {"backend=pf", "backend=ekf map=landmarks"}) {
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(Json::parse(line), portsOf(words));
  }
}

TEST(SlamPorts, RefuseALineThatIsNoProduct) {
  expectRefusal(ask("- < " + linesFile({"backend=ekf", "backend=efk"})), {"efk"});
}

TEST(SlamPorts, GiveTheComponentsInTheOrderOfTheFlowWithWhoMakesTheirInputs) {
  const auto ports = portsOf("backend=pf odometry=wheel detector=apriltag pointmap=true");
  const auto& parts = ports["components"];
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0]["role"], "odometry source");
  EXPECT_EQ(parts[0]["name"], "wheel");
  EXPECT_TRUE(parts[0]["inputs"][0]["made_by"].is_null());
  EXPECT_EQ(parts[1]["key"], "detector");
  EXPECT_EQ(parts[2]["inputs"][0]["made_by"], "odometry");
  EXPECT_EQ(parts[2]["inputs"][1]["made_by"], "detector");
  EXPECT_EQ(parts[3]["inputs"][0]["gate"], "laser");
  EXPECT_EQ(parts[3]["inputs"][2]["made_by"], "backend");
  EXPECT_EQ(namesOf(parts[3]["outputs"]), Names{"points"});
  EXPECT_EQ(parts[3]["outputs"][0]["kind"], "slam::point_map::PointMap");
}

TEST(SlamPorts, GiveTheOutputsOfABackEndByItsCapabilities) {
  const auto backendOf = [](const std::string& words) {
    return namesOf(portsOf(words)["components"].back()["outputs"]);
  };
  EXPECT_EQ(backendOf("backend=ekf"), (Names{"pose", "path", "landmarks"}));
  EXPECT_EQ(backendOf("backend=pf"), (Names{"pose", "path", "landmarks", "particlecloud"}));
  EXPECT_EQ(backendOf("backend=pf map=grid"),
            (Names{"pose", "path", "landmarks", "particlecloud", "map"}));
}

TEST(SlamPorts, AnOdometryThatLooksThroughACameraShowsWhatItMakes) {
  EXPECT_EQ(namesOf(portsOf("odometry=visual")["components"][0]["outputs"]),
            (Names{"motion", "visual_odometry/odom"}));
  EXPECT_EQ(namesOf(portsOf("odometry=wheel")["components"][0]["outputs"]), Names{"motion"});
}

TEST(SlamPorts, StagesStandBetweenSensorsAndBackEnd) {
  const auto components = portsOf("backend=rat detector=none")["components"];
  ASSERT_EQ(components.size(), 4u);
  EXPECT_EQ(components[1]["role"], "stage");
  EXPECT_EQ(components[1]["key"], "local_view");
  EXPECT_EQ(components[2]["features"], Json({"backend"}));
  EXPECT_EQ(components[2]["inputs"][1]["made_by"], "local_view");
  EXPECT_EQ(components[3]["inputs"][1]["made_by"], "pose_cells");
}

TEST(SlamPorts, OnlyASourceThatMovesAlongTheDriversFrameLeavesItTheTransform) {
  EXPECT_FALSE(ownsEdge("wheel"));
  EXPECT_FALSE(ownsEdge("wheel_imu"));
  EXPECT_FALSE(ownsEdge("content"));  // it has no name, whatever else it takes in
  EXPECT_FALSE(ownsEdge("driven"));   // whatever it and its input are called
  EXPECT_FALSE(ownsEdge("none"));
  EXPECT_TRUE(ownsEdge("visual"));
  EXPECT_TRUE(ownsEdge("visual_wheel"));
  EXPECT_TRUE(ownsEdge("blind"));
}

TEST(SlamPorts, RefuseTwoComponentsThatMakeTheSame) {
  expectRefusal(askWithOdd("odometry=wheel detector=moving"),
                {"two components make 'motion' (slam::Motion)", "the odometry source 'wheel'",
                 "the detector 'moving'", "leave one of them out"});
  EXPECT_EQ(askWithOdd("odometry=none detector=moving --check").code, 0);
}

TEST(SlamPorts, RefuseComponentsThatTakeDataFromOneAnotherInACircle) {
  expectRefusal(
      askWithOdd("odometry=wheel detector=peeking --check"),
      {"in a circle", "the back-end 'ekf' takes 'observations'", "from the detector 'peeking'",
       "the detector 'peeking' takes 'pose'", "from the back-end 'ekf'", "leave one of them out"});
}

TEST(SlamPorts, RefuseAnInputThatNobodyMakesAndNoTopicBrings) {
  expectRefusal(askWithOdd("odometry=inertial --check"),
                {"the odometry source 'inertial' needs 'imu' (slam_odd::InertialSample)",
                 "no component of the product makes and no topic brings", "slam::OdometrySample"});
  expectRefusal(
      askWithOdd("odometry=steered detector=apriltag"),
      {"the odometry source 'steered' needs 'observation'", "did you mean 'observations'?"});
}

TEST(SlamPorts, TakeAnInputThatAComponentCanDoWithoutAndAnyNameOfAKnownKind) {
  const auto answer = askWithOdd("odometry=content --check");
  EXPECT_EQ(answer.code, 0) << answer.printed;
  EXPECT_EQ(answer.printed, "");
}

TEST(SlamPorts, NameAllComponentsByTheProductsKey) {
  const auto names = Json::parse(askWithOdd("--components").printed);
  EXPECT_EQ(names["backend"],
            Json({"ekf", "graph", "grid", "mono_ekf", "mono_graph", "pf", "rat", "seif"}));
  EXPECT_EQ(names["association"], Json({"descriptor", "jcbb", "known_ids", "nearest"}));
  EXPECT_EQ(names["modules"], Json({"echo_map", "pointmap"}));
  EXPECT_EQ(ask("--components ekf_wheel").code, 2);
}

TEST(SlamPorts, RefuseWhatIsNoProduct) {
  expectRefusal(ask("backend=ekf --library libslam_nowhere.so"),
                {"cannot load the product's library libslam_nowhere.so"});
  expectRefusal(ask("backend=efk"), {"back-end 'efk' is not known", "did you mean 'ekf'?"});
  expectRefusal(ask("bakend=ekf"), {"bakend", "did you mean 'backend'?"});
  expectRefusal(ask("backend=ekf map=grid"), {"'ekf' makes no grid"});
  EXPECT_EQ(ask("").code, 2);
  EXPECT_EQ(ask("--chek backend=ekf").code, 2);
}

}  // namespace
}  // namespace slam_ros
