// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace slam {
namespace {

constexpr const char* kMissing = "it does not exist";

[[noreturn]] void refuse(const std::string& path, const std::string& what,
                         const std::string& fault) {
  throw std::runtime_error("cannot read " + what + " " + (path.empty() ? "''" : path) +
                           (fault == kMissing ? "; does it exist?" : ": " + fault));
}

std::string faultOf(int error) { return error == ENOENT ? kMissing : std::strerror(error); }

std::string faultOf(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  if (S_ISDIR(status.st_mode)) return "it is a folder, not a file";
  if (S_ISFIFO(status.st_mode)) return "it is a named pipe, not a regular file";
  if (S_ISSOCK(status.st_mode)) return "it is a socket, not a regular file";
  return "it is a device, not a regular file";
}

/// An open file, or why there is none.
class OpenFile {
 public:
  /// Opening a pipe does not block here, nor does it when it takes a file's place just now.
  explicit OpenFile(const std::string& path) {
    struct stat status {};
    if (path.empty())
      fault_ = "its name is empty";
    else if (::stat(path.c_str(), &status) != 0)
      fault_ = faultOf(errno);
    else if (fault_ = faultOf(status); fault_.empty())
      open(path);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  const std::string& fault() const { return fault_; }

  /// @return whether all could be read, and was no more than that
  bool read(std::string& content, std::uint64_t most_bytes) {
    char block[1 << 16];
    while (true) {
      const auto count = ::read(descriptor_, block, sizeof(block));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fault_ = faultOf(errno);
      if (count <= 0) return count == 0;
      content.append(block, static_cast<std::size_t>(count));
      if (content.size() <= most_bytes) continue;
      fault_ =
          "it holds more than " + std::to_string(most_bytes) + " bytes, which no such file does";
      return false;
    }
  }

 private:
  void open(const std::string& path) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    struct stat status {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
      fault_ = faultOf(errno);
    else
      fault_ = faultOf(status);
  }

  int descriptor_ = -1;
  std::string fault_;
};

}  // namespace

std::string inputFileFault(const std::string& path) { return OpenFile(path).fault(); }

void requireInputFile(const std::string& path, const std::string& what) {
  if (const auto fault = inputFileFault(path); !fault.empty()) refuse(path, what, fault);
}

std::string readInputFile(const std::string& path, const std::string& what,
                          std::uint64_t most_bytes) {
  OpenFile file(path);
  std::string content;
  if (!file.fault().empty() || !file.read(content, most_bytes)) refuse(path, what, file.fault());
  return content;
}

}  // namespace slam
