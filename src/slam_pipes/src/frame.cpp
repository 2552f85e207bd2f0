// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame.hpp"

#include <stdexcept>

#include "slam_core/common/byte_stream.hpp"
#include "slam_core/common/sealed_bytes.hpp"

namespace slam_pipes {
namespace {

/// The version grows with each change of the frame or of a kind's persist().
constexpr slam::SealedFormat kFormat = {
    "SLAMPORT", 1, "what comes is no port data: have slam_pipes start both of its ends",
    "start the run again"};
constexpr std::size_t kLetters = 8, kHeader = kLetters + 4 + 8, kSum = 8;

template <class T>
T numberAt(const std::string& bytes, std::size_t at) {
  T number = 0;
  slam::ByteReader(bytes.data() + at, sizeof(T)).number(number);
  return number;
}

/// The size of the content; only then can it be trusted that the header is one.
std::uint64_t sizeIn(const std::string& bytes, std::size_t begin) {
  if (bytes.compare(begin, kLetters, kFormat.letters) != 0)
    throw std::runtime_error(kFormat.other_kind);
  const auto version = numberAt<std::uint32_t>(bytes, begin + kLetters);
  if (version != kFormat.version)
    throw std::runtime_error("its frames are of version " + std::to_string(version) +
                             " and this program reads version " + std::to_string(kFormat.version) +
                             ": start both of its ends from one installation");
  const auto size = numberAt<std::uint64_t>(bytes, begin + kLetters + 4);
  if (size > FrameDecoder::kLargest)
    throw std::runtime_error("a frame of " + std::to_string(size) +
                             " bytes is announced, which is damaged: start the run again");
  return size;
}

}  // namespace

std::string FrameEncoder::bytesOf(const Frame& frame) {
  slam::ArchiveWriter archive;
  archive(number_++, frame);
  return slam::sealed(kFormat, archive.take());
}

void FrameDecoder::append(const char* bytes, std::size_t size) {
  bytes_.erase(0, begin_);
  begin_ = 0;
  bytes_.append(bytes, size);
}

std::optional<Frame> FrameDecoder::next() {
  if (bytes_.size() - begin_ < kHeader) return std::nullopt;
  const auto size = kHeader + sizeIn(bytes_, begin_) + kSum;
  if (bytes_.size() - begin_ < size) return std::nullopt;
  const auto bytes = bytes_.substr(begin_, size);
  const auto content = slam::contentOf(kFormat, bytes);
  slam::ArchiveReader archive(content.data(), content.size());
  std::uint64_t number = 0;
  Frame frame;
  archive(number, frame);
  if (number != number_)
    throw std::runtime_error("frame " + std::to_string(number) + " comes where frame " +
                             std::to_string(number_) + " is expected: start the run again");
  ++number_;
  begin_ += size;
  return frame;
}

}  // namespace slam_pipes
