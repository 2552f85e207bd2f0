// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace slam {

/// Every file that a person names to be read passes through here, also where a library opens it
/// afterwards. Only regular files are read: a named pipe that nobody writes to would block for
/// good, and a device may have no end.

/// Why a path cannot be read as a file, to stand behind its name ("it is a folder"); empty where it
/// can. Links are followed.
std::string inputFileFault(const std::string& path);

/// @param what the file is to the person, as in "cannot read WHAT PATH: it is a folder", "...; does
/// it exist?"
/// @throw std::runtime_error with this sentence, where there is a fault
void requireInputFile(const std::string& path, const std::string& what = "the file");

/// The whole content. @throw std::runtime_error as requireInputFile(); also of a file that holds
/// more than `most_bytes`
std::string readInputFile(const std::string& path, const std::string& what = "the file",
                          std::uint64_t most_bytes = std::numeric_limits<std::uint64_t>::max());

}  // namespace slam
