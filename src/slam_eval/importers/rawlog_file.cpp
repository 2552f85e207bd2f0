// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_file.hpp"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <array>
#include <filesystem>
#include <memory>

#include "import_error.hpp"

namespace slam::eval {

namespace fs = std::filesystem;

namespace {

struct GzClose {
  void operator()(gzFile_s* file) const { gzclose_r(file); }
};

std::vector<char> readBytes(const std::string& path, Progress& progress) {
  const std::unique_ptr<gzFile_s, GzClose> file(gzopen(path.c_str(), "rb"));
  if (!file) throw ImportError("cannot read " + path);
  progress.begin("reading " + fs::path(path).filename().string(), fs::file_size(path));
  std::vector<char> bytes;
  std::array<char, 1 << 16> block;
  int count = 0;
  while ((count = gzread(file.get(), block.data(), block.size())) > 0) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + count);
    progress.update(static_cast<std::size_t>(gzoffset(file.get())));
  }
  progress.end();
  int error = Z_OK;
  gzerror(file.get(), &error);
  if (error == Z_BUF_ERROR)
    throw ImportError(path + " is truncated: its compressed data ends early");
  if (count < 0) throw ImportError(path + " is damaged: it cannot be decompressed");
  return bytes;
}

}  // namespace

std::vector<mrpt::serialization::CSerializable::Ptr> readRawlogObjects(const std::string& path,
                                                                       Progress& progress) {
  requireFile(path);
  const std::vector<char> bytes = readBytes(path, progress);
  if (bytes.empty()) throw ImportError(path + " is empty");
  mrpt::io::CMemoryStream stream;
  stream.assignMemoryNotOwn(bytes.data(), bytes.size());
  auto archive = mrpt::serialization::archiveFrom(stream);
  std::vector<mrpt::serialization::CSerializable::Ptr> objects;
  while (stream.getPosition() < bytes.size()) {
    try {
      objects.push_back(archive.ReadObject());
    } catch (const std::exception&) {  // std::bad_alloc as well
      // MRPT's own message is a call stack of many lines.
      if (objects.empty()) throw ImportError(path + " is no MRPT rawlog");
      throw ImportError(path + " is damaged or truncated: object " +
                        std::to_string(objects.size() + 1) + " cannot be read");
    }
  }
  return objects;
}

}  // namespace slam::eval
