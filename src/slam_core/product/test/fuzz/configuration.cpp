// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/product/meta_coordinator.hpp"

/// A product file and, behind a line "===", a robot file: they are refused with a sentence, or make
/// a product.
SLAM_FUZZ_TARGET(configuration) {
  using namespace slam;
  static const test::TemporaryFolder kFolder;
  const auto input = test::contentOf(bytes, size);
  const auto border = std::min(input.find("\n===\n"), input.size());
  const auto product = kFolder.write("product.yaml", input.substr(0, border));
  const auto robot = kFolder.write("robot.yaml", input.substr(std::min(border + 5, input.size())));
  try {
    Settings settings(loadConfigFile(product), loadConfigFile(robot), {});
    MetaCoordinator().configure(settings);
  } catch (const ConfigError& refused) {
    test::requireSentence(refused);
  }
}
