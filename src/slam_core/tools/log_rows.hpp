// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "slam_core/common/input_file.hpp"
#include "slam_core/common/nearest_name.hpp"

namespace slam {

/// The rows of a text log, one after the other: a kind and its values. '#' begins a comment. A
/// program passes over the kinds that it has no use for; one that none of them knows is an error.
class LogRows {
 public:
  /// @throw std::runtime_error naming the file
  explicit LogRows(const std::string& path) {
    requireInputFile(path, "the log");
    file_.open(path);
  }

  /// Goes to the next row. @return false at the end
  bool next() {
    for (std::string line; std::getline(file_, line);) {
      ++number_;
      words_ = std::istringstream(line.substr(0, line.find('#')));
      if (!(words_ >> kind_)) continue;
      requireKnown();
      return true;
    }
    return false;
  }

  const std::string& kind() const { return kind_; }
  bool hasMore() { return !(words_ >> std::ws).eof(); }

  /// The row's next value. `inf` and `nan` are numbers.
  double number() { return parsed(&toDouble); }
  std::int64_t integer() { return parsed(&toInteger); }
  /// What is left of the row.
  std::string rest() {
    std::string text;
    std::getline(words_ >> std::ws, text);
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
  }

  [[noreturn]] void fail(const std::string& fault) const {
    throw std::runtime_error(fmt::format("line {}: {}", number_, fault));
  }
  /// To people, where it does not stop the program.
  void tell(const std::string& message) const {
    fmt::print(stderr, "line {}: {}\n", number_, message);
  }

 private:
  static double toDouble(const char* text, char** end) { return std::strtod(text, end); }
  static std::int64_t toInteger(const char* text, char** end) {
    return std::strtoll(text, end, 10);
  }

  template <class Value>
  Value parsed(Value (*parse)(const char*, char**)) {
    std::string word;
    words_ >> word;
    char* end = nullptr;
    errno = 0;
    const Value value = parse(word.c_str(), &end);
    if (word.empty() || *end != '\0' || errno == ERANGE)
      fail("a number is missing or malformed" + (word.empty() ? "" : ": '" + word + "'"));
    return value;
  }

  void requireKnown() const {
    static const std::vector<std::string> kKinds = {"odometry", "motion", "observations",
                                                    "scan",     "pose",   "image"};
    for (const auto& kind : kKinds)
      if (kind == kind_) return;
    fail(fmt::format("'{}' is no kind of row{}; there are: {}", kind_, didYouMean(kind_, kKinds),
                     join(kKinds)));
  }

  std::ifstream file_;
  std::istringstream words_;
  std::string kind_;
  int number_ = 0;
};

}  // namespace slam
