// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/sealed_bytes.hpp"

#include <array>
#include <stdexcept>

#include "slam_core/common/byte_stream.hpp"

namespace slam {
namespace {

constexpr std::size_t kLetters = 8, kHeaderSize = kLetters + 4 + 8, kSumSize = 8;
constexpr std::size_t kSlices = 8;

using ChecksumTables = std::array<std::array<std::uint64_t, 256>, kSlices>;

/// What a byte adds to the sum when 0 to 7 bytes follow it (slicing by eight).
ChecksumTables checksumTables() {
  constexpr std::uint64_t kPolynomial = 0xc96c5795d7870f42U;
  ChecksumTables tables{};
  for (std::uint64_t i = 0; i < 256; ++i) {
    auto sum = i;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? kPolynomial : 0U);
    tables[0][i] = sum;
  }
  for (std::size_t slice = 1; slice < kSlices; ++slice)
    for (std::size_t i = 0; i < 256; ++i) {
      const auto before = tables[slice - 1][i];
      tables[slice][i] = tables[0][before & 0xffU] ^ (before >> 8U);
    }
  return tables;
}

template <class T>
T numberAt(const std::string& bytes, std::size_t at) {
  T number = 0;
  ByteReader(bytes.data() + at, sizeof(T)).number(number);
  return number;
}

}  // namespace

std::uint64_t checksum(const char* bytes, std::size_t size) {
  static const auto kTables = checksumTables();
  std::uint64_t sum = ~std::uint64_t{0};
  for (; size >= kSlices; size -= kSlices, bytes += kSlices) {
    std::uint64_t word = 0;
    ByteReader(bytes, kSlices).number(word);
    word ^= sum;
    sum = 0;
    for (std::size_t i = 0; i < kSlices; ++i)
      sum ^= kTables[kSlices - 1 - i][(word >> (8 * i)) & 0xffU];
  }
  for (; size > 0; --size, ++bytes)
    sum = kTables[0][(sum ^ static_cast<unsigned char>(*bytes)) & 0xffU] ^ (sum >> 8U);
  return ~sum;
}

std::string sealed(const SealedFormat& format, const std::string& content) {
  ByteWriter header;
  header.append(format.letters, kLetters);
  header.number(format.version);
  header.number(std::uint64_t{content.size()});
  auto bytes = header.take() + content;
  ByteWriter sum;
  sum.number(checksum(bytes.data(), bytes.size()));
  return bytes += sum.take();
}

std::string_view contentOf(const SealedFormat& format, const std::string& bytes) {
  if (bytes.compare(0, kLetters, format.letters) != 0) throw std::runtime_error(format.other_kind);
  const auto cut = [&] {
    return std::runtime_error(std::string("it is cut or has grown: ") + format.again);
  };
  if (bytes.size() < kHeaderSize + kSumSize) throw cut();
  const auto version = numberAt<std::uint32_t>(bytes, kLetters);
  if (version != format.version)
    throw std::runtime_error("it is of version " + std::to_string(version) +
                             " and this program reads version " + std::to_string(format.version) +
                             ": use the program that has saved it");
  const auto size = bytes.size() - kHeaderSize - kSumSize;
  if (numberAt<std::uint64_t>(bytes, kLetters + 4) != size) throw cut();
  const auto end = bytes.size() - kSumSize;
  if (numberAt<std::uint64_t>(bytes, end) != checksum(bytes.data(), end))
    throw std::runtime_error(std::string("it is damaged, its checksum does not fit: ") +
                             format.again);
  return std::string_view(bytes).substr(kHeaderSize, size);
}

}  // namespace slam
