// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "import_error.hpp"

namespace slam::eval {

/// Numbers out of the bytes of a binary file, in order. Every reader throws an ImportError that
/// names the file where the bytes end early.
class ByteReader {
 public:
  /// @param swap the bytes of each number stand the other way round; the bytes outlive the reader
  ByteReader(std::string path, std::string_view bytes, bool swap)
      : path_(std::move(path)), bytes_(bytes), swap_(swap) {}

  bool isAtEnd() const { return bytes_.empty(); }
  bool swaps() const { return swap_; }
  const std::string& path() const { return path_; }

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) fail("it ends in the middle of a matrix");
    const auto taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  /// What fills a field up; it may be missing at the very end.
  void skip(std::size_t count) { bytes_.remove_prefix(std::min(count, bytes_.size())); }

  template <class T>
  T number() {
    char bytes[sizeof(T)];
    std::memcpy(bytes, take(sizeof(T)).data(), sizeof(T));
    if (swap_) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw ImportError(path_ + " is damaged: " + what);
  }

 private:
  std::string path_;
  std::string_view bytes_;
  bool swap_;
};

}  // namespace slam::eval
