// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"

namespace slam::test {

/// The faults that `step` throws as a ConfigError; none when it does not throw.
template <class Step>
std::vector<std::string> faultsOf(Step&& step) {
  try {
    step();
  } catch (const ConfigError& error) {
    return error.faults();
  }
  return {};
}

/// What `step` says when it throws; empty when it does not.
template <class Step>
std::string sentenceOf(Step&& step) {
  try {
    step();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// Whether one of the sentences holds all the words.
inline testing::AssertionResult oneSays(const std::vector<std::string>& sentences,
                                        std::initializer_list<const char*> words) {
  const auto says_all = [&](const std::string& sentence) {
    return std::all_of(words.begin(), words.end(),
                       [&](const char* word) { return sentence.find(word) != std::string::npos; });
  };
  if (std::any_of(sentences.begin(), sentences.end(), says_all)) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure() << "no sentence says";
  for (const auto* word : words) failure << " '" << word << "'";
  return failure << "; there are:\n" << join(sentences, "\n");
}

}  // namespace slam::test
