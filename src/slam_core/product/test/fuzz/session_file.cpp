// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <vector>

#include "slam_core/common/sealed_bytes.hpp"
#include "slam_core/common/test/fuzz/changed_bytes.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/product/test/drive_invariants.hpp"

namespace slam {
namespace {

using test::requireThat;

struct DrivenGraph {
  std::vector<std::string> settings;
  bool has_scans;
  std::string session = {};

  std::unique_ptr<MetaCoordinator> made() const {
    Settings configuration({}, {}, settings);
    auto product = std::make_unique<MetaCoordinator>();
    product->configure(configuration);
    return product;
  }
};

void drive(const DrivenGraph& graph, MetaCoordinator& product, int steps) {
  test::FaultWorld world(1, graph.has_scans, true);
  test::DriveInvariants invariants;
  for (auto& input : world.begin()) input(product);
  for (int i = 0; i < steps; ++i)
    for (const auto& message : world.next()) {
      std::visit([&product](const auto& value) { product.set(value); }, message);
      invariants.check(product.execute());
      if (const auto& report = product.estimator().report())
        invariants.check(*report, world.truths());
    }
  requireThat(invariants.hold(), invariants.broken());
}

const std::vector<DrivenGraph>& graphs() {
  static const std::vector<DrivenGraph> kGraphs = [] {
    std::vector<DrivenGraph> graphs = {{{"backend=graph"}, false},
                                       {{"backend=graph", "map=grid", "graph.submap_way=1"}, true}};
    for (auto& graph : graphs) {
      const auto product = graph.made();
      drive(graph, *product, 15);
      graph.session = product->estimator().capabilities().find<SessionKeeper>()->session().bytes;
    }
    return graphs;
  }();
  return kGraphs;
}

/// The session with a changed content and a checksum that fits.
std::string resealed(const std::string& session, test::FuzzBytes& bytes) {
  constexpr std::size_t kHead = 20, kTail = 8;  // letters, version and size; checksum
  const auto content = session.substr(kHead, session.size() - kHead - kTail);
  std::uint32_t version = 0;
  std::memcpy(&version, session.data() + 8, sizeof(version));
  return sealed({"SLAMGRPH", version, "", ""}, test::changed(content, bytes));
}

}  // namespace
}  // namespace slam

/// A session of the graph that somebody has changed: it is refused with a sentence, or the graph
/// goes on with it.
SLAM_FUZZ_TARGET(session_file) {
  using namespace slam;
  test::FuzzBytes source(bytes, size);
  const auto& graph = graphs()[source.below(graphs().size())];
  const auto product = graph.made();
  const bool is_damaged = source.below(8) == 0;
  const auto session =
      is_damaged ? test::changed(graph.session, source) : resealed(graph.session, source);
  const auto status = product->set(SavedSession{session});
  const bool is_refused = status.level == Status::Level::kError;
  requireThat(!is_refused || !status.message.empty(), "a refusal without a sentence");
  requireThat(!is_damaged || is_refused || session == graph.session,
              "a damaged session was accepted");
  drive(graph, *product, 3);
}
