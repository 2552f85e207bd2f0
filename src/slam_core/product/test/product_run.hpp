// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/product/meta_coordinator.hpp"

namespace slam::test {

/// The faults of the product that these words (`key=value`) describe.
inline std::vector<std::string> faultsOfWords(const std::vector<std::string>& words) {
  return faultsOf([&] {
    Settings settings({}, {}, words);
    MetaCoordinator().configure(settings);
  });
}

/// A product that a test gives its inputs, with all that its steps have reported and said.
struct ProductRun {
  void configure(const std::vector<std::string>& words) {
    Settings settings({}, {}, words);
    coordinator.configure(settings);
  }
  /// Takes all steps that are due.
  void drain() {
    do {
      const auto status = coordinator.execute();
      if (!status.isOk()) sentences.push_back(status.message);
      if (coordinator.estimator().report()) reports.push_back(*coordinator.estimator().report());
    } while (coordinator.estimator().report());
  }

  MetaCoordinator coordinator;
  std::vector<StepReport> reports;
  std::vector<std::string> sentences;  ///< of steps in which not all was well
};

}  // namespace slam::test
