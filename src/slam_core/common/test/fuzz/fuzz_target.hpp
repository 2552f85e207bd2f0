// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>

namespace slam::test {

/// What a fuzz target does with an input. The same bytes do the same, whatever was called before.
using FuzzTarget = void (*)(const std::uint8_t* bytes, std::size_t size);

/// The targets of a program that is no libFuzzer's, by name.
inline std::map<std::string, FuzzTarget>& fuzzTargets() {
  static std::map<std::string, FuzzTarget> targets;
  return targets;
}

/// Ends the program with what was broken, so that the input is kept.
inline void requireThat(bool holds, const std::string& broken) {
  if (holds) return;
  std::cerr << "broken: " << broken << std::endl;
  std::abort();
}

/// The bytes of an input as the content of a file.
inline std::string contentOf(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Requires that a refusal says something.
inline void requireSentence(const std::exception& refusal) {
  requireThat(refusal.what()[0] != '\0', "a refusal without a sentence");
}

}  // namespace slam::test

/// The file of a fuzz target ends with SLAM_FUZZ_TARGET(its name) { ... } for an input of `size`
/// bytes at `bytes`. Under SLAM_FUZZ it becomes the only target of a program, which libFuzzer calls
/// with bytes that it makes up; else one of a program of tests, which gives it the inputs of the
/// folder beside its file.
#ifdef SLAM_FUZZ
#define SLAM_FUZZ_TARGET(name)                                                         \
  static void name(const std::uint8_t* bytes, std::size_t size);                       \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) { \
    name(bytes, size);                                                                 \
    return 0;                                                                          \
  }                                                                                    \
  static void name(const std::uint8_t* bytes, std::size_t size)
#else
#define SLAM_FUZZ_TARGET(name)                                   \
  static void name(const std::uint8_t* bytes, std::size_t size); \
  [[maybe_unused]] static const bool name##_is_known =           \
      slam::test::fuzzTargets().emplace(#name, &name).second;    \
  static void name(const std::uint8_t* bytes, std::size_t size)
#endif
