// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/area_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slam::relocalisation {
namespace {

constexpr double kOfPatch = 0.3;

/// The sum over a square of patches.
double ofSquare(int edge, double log_ratio) {
  AreaEvidence evidence;
  double sum = 0.0;
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y) sum += evidence.add({x, y}, log_ratio);
  return sum;
}

TEST(AreaEvidenceTest, OneAreaTellsLittleForAPlaceHoweverMuchIsSeenThere) {
  AreaEvidence evidence;
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) sum += evidence.add({0, 0}, kOfPatch);
  EXPECT_GT(sum, 1.0);
  EXPECT_LT(sum, 0.5 * std::log(100.0));
}

TEST(AreaEvidenceTest, TheSameSurfacesTellMoreInSeveralAreas) {
  AreaEvidence one, several;
  double of_one = 0.0, of_several = 0.0;
  for (int i = 0; i < 16; ++i) {
    of_one += one.add({i % 4, 0}, kOfPatch);
    of_several += several.add({i * 10, 0}, kOfPatch);
  }
  EXPECT_GT(of_several, 2.0 * of_one);
  EXPECT_LT(of_several, 16 * kOfPatch);
}

/// At coordinates below zero, too.
TEST(AreaEvidenceTest, AreasAreAlikeOnAllSidesOfTheOrigin) {
  const auto of_row = [](int from) {
    AreaEvidence evidence;
    double sum = 0.0;
    for (int i = from; i < from + 12; ++i) sum += evidence.add({i, -1}, kOfPatch);
    return sum;
  };
  EXPECT_NEAR(of_row(-12), of_row(0), 1e-12);
  EXPECT_NEAR(of_row(-6), of_row(0), 1e-12);
}

TEST(AreaEvidenceTest, TellsWithoutALimitAgainstAPlace) {
  EXPECT_LT(ofSquare(6, -kOfPatch), -36 * kOfPatch * 0.9);
  EXPECT_TRUE(std::isfinite(ofSquare(100, -2.0)));
}

TEST(AreaEvidenceTest, TheOrderSaysNothing) {
  AreaEvidence first, last;
  const double sum = first.add({0, 0}, -1.0) + first.add({1, 0}, 2.0);
  EXPECT_NEAR(last.add({1, 0}, 2.0) + last.add({0, 0}, -1.0), sum, 1e-12);
}

TEST(AreaEvidenceTest, WhatSaysNothingChangesNothing) {
  AreaEvidence evidence;
  EXPECT_EQ(evidence.add({0, 0}, 0.0), 0.0);
}

}  // namespace
}  // namespace slam::relocalisation
