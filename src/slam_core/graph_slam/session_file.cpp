// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_file.hpp"

#include <array>
#include <stdexcept>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/graph_slam/session_archive.hpp"
#include "slam_core/graph_slam/session_check.hpp"

namespace slam::graph_slam {
namespace {

constexpr const char* kMagic = "SLAMGRPH";
constexpr std::uint32_t kVersion = 3;
constexpr std::size_t kMagicSize = 8, kHeaderSize = kMagicSize + 4 + 8, kSumSize = 8;

/// CRC-64/XZ: ECMA-182's polynomial, reflected.
std::uint64_t checksum(const char* bytes, std::size_t size) {
  constexpr std::uint64_t kPolynomial = 0xc96c5795d7870f42U;
  static const auto kTable = [] {
    std::array<std::uint64_t, 256> table{};
    for (std::uint64_t i = 0; i < table.size(); ++i) {
      auto sum = i;
      for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? kPolynomial : 0U);
      table[i] = sum;
    }
    return table;
  }();
  std::uint64_t sum = ~std::uint64_t{0};
  for (std::size_t i = 0; i < size; ++i)
    sum = kTable[(sum ^ static_cast<unsigned char>(bytes[i])) & 0xffU] ^ (sum >> 8U);
  return ~sum;
}

template <class T>
T numberAt(const std::string& bytes, std::size_t at) {
  T number = 0;
  SessionReader(bytes.data() + at, sizeof(T))(number);
  return number;
}

/// That the whole content is there as it was written.
void requireWhole(const std::string& bytes) {
  if (bytes.compare(0, kMagicSize, kMagic) != 0)
    throw std::runtime_error(
        "it is no session of the graph: name a file that save_session has written");
  const auto cut = [] {
    return std::runtime_error("it is cut or has grown: copy it again or save the session again");
  };
  if (bytes.size() < kHeaderSize + kSumSize) throw cut();
  const auto version = numberAt<std::uint32_t>(bytes, kMagicSize);
  if (version != kVersion)
    throw std::runtime_error("it is of version " + std::to_string(version) +
                             " and this program reads version " + std::to_string(kVersion) +
                             ": use the program that has saved it");
  if (numberAt<std::uint64_t>(bytes, kMagicSize + 4) != bytes.size() - kHeaderSize - kSumSize)
    throw cut();
  const auto end = bytes.size() - kSumSize;
  if (numberAt<std::uint64_t>(bytes, end) != checksum(bytes.data(), end))
    throw std::runtime_error(
        "it is damaged, its checksum does not fit: copy it again or save the session again");
}

}  // namespace

std::string bytesOf(const Session& session) {
  SessionWriter content_writer;
  Session copy = session;
  content_writer(copy);
  const auto content = content_writer.take();
  SessionWriter numbers;
  auto version = kVersion;
  auto size = static_cast<std::uint64_t>(content.size());
  numbers(version, size);
  std::string bytes = kMagic + numbers.take() + content;
  SessionWriter sum;
  auto value = checksum(bytes.data(), bytes.size());
  sum(value);
  return bytes + sum.take();
}

Session sessionOf(const std::string& bytes) {
  requireWhole(bytes);
  SessionReader reader(bytes.data() + kHeaderSize, bytes.size() - kHeaderSize - kSumSize);
  Session session;
  reader(session);
  if (reader.left() > 0)
    throw std::runtime_error("it goes on behind its last record: save the session again");
  if (const auto fault = faultOf(session); !fault.empty())
    throw std::runtime_error(fault + ": save the session again");
  return session;
}

void writeSession(const std::string& path, const Session& session) {
  writeFileAtomically(path, bytesOf(session));
}

Session readSession(const std::string& path) {
  const auto bytes = readInputFile(path, "the session");
  try {
    return sessionOf(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot use the session " + path + ": " + error.what());
  }
}

}  // namespace slam::graph_slam
