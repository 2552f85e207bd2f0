// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <stdexcept>

#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/tools/log_rows.hpp"
#include "slam_core/tools/motion_row.hpp"
#include "slam_core/tools/observations_row.hpp"
#include "slam_core/tools/odometry_row.hpp"
#include "slam_core/tools/scan_row.hpp"

namespace slam {
namespace {

void take(LogRows& row, MetaCoordinator& product) {
  if (row.kind() == "odometry") product.set(odometryIn(row));
  if (row.kind() == "motion") product.set(motionIn(row));
  if (row.kind() == "observations") product.set(observationsIn(row));
  if (row.kind() == "scan") product.set(sweepIn(row));
  if (row.kind() == "pose") poseIn(row);
  while (product.execute(), product.estimator().report()) {
    const auto& [pose, covariance] = product.estimator().report()->pose;
    test::requireThat(pose.isFinite() && covariance.allFinite(), "a pose that is not finite");
  }
}

}  // namespace
}  // namespace slam

/// A text log of a drive: a row that cannot be read ends it with a sentence, all others are taken.
SLAM_FUZZ_TARGET(text_log) {
  using namespace slam;
  static const test::TemporaryFolder kFolder;
  const auto path = kFolder.write("log.txt", test::contentOf(bytes, size));
  Settings settings({}, {}, {"backend=ekf"});
  MetaCoordinator product;
  product.configure(settings);
  try {
    for (LogRows row(path); row.next();) take(row, product);
  } catch (const std::runtime_error& refused) {
    test::requireSentence(refused);
  }
}
