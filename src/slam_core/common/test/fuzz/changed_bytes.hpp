// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/test/fuzz/fuzz_bytes.hpp"

namespace slam::test {

/// A binary content with what the bytes say put into it: numbers of 1 to 8 bytes are written over,
/// pieces are cut out or doubled.
inline std::string changed(std::string content, FuzzBytes& bytes) {
  while (!bytes.isEmpty() && !content.empty()) {
    const auto at = static_cast<std::size_t>(bytes.below(content.size()));
    const auto write = [&](auto value) {
      content.replace(at, std::min(sizeof(value), content.size() - at),
                      reinterpret_cast<const char*>(&value), sizeof(value));
    };
    switch (bytes.below(8)) {
      case 0:
        content.erase(at, 1 + bytes.below(64));
        break;
      case 1:
        content.insert(at, content.substr(at, 1 + bytes.below(64)));
        break;
      case 2:
        content.resize(at);
        break;
      case 3:
        write(bytes.bits<std::uint64_t>());
        break;
      case 4:
        write(bytes.number());
        break;
      case 5:
        write(static_cast<std::uint64_t>(bytes.below(256)));
        break;
      default:
        write(bytes.bits<std::uint8_t>());
    }
  }
  return content;
}

}  // namespace slam::test
