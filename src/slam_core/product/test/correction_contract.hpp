// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/product/test/driven_backend.hpp"

// A back-end that reports its corrections (CorrectionReporter) passes these tests.

namespace slam::test {

class CorrectionContract : public ContractTest {
 protected:
  static std::optional<Stamp> correctedBy(const DrivenBackend& backend) {
    return backend.as<CorrectionReporter>().correctedBy();
  }
};
// A back-end without the capability has none of these tests.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CorrectionContract);

TEST_P(CorrectionContract, WhatFitsTheMapCorrectsThePose) {
  auto backend = make();
  EXPECT_FALSE(correctedBy(backend)) << "nothing before the first step";
  const auto drive = backend.drive(1);
  int corrected = 0;
  for (int i = 0; i < 60; ++i) {
    backend.step(*drive);
    if (correctedBy(backend)) ++corrected;
  }
  EXPECT_GT(corrected, 40);
}

TEST_P(CorrectionContract, AStepWithoutAnythingToSeeCorrectsNothing) {
  auto backend = make();
  backend.run(2, 60);
  ASSERT_TRUE(correctedBy(backend));
  backend.execute();
  EXPECT_FALSE(correctedBy(backend));
}

TEST_P(CorrectionContract, NothingIsCorrectedAfterReset) {
  auto backend = make();
  backend.run(3, 60);
  backend->reset();
  EXPECT_FALSE(correctedBy(backend));
}

}  // namespace slam::test
