// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/landmark_file.hpp"

#include <stdexcept>

#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/product/test/drive_invariants.hpp"

namespace slam {
namespace {

using test::requireThat;

/// The map is used or refused by a product with this back-end, which drives on in any case.
void drive(const std::string& backend, const MapState& map) {
  std::vector<std::string> options = {"backend=" + backend};
  if (backend == "pf") options.push_back("pf.particles=3");
  Settings settings({}, {}, options);
  MetaCoordinator product;
  product.configure(settings);
  product.set(map);
  test::FaultWorld world(1, false, true);
  test::DriveInvariants invariants;
  for (auto& input : world.begin()) input(product);
  for (int i = 0; i < 4; ++i)
    for (const auto& message : world.next()) {
      std::visit([&product](const auto& value) { product.set(value); }, message);
      invariants.check(product.execute());
      if (const auto& report = product.estimator().report())
        invariants.check(*report, world.truths());
    }
  invariants.checkEnd(product);
  requireThat(invariants.hold(), backend + ": " + invariants.broken());
}

}  // namespace
}  // namespace slam

/// A map of landmarks: it is refused with a sentence, or it comes back as it is and every back-end
/// goes on with it.
SLAM_FUZZ_TARGET(landmark_file) {
  using namespace slam;
  static const test::TemporaryFolder kFolder;
  const auto path = kFolder.write("landmarks.yaml", test::contentOf(bytes, size));
  LandmarkFile file;
  try {
    file = loadLandmarks(path, "map");
  } catch (const std::runtime_error& refused) {
    test::requireSentence(refused);
    return;
  }
  const auto text = toYaml(file);
  saveLandmarks(path, file);
  requireThat(toYaml(loadLandmarks(path, "map")) == text, "a saved map that comes back otherwise");
  for (const auto* backend : {"ekf", "pf", "graph", "seif"}) drive(backend, file.map);
}
