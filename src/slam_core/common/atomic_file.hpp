// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// Writes `content` to `path` so that a reader finds the old file or the whole new one, never a
/// part: a temporary file beside it is flushed to disk and renamed.
/// @throw std::runtime_error naming the file and the cause (full disk, no permission)
void writeFileAtomically(const std::string& path, const std::string& content);

/// Tells what would keep writeFileAtomically() from it, before there is anything to write. Nothing
/// is changed.
/// @throw std::runtime_error as that
void requireWritable(const std::string& path);

}  // namespace slam
