// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "slam_core/common/atomic_file.hpp"

namespace slam_ros {
namespace {

namespace fs = std::filesystem;

/// A full disk may show only when the data really goes there.
int flushToDisk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return error;
}

void checkPath(const std::string& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder))
    throw BagPathError("cannot write " + path + ": there is no folder " + folder.string());
  if (fs::exists(path) && !fs::is_regular_file(path))
    throw BagPathError("cannot write " + path + ": it is no ordinary file");
}

std::string partOf(const std::string& path) {
  try {
    return slam::makeTemporaryBeside(path);
  } catch (const std::runtime_error& error) {
    throw BagWriteError(error.what());
  }
}

}  // namespace

BagFile::BagFile(const std::string& path) : path_(path) {
  checkPath(path);
  part_ = partOf(path);
  bag_ = std::make_unique<rosbag::Bag>();
  guarded([this] {
    bag_->open(part_, rosbag::bagmode::Write);
    bag_->setCompression(rosbag::compression::LZ4);
  });
}

BagFile::~BagFile() {
  if (bag_) abandon();
}

void BagFile::complete() {
  guarded([this] {
    bag_->close();
    errno = flushToDisk(part_);
    if (errno != 0) throw rosbag::BagIOException("flush");
    fs::rename(part_, path_);
  });
  bag_.reset();
}

void BagFile::fail(int error) {
  abandon();
  const std::string cause = error != 0 ? std::strerror(error) : "the disk may be full";
  throw BagWriteError("cannot write " + path_ + ": " + cause + "; no bag was left");
}

void BagFile::abandon() {
  // rosbag's destructor writes the index, fails again on a full disk and then ends the program.
  static_cast<void>(bag_.release());
  std::error_code ignored;
  fs::remove(part_, ignored);
}

}  // namespace slam_ros
