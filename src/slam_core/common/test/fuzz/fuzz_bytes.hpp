// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace slam::test {

/// Decisions and numbers that are made of bytes, one after the other. Behind the last byte all are
/// 0, so that each input has an end.
class FuzzBytes {
 public:
  FuzzBytes(const std::uint8_t* bytes, std::size_t size) : next_(bytes), left_(size) {}

  bool isEmpty() const { return left_ == 0; }
  std::size_t left() const { return left_; }

  /// A number of this type with any bits.
  template <class T>
  T bits() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    const auto size = std::min(left_, sizeof(T));
    if (size > 0) std::memcpy(&value, next_, size);
    next_ += size;
    left_ -= size;
    return value;
  }
  /// One of 0 .. count - 1. @pre count > 0
  std::uint64_t below(std::uint64_t count) {
    if (count <= 1) return 0;
    if (count <= 256) return bits<std::uint8_t>() % count;
    return count <= 65536 ? bits<std::uint16_t>() % count : bits<std::uint64_t>() % count;
  }

  /// A number as it is measured, one at a limit, or any.
  double number() {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr double kLimits[] = {std::numeric_limits<double>::quiet_NaN(),
                                         kInfinity,
                                         -kInfinity,
                                         0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         3.14159265358979323846,
                                         1e-300,
                                         1e-9,
                                         1e6,
                                         1e9,
                                         -1e12,
                                         1e100,
                                         1e300,
                                         -1e308};
    switch (below(4)) {
      case 0:
        return kLimits[below(std::size(kLimits))];
      case 1:
        return bits<double>();
      default:
        return 0.001 * bits<std::int16_t>();
    }
  }

 private:
  const std::uint8_t* next_;
  std::size_t left_;
};

}  // namespace slam::test
