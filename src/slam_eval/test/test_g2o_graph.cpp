// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "g2o_graph.hpp"
#include "graph_truth.hpp"
#include "import_error.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

const std::string kInformation = " 4 1 0 5 2 6\n";  // positive definite
const std::string kVertices = "VERTEX_SE2 0 1 2 0.5\nVERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 0 0 0\n";
const std::string kChain =
    "EDGE_SE2 0 1 1 0 0.1" + kInformation + "EDGE_SE2 1 2 2 0 0.2" + kInformation;

/// A file g.g2o in a folder of its own.
class GraphFile {
 public:
  explicit GraphFile(const std::string& text) { folder_.write("g.g2o", text); }
  PoseGraph read() const { return readG2o(folder_.file("g.g2o")); }
  std::string fault() const {
    return messageOf<ImportError>([this] { read(); });
  }

 private:
  TempFolder folder_;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(G2oGraph, ReadsPosesEdgesAndTheUpperTriangleOfTheInformation) {
  const auto graph = GraphFile("# a comment\n" + kVertices + kChain).read();
  EXPECT_EQ(graph.name, "g");
  EXPECT_EQ(graph.size(), 3u);
  EXPECT_EQ(graph.start.vector(), Eigen::Vector3d(1, 2, 0.5));
  ASSERT_EQ(graph.edges.size(), 2u);
  EXPECT_EQ(graph.edges[1].a, 1);
  EXPECT_EQ(graph.edges[1].b, 2);
  EXPECT_EQ(graph.edges[1].z.vector(), Eigen::Vector3d(2, 0, 0.2));
  Eigen::Matrix3d expected;
  expected << 4, 1, 0, 1, 5, 2, 0, 2, 6;
  EXPECT_EQ(graph.edges[0].information, expected);
}

TEST(G2oGraph, TakesIdsRecordsAndDirectionsInAnyOrder) {
  const auto graph = GraphFile("EDGE_SE2 70 -3 -2 0 0" + kInformation +
                               "VERTEX_SE2 8646911284551352321 0 0 0\nVERTEX_SE2 70 0 0 0\n"
                               "EDGE_SE2 70 8646911284551352321 3 0 0" +
                               kInformation + "VERTEX_SE2 -3 5 0 0\n")
                         .read();
  EXPECT_EQ(graph.ids, (std::vector<std::int64_t>{-3, 70, 8646911284551352321}));
  const auto poses = deadReckoning(graph);
  EXPECT_NEAR(poses[1].x(), 7.0, 1e-12);   // against the direction of the edge
  EXPECT_NEAR(poses[2].x(), 10.0, 1e-12);  // along it
  EXPECT_NEAR(chi2(graph, poses), 0.0, 1e-12);
}

TEST(G2oGraph, ComesToNoPoseBeforeOneThatItIsJoinedTo) {
  const auto graph = GraphFile(kVertices + "EDGE_SE2 2 0 1 0 0" + kInformation +
                               "EDGE_SE2 1 2 1 0 0" + kInformation)
                         .read();
  EXPECT_EQ(graph.ids, (std::vector<std::int64_t>{0, 2, 1}));
  EXPECT_EQ(edgesByPose(graph)[2].size(), 1u);
}

TEST(G2oGraph, CountsRecordsOfOtherTypes) {
  const auto graph =
      GraphFile(kVertices + kChain + "FIX 0\nVERTEX_XY 7 1 2\nVERTEX_XY 8 1\n").read();
  EXPECT_EQ(graph.left_out, (std::map<std::string, int>{{"FIX", 1}, {"VERTEX_XY", 2}}));
}

TEST(G2oGraph, NamesPlaceFaultAndRemedyOfABadLine) {
  const std::pair<const char*, const char*> bad[] = {
      {"EDGE_SE2 0 1 1 0 0.1 4 1 0 5\n", "EDGE_SE2 has 9 values instead of 11"},
      {"VERTEX_SE2 3 0 0\n", "VERTEX_SE2 has 3 values instead of 4"},
      {"EDGE_SE2 0 1 nan 0 0 4 1 0 5 2 6\n", "column 4 is 'nan', expected a number"},
      {"EDGE_SE2 0 1 1 0 0 4 1 inf 5 2 6\n", "column 9 is 'inf', expected a number"},
      {"EDGE_SE2 0 1.5 1 0 0 4 1 0 5 2 6\n", "column 3 is '1.5', expected a whole number"},
      {"EDGE_SE2 0 1 1 0 0 4 9 0 5 2 6\n", "the information matrix is not positive definite"},
      {"EDGE_SE2 0 1 1 0 0 0 0 0 0 0 0\n", "the information matrix is not positive definite"},
      {"EDGE_SE2 1 1 1 0 0 4 1 0 5 2 6\n", "the edge joins the vertex 1 to itself"},
      {"VERTEX_SE2 2 0 0 0\n", "the vertex 2 stands already in "}};
  for (const auto& [line, expected] : bad) {
    const auto fault = GraphFile(kVertices + line + kChain).fault();
    EXPECT_TRUE(holds(fault, "g.g2o:4: ")) << fault;
    EXPECT_TRUE(holds(fault, expected)) << fault;
    EXPECT_TRUE(holds(fault, "; correct this line or write the file anew")) << fault;
  }
}

TEST(G2oGraph, NamesAVertexThatNothingJoinsToTheRest) {
  const auto alone = GraphFile(kVertices + "VERTEX_SE2 9 0 0 0\n" + kChain).fault();
  EXPECT_TRUE(holds(alone, "g.g2o:4: no edge joins the vertex 9 to the vertex 0")) << alone;
  EXPECT_TRUE(holds(alone, "1 of 4 vertices); add the missing edges")) << alone;
  const auto missing = GraphFile(kVertices + kChain + "EDGE_SE2 2 7 1 0 0" + kInformation).fault();
  EXPECT_TRUE(holds(missing, "g.g2o:6: the edge joins the vertex 7, which has no VERTEX_SE2"))
      << missing;
}

TEST(G2oGraph, RefusesAFileThatIsMissingOrHoldsNoPosesInThePlane) {
  const auto missing = messageOf<ImportError>([] { readG2o("/no/such.g2o"); });
  EXPECT_TRUE(holds(missing, "cannot read /no/such.g2o: it does not exist")) << missing;
  EXPECT_TRUE(holds(GraphFile("VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n").fault(),
                    "there is no VERTEX_SE2; give a graph of poses in the plane"));
  EXPECT_TRUE(holds(GraphFile(kVertices).fault(), "there is no EDGE_SE2"));
  EXPECT_TRUE(holds(GraphFile("").fault(), "holds no rows"));
}

TEST(PoseGraph, KeepsTheFirstPosesAndTheEdgesBetweenThem) {
  auto graph = GraphFile(kVertices + kChain).read();
  graph.truth.resize(3);
  keepFirst(graph, 2);
  EXPECT_EQ(graph.size(), 2u);
  EXPECT_EQ(graph.truth.size(), 2u);
  EXPECT_EQ(graph.edges.size(), 1u);
  keepFirst(graph, 9);
  EXPECT_EQ(graph.size(), 2u);
}

TEST(GraphTruth, HasRowsInTheOrderOfIdsOrRowsWithIds) {
  const TempFolder folder;
  folder.write("plain.txt", "1 0 0\n2 0 0\n3 0 0.5\n");
  folder.write("named.txt", "7 3 0 0.5\n9 9 9 9\n-1 1 0 0\n5 2 0 0\n");
  for (const auto* name : {"plain.txt", "named.txt"}) {
    const auto truth = readGraphTruth(folder.file(name), {-1, 7, 5});
    ASSERT_EQ(truth.size(), 3u);
    EXPECT_EQ(truth[0].vector(), Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(truth[1].vector(), Eigen::Vector3d(3, 0, 0.5));
    EXPECT_EQ(truth[2].vector(), Eigen::Vector3d(2, 0, 0));
  }
}

TEST(GraphTruth, RefusesThatOfAnotherGraph) {
  const TempFolder folder;
  const auto fault = [&folder](const std::string& text) {
    folder.write("t.txt", text);
    return messageOf<ImportError>([&folder] { readGraphTruth(folder.file("t.txt"), {0, 1}); });
  };
  EXPECT_TRUE(holds(fault("1 0 0\n"), "t.txt holds 1 poses, but the graph 2"));
  EXPECT_TRUE(holds(fault("0 1 0 0\n"), "t.txt has no true pose 1; give the truth of this graph"));
  EXPECT_TRUE(holds(fault("0 1 0 0\n0 1 0 0\n"), "t.txt:2: the pose 0 stands there twice"));
  EXPECT_TRUE(holds(fault("0 0 0\n0 0 x\n"), "t.txt:2: column 3 is 'x', expected a number"));
  EXPECT_TRUE(holds(fault("0 0 0\n0 0\n"), "t.txt:2: 2 columns, expected 3"));
}

}  // namespace
}  // namespace slam::eval
