// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/checkpoint.hpp"

#include <stdexcept>
#include <vector>

#include "slam_core/common/test/fuzz/changed_bytes.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/product_drives.hpp"

namespace slam {
namespace {

using test::requireThat;

struct DrivenProduct {
  std::vector<std::string> settings;
  std::string state;  ///< after a short drive
};

void configure(const DrivenProduct& driven, MetaCoordinator& product) {
  Settings settings({}, {}, driven.settings);
  product.configure(settings);
}

DrivenProduct driven(const std::vector<std::string>& settings, bool has_scans) {
  DrivenProduct driven{settings, ""};
  MetaCoordinator product;
  configure(driven, product);
  auto inputs = has_scans ? test::scanInputs(1, 8) : test::landmarkInputs(1);
  inputs.resize(std::min<std::size_t>(inputs.size(), 30));
  for (const auto& input : inputs) {
    input(product);
    while (product.execute(), product.estimator().report()) {
    }
  }
  driven.state = stateOf(product);
  return driven;
}

const std::vector<DrivenProduct>& products() {
  static const std::vector<DrivenProduct> kProducts = {
      driven({"backend=ekf"}, false),
      driven({"backend=pf", "pf.particles=3"}, false),
      driven({"backend=graph"}, false),
      driven({"backend=grid", "map=grid", "pointmap=true"}, true),
      driven({"backend=pf", "map=grid", "pf.particles=2"}, true),
      driven({"backend=graph", "map=grid"}, true)};
  return kProducts;
}

/// A state that somebody has changed is no state, or it is restored.
void restoreChanged(const DrivenProduct& driven, test::FuzzBytes& bytes) {
  MetaCoordinator product;
  configure(driven, product);
  try {
    restore(test::changed(driven.state, bytes), product);
  } catch (const std::runtime_error& refused) {
    test::requireSentence(refused);
  }
}

/// A file that was damaged, which its checksum tells.
void readDamaged(const DrivenProduct& driven, test::FuzzBytes& bytes) {
  const RunIdentity run{"product", "robot", "data", "configuration"};
  const auto whole = checkpointOf(run, driven.state), damaged = test::changed(whole, bytes);
  try {
    stateIn(damaged, run);
    requireThat(damaged == whole, "a damaged checkpoint was accepted");
  } catch (const std::runtime_error& refused) {
    test::requireSentence(refused);
  }
}

}  // namespace
}  // namespace slam

/// A checkpoint: changes of its file are noticed, changes of the state in it do no harm.
SLAM_FUZZ_TARGET(checkpoint) {
  slam::test::FuzzBytes source(bytes, size);
  const auto& product = slam::products()[source.below(slam::products().size())];
  if (source.below(8) == 0)
    slam::readDamaged(product, source);
  else
    slam::restoreChanged(product, source);
}
