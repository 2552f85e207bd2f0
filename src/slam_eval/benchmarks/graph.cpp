// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "false_loops.hpp"
#include "g2o_graph.hpp"
#include "graph_report.hpp"
#include "graph_truth.hpp"
#include "graph_world.hpp"
#include "import_error.hpp"
#include "slam_core/common/progress.hpp"

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
  std::string g2o, truth;
  std::uint64_t world = 0, seed = 1;
  GraphWorldConfig city;
  int false_loops = 0;
  FalseLoopKind kind = FalseLoopKind::kRandom;
  std::size_t limit = 0;
  bool detail = false, robust = false;
};

/// Of this process so far [MB].
double peakMemory() {
  std::ifstream status("/proc/self/status");
  double kibibytes = 0.0;
  for (std::string word; status >> word;)
    if (word == "VmHWM:") status >> kibibytes;
  return kibibytes * 1024e-6;
}

PoseGraph load(const Options& options) {
  PoseGraph graph;
  if (options.g2o.empty()) {
    graph = makeGraphWorld(options.city, options.world);
  } else {
    requireFile(options.g2o);
    graph = readG2o(options.g2o);
  }
  if (!options.truth.empty()) {
    requireFile(options.truth);
    graph.truth = readGraphTruth(options.truth, graph.ids);
  }
  if (options.limit > 0) keepFirst(graph, options.limit);
  addFalseLoops(graph, options.kind, options.false_loops, options.seed);
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

void addGraphOptions(CLI::App& app, Options& options) {
  auto& source = *app.add_option_group("graph", "what is solved");
  auto* g2o = source.add_option("--g2o", options.g2o, "file of poses and edges in the plane");
  auto* world = source.add_option("--world", options.world, "seed of a city to drive in")
                    ->check(CLI::NonNegativeNumber);
  source.require_option(1);
  app.add_option("--truth", options.truth, "file of the true poses: x y theta or id x y theta")
      ->needs(g2o);
  const auto addCity = [&](const char* name, auto& value, const char* what) {
    return app.add_option(name, value, what)->needs(world)->capture_default_str();
  };
  addCity("--poses", options.city.poses, "of the drive, 1 m apart")->check(CLI::Range(2, 1000000));
  addCity("--sigma-position", options.city.sigma_position, "of a measurement [m]")
      ->check(CLI::PositiveNumber);
  addCity("--sigma-heading", options.city.sigma_heading, "of a measurement [rad]")
      ->check(CLI::PositiveNumber);
}

void addOptions(CLI::App& app, Options& options) {
  addGraphOptions(app, options);
  app.add_option("--limit", options.limit, "only the first poses")->check(CLI::Range(2, 1000000));
  app.add_option("--false-loops", options.false_loops, "so many are added")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--kind", options.kind, "of the false loops")
      ->transform(CLI::CheckedTransformer(kKinds))
      ->option_text("random (default), local, random_groups or local_groups");
  app.add_option("--seed", options.seed, "of the false loops")->capture_default_str();
  app.add_flag("--robust", options.robust, "any loop may be false; without Ceres");
  app.add_flag("--detail", options.detail, "print poses, loops and the time of each step as well");
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  CLI::App app("Solves a graph of poses at every pose, and at once by Ceres: CPU time and chi2");
  slam::eval::Options options;
  slam::eval::addOptions(app, options);
  try {
    app.parse(argc, argv);
    slam::eval::run(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const slam::eval::UsageError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
