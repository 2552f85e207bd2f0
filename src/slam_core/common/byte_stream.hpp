// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace slam {

/// The unsigned integer with as many bits as a number.
template <class T>
using BitsOf = std::conditional_t<
    sizeof(T) == 1, std::uint8_t,
    std::conditional_t<sizeof(T) == 2, std::uint16_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/// Appends numbers to a string of bytes, the least significant byte first on every machine.
class ByteWriter {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    BitsOf<T> bits;
    std::memcpy(&bits, &value, sizeof(value));
    char bytes[sizeof(bits)];
    for (std::size_t i = 0; i < sizeof(bits); ++i)
      bytes[i] = static_cast<char>((bits >> (8 * i)) & 0xffU);
    bytes_.append(bytes, sizeof(bytes));
  }
  void append(const char* bytes, std::size_t size) { bytes_.append(bytes, size); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes numbers off a string of bytes. Every function throws a std::runtime_error, to stand
/// behind the name of what the bytes are, where they end too early.
class ByteReader {
 public:
  /// @param bytes outlive this
  ByteReader(const char* bytes, std::size_t size) : next_(bytes), left_(size) {}

  template <class T>
  void number(T& value) {
    static_assert(std::is_arithmetic_v<T>);
    const char* from = take(sizeof(T));
    BitsOf<T> bits = 0;
    for (std::size_t i = sizeof(T); i-- > 0;)
      bits =
          static_cast<BitsOf<T>>((std::uint64_t{bits} << 8U) | static_cast<unsigned char>(from[i]));
    std::memcpy(&value, &bits, sizeof(value));
  }
  const char* take(std::size_t size) {
    if (size > left_) refuseEnd();
    left_ -= size;
    return std::exchange(next_, next_ + size);
  }
  /// A number of elements that follow, each of which takes at least `size` bytes: a damaged number
  /// takes no memory.
  std::uint64_t count(std::size_t size = 1) {
    std::uint64_t count = 0;
    number(count);
    if (count > left_ / size) refuseEnd();
    return count;
  }
  std::size_t left() const { return left_; }

 private:
  [[noreturn]] static void refuseEnd() {
    throw std::runtime_error("it ends within a record: save it again");
  }

  const char* next_;
  std::size_t left_;
};

}  // namespace slam
