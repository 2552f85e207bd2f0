// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// Writes `content` to `path` so that a reader finds the old file or the whole new one, never a
/// part: a temporary file beside it is flushed to disk and renamed, and its new name is flushed as
/// well.
/// @throw std::runtime_error naming the file and the cause (full disk, no permission)
void writeFileAtomically(const std::string& path, const std::string& content);

/// What has been written to a file is on the disk afterwards, so that a power cut does not take it.
/// @throw std::runtime_error naming the file and the cause
void flushToDisk(const std::string& path);

/// Makes an empty file beside `path`, for who writes by name and renames it at the end. Nothing had
/// its name before: in a folder that others may write to, no link of theirs is followed.
/// @return the name @throw std::runtime_error as writeFileAtomically()
std::string makeTemporaryBeside(const std::string& path);

/// Tells what would keep writeFileAtomically() from it, before there is anything to write. Nothing
/// is changed.
/// @throw std::runtime_error as that
void requireWritable(const std::string& path);

}  // namespace slam
