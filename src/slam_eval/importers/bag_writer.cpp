// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_writer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "import_error.hpp"

namespace slam::eval {

namespace fs = std::filesystem;

namespace {

ImportError writeError(const std::string& path, int error) {
  const std::string cause = error != 0 ? std::strerror(error) : "the disk may be full";
  return ImportError("cannot write " + path + ": " + cause + "; no bag was left");
}

/// A full disk may show only when the data really goes there.
int flushToDisk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = ::fsync(file) == 0 ? 0 : errno;
  ::close(file);
  return error;
}

void checkFolder(const std::string& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder)) {
    throw UsageError("cannot write " + path + ": there is no folder " + folder.string());
  }
  if (fs::exists(path) && !fs::is_regular_file(path)) {
    throw UsageError("cannot write " + path + ": it is no ordinary file");
  }
}

}  // namespace

double BagWriter::duration() const {
  const auto by_stamp = [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; };
  const auto range = std::minmax_element(entries_.begin(), entries_.end(), by_stamp);
  return entries_.empty() ? 0.0 : (range.second->stamp - range.first->stamp).toSec();
}

void BagWriter::write(const std::string& path, Progress& progress) {
  if (entries_.empty()) throw ImportError("there is nothing to write to " + path);
  checkFolder(path);
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; });
  const std::string part = path + ".part";
  auto bag = std::make_unique<rosbag::Bag>();
  errno = 0;
  try {
    bag->open(part, rosbag::bagmode::Write);
    bag->setCompression(rosbag::compression::LZ4);
    writeMessages(*bag, progress);
    bag->close();
    errno = flushToDisk(part);
    if (errno != 0) throw rosbag::BagIOException("flush");
    fs::rename(part, path);
  } catch (const std::exception&) {
    const int error = errno;
    // rosbag's destructor writes the index, fails again on a full disk and then ends the program.
    static_cast<void>(bag.release());
    std::error_code ignored;
    fs::remove(part, ignored);
    throw writeError(path, error);
  }
}

void BagWriter::writeMessages(rosbag::Bag& bag, Progress& progress) const {
  progress.begin("writing", entries_.size());
  const std::uint64_t start = entries_.front().stamp.toNSec();
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const std::uint64_t before = std::min<std::uint64_t>(first_.size() - i, start - 1);
    ros::Time stamp;
    first_[i].write(bag, stamp.fromNSec(start - before));
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].write(bag, entries_[i].stamp);
    progress.update(i + 1);
  }
  progress.end();
}

}  // namespace slam::eval
