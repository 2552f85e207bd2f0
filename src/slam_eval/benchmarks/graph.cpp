// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include "false_loops.hpp"
#include "g2o_graph.hpp"
#include "graph_report.hpp"
#include "graph_truth.hpp"
#include "graph_world.hpp"
#include "import_error.hpp"
#include "slam_core/common/nearest_name.hpp"
#include "slam_core/common/progress.hpp"
#include "slam_ros/command_line.hpp"

// Solves a graph of poses at every pose, as a robot on its way does, and prints what that costs and
// how near it comes to what Ceres makes of the whole graph at once. slam_bench makes the table.

namespace slam::eval {
namespace {

const std::map<std::string, FalseLoopKind> kKinds = {
    {"random", FalseLoopKind::kRandom},
    {"local", FalseLoopKind::kLocal},
    {"random_groups", FalseLoopKind::kRandomGroups},
    {"local_groups", FalseLoopKind::kLocalGroups}};

struct Options {
  std::string g2o, truth, kind = "random";
  std::optional<std::uint64_t> world;
  std::uint64_t seed = 1;
  GraphWorldConfig city;
  int false_loops = 0;
  std::size_t limit = 0;
  bool detail = false, robust = false;
};

/// @throw UsageError
FalseLoopKind kindOf(const std::string& name) {
  const auto kind = kKinds.find(name);
  if (kind != kKinds.end()) return kind->second;
  std::vector<std::string> names;
  for (const auto& entry : kKinds) names.push_back(entry.first);
  throw UsageError("there is no kind of false loops '" + name + "'" + didYouMean(name, names) +
                   "; there are: " + join(names));
}

/// Of this process so far [MB].
double peakMemory() {
  std::ifstream status("/proc/self/status");
  double kibibytes = 0.0;
  for (std::string word; status >> word;)
    if (word == "VmHWM:") status >> kibibytes;
  return kibibytes * 1024e-6;
}

PoseGraph load(const Options& options) {
  if (!options.world && options.g2o.empty())
    throw UsageError("--g2o or --world is required; --help lists the options");
  const auto kind = kindOf(options.kind);
  PoseGraph graph;
  if (options.world) {
    graph = makeGraphWorld(options.city, *options.world);
  } else {
    requireFile(options.g2o);
    graph = readG2o(options.g2o);
  }
  if (!options.truth.empty()) {
    requireFile(options.truth);
    graph.truth = readGraphTruth(options.truth, graph.ids);
  }
  if (options.limit > 0) keepFirst(graph, options.limit);
  addFalseLoops(graph, kind, options.false_loops, options.seed);
  return graph;
}

SolvedGraph solve(const PoseGraph& graph, bool is_robust) {
  Progress progress(std::cerr, ::isatty(STDERR_FILENO) == 1);
  SolvedGraph solved;
  solved.is_robust = is_robust;
  progress.begin("poses", graph.size());
  solved.steps = solveIncrementally(graph, is_robust,
                                    [&progress](std::size_t done) { progress.update(done); });
  solved.memory_mb = peakMemory();
  if (is_robust) return solved;  // Ceres takes every loop for a true one
  progress.begin("Ceres", 2);
  solved.batch = solveByCeres(graph, deadReckoning(graph));
  progress.update(1);
  solved.polished = solveByCeres(graph, solved.steps.poses);
  progress.end();
  return solved;
}

void run(const Options& options) {
  const auto graph = load(options);
  for (const auto& [type, count] : graph.left_out)
    std::fprintf(
        stderr,
        "%s: records of type %s are not used, only VERTEX_SE2 and EDGE_SE2 are; there are %d\n",
        options.g2o.c_str(), type.c_str(), count);
  const auto solved = solve(graph, options.robust);
  auto report = summary(graph, solved);
  if (options.detail) report.update(details(graph, solved));
  std::puts(report.dump(options.detail ? -1 : 1).c_str());
}

void addGraphOptions(slam_ros::CommandLine& line, Options& options) {
  const auto g2o = line.add("--g2o", options.g2o, "file of poses and edges in the plane");
  const auto world = line.add("--world", options.world, "seed of a city to drive in").excludes(g2o);
  line.add("--truth", options.truth, "file of the true poses: x y theta or id x y theta")
      .needs(g2o);
  const auto addCity = [&](const char* name, auto& value, const char* what) {
    return line.add(name, value, what).needs(world).withDefault();
  };
  addCity("--poses", options.city.poses, "of the drive, 1 m apart").between(2, 1000000);
  addCity("--sigma-position", options.city.sigma_position, "of a measurement [m]").positive();
  addCity("--sigma-heading", options.city.sigma_heading, "of a measurement [rad]").positive();
}

void addOptions(slam_ros::CommandLine& line, Options& options) {
  addGraphOptions(line, options);
  line.add("--limit", options.limit, "only the first poses").between(2, 1000000);
  line.add("--false-loops", options.false_loops, "so many are added").nonNegative().withDefault();
  line.add("--kind", options.kind,
           "of the false loops: random, local, random_groups or local_groups")
      .withDefault();
  line.add("--seed", options.seed, "of the false loops").withDefault();
  line.add("--robust", options.robust, "any loop may be false; without Ceres");
  line.add("--detail", options.detail, "print poses, loops and the time of each step as well");
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_graph",
      "Solves a graph of poses at every pose, and at once by Ceres: CPU time and chi2");
  slam::eval::Options options;
  slam::eval::addOptions(line, options);
  return line.run(argc, argv, [&] { slam::eval::run(options); });
}
