// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/checkpoint_folder.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"

namespace slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "checkpoint";
constexpr const char* kPrevious = ".previous";
constexpr const char* kNew = ".new";
constexpr const char* kUnused = ".unused";
constexpr const char* kBefore = ".before";

const std::string& made(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw std::runtime_error("cannot make the folder " + path +
                             " for checkpoints: " + error.message());
  return path;
}

}  // namespace

CheckpointFolder::CheckpointFolder(const std::string& path) : path_(made(path)), lock_(path) {
  removeParts();
}

std::string CheckpointFolder::file(const char* suffix) const {
  return path_ + "/" + kName + suffix;
}

/// What a process that was killed while it wrote has left.
void CheckpointFolder::removeParts() const {
  std::error_code error;
  const auto begins = std::string(kName) + kNew;
  for (const auto& entry : fs::directory_iterator(path_, error))
    if (entry.path().filename().string().rfind(begins, 0) == 0) fs::remove(entry.path(), error);
}

std::string CheckpointFolder::fault() const {
  try {
    requireWritable(file());
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

CheckpointFolder::Resumption CheckpointFolder::resume(const Use& use) {
  std::vector<std::string> unused;
  Resumption resumption;
  for (const auto& name : {file(), file(kPrevious)}) {
    if (!fs::exists(name)) continue;
    try {
      use(readInputFile(name, "the checkpoint"));
      resumption.file = name;
      break;
    } catch (const std::runtime_error& error) {
      resumption.warning += (unused.empty() ? "" : "; ") + name + ": " + error.what();
      unused.push_back(name);
    }
  }
  for (const auto& name : unused) setAside(name);
  return resumption;
}

void CheckpointFolder::setAside(const std::string& name) const {
  auto aside = file(kUnused);
  for (int i = 2; fs::exists(aside); ++i) aside = file(kUnused) + "." + std::to_string(i);
  std::error_code error;  // of a folder that nobody can write to, which fault() tells
  fs::rename(name, aside, error);
}

void CheckpointFolder::beginAnew() {
  std::error_code error;
  const auto last = fs::exists(file()) ? file() : file(kPrevious);
  if (!fs::exists(last)) return;
  fs::rename(last, file(kBefore), error);
  fs::remove(file(kPrevious), error);
}

void CheckpointFolder::write(const std::string& bytes) const {
  writeFileAtomically(file(kNew), bytes);
  keepPrevious();
  std::error_code error;
  fs::rename(file(kNew), file(), error);
  if (error) throw std::runtime_error("cannot write " + file() + ": " + error.message());
  try {
    flushToDisk(path_);
  } catch (const std::runtime_error&) {
    // a file system that cannot flush a folder does what it can
  }
}

/// A file system without links has no `checkpoint` for a moment.
void CheckpointFolder::keepPrevious() const {
  std::error_code error;
  if (!fs::is_regular_file(file(), error)) return;
  fs::remove(file(kPrevious), error);
  fs::create_hard_link(file(), file(kPrevious), error);
  if (error) fs::rename(file(), file(kPrevious), error);
}

}  // namespace slam
