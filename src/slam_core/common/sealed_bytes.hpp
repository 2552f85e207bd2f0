// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slam {

/// A kind of file whose content is read back as it was written or not at all: eight letters that
/// name the kind, a version, the content's size, the content, and a checksum of all of it.
struct SealedFormat {
  const char* letters;     ///< eight of them
  std::uint32_t version;   ///< of the content
  const char* other_kind;  ///< a clause for what begins with other letters: "it is no ..."
  const char* again;       ///< how to get another file: "copy it again or ..."
};

/// The bytes of a file with this content.
std::string sealed(const SealedFormat& format, const std::string& content);

/// The content, which refers to the bytes.
/// @throw std::runtime_error with what is wrong, to stand behind the file's name: another kind of
/// file, another version, cut, or damaged
std::string_view contentOf(const SealedFormat& format, const std::string& bytes);

/// CRC-64/XZ: ECMA-182's polynomial, reflected.
std::uint64_t checksum(const char* bytes, std::size_t size);

}  // namespace slam
