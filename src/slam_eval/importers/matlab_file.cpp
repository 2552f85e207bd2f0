// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matlab_file.hpp"

#include <zlib.h>

#include <optional>
#include <utility>

#include "byte_reader.hpp"
#include "import_error.hpp"

namespace slam::eval {
namespace {

using Matrices = std::map<std::string, MatlabMatrix>;

// Data types of level 5.
constexpr std::uint32_t kInt8 = 1, kUint8 = 2, kInt16 = 3, kUint16 = 4, kInt32 = 5, kUint32 = 6,
                        kSingle = 7, kDouble = 9, kInt64 = 12, kUint64 = 13, kMatrix = 14,
                        kCompressed = 15;
// Classes of matrices from double to uint64; below are cells, structures, text and sparse ones.
constexpr std::uint32_t kFirstNumericClass = 6, kLastNumericClass = 15;

constexpr std::size_t kHeaderBytes = 128, kEndianOffset = 126;
constexpr std::size_t kLargestMatrix = 1u << 30;  // of a matrix [byte]

template <class T>
std::vector<double> numbersAs(ByteReader& reader, std::size_t count) {
  std::vector<double> values(count);
  for (auto& value : values) value = static_cast<double>(reader.number<T>());
  return values;
}

std::size_t sizeOfType(std::uint32_t type) {
  switch (type) {
    case kInt8:
    case kUint8:
      return 1;
    case kInt16:
    case kUint16:
      return 2;
    case kInt32:
    case kUint32:
    case kSingle:
      return 4;
    case kDouble:
    case kInt64:
    case kUint64:
      return 8;
    default:
      return 0;
  }
}

std::vector<double> numbersOf(ByteReader& reader, std::uint32_t type, std::size_t count) {
  if (const auto size = sizeOfType(type); size == 0 || count > kLargestMatrix / size)
    reader.fail("it says that a matrix has values of type " + std::to_string(type));
  switch (type) {
    case kInt8:
      return numbersAs<std::int8_t>(reader, count);
    case kUint8:
      return numbersAs<std::uint8_t>(reader, count);
    case kInt16:
      return numbersAs<std::int16_t>(reader, count);
    case kUint16:
      return numbersAs<std::uint16_t>(reader, count);
    case kInt32:
      return numbersAs<std::int32_t>(reader, count);
    case kUint32:
      return numbersAs<std::uint32_t>(reader, count);
    case kSingle:
      return numbersAs<float>(reader, count);
    case kDouble:
      return numbersAs<double>(reader, count);
    case kInt64:
      return numbersAs<std::int64_t>(reader, count);
    default:
      return numbersAs<std::uint64_t>(reader, count);
  }
}

/// A data element of level 5: a type, and bytes that fill a multiple of 8.
struct Element {
  std::uint32_t type = 0;
  std::string_view bytes;
};

Element elementAt(ByteReader& reader) {
  Element element;
  const auto tag = reader.number<std::uint32_t>();
  const std::uint32_t small_size = tag >> 16;
  element.type = tag & 0xffff;
  if (small_size > 0) {  // size and type share four bytes, the data are the other four
    const auto four = reader.take(4);
    if (small_size > four.size()) reader.fail("a short element is said to be longer than that");
    element.bytes = four.substr(0, small_size);
    return element;
  }
  const auto size = reader.number<std::uint32_t>();
  element.bytes = reader.take(size);
  if (element.type != kCompressed) reader.skip((8 - size % 8) % 8);
  return element;
}

ByteReader within(const ByteReader& reader, std::string_view bytes) {
  return {reader.path(), bytes, reader.swaps()};
}

std::vector<double> valuesOf(const ByteReader& reader, const Element& element) {
  ByteReader inner = within(reader, element.bytes);
  const std::size_t size = sizeOfType(element.type);
  return numbersOf(inner, element.type, size > 0 ? element.bytes.size() / size : 0);
}

void setShape(const ByteReader& reader, const std::vector<double>& dimensions, MatlabMatrix& m) {
  if (dimensions.size() < 2) reader.fail("a matrix has fewer than two dimensions");
  double count = 1.0;
  for (const double dimension : dimensions) count *= dimension;
  if (!(count == static_cast<double>(m.values.size()) && dimensions[0] >= 0.0))
    reader.fail("a matrix has another number of values than its dimensions tell");
  m.rows = static_cast<std::size_t>(dimensions[0]);
  m.columns = m.rows > 0 ? m.values.size() / m.rows : 0;
}

void addMatrix(ByteReader reader, Matrices& matrices) {
  const auto flags = valuesOf(reader, elementAt(reader));
  if (flags.empty()) reader.fail("a matrix has no class");
  const auto array_class = static_cast<std::uint32_t>(flags[0]) & 0xff;
  if (array_class < kFirstNumericClass || array_class > kLastNumericClass) return;
  const auto dimensions = valuesOf(reader, elementAt(reader));
  const std::string name(elementAt(reader).bytes);
  MatlabMatrix matrix;
  matrix.values = valuesOf(reader, elementAt(reader));
  setShape(reader, dimensions, matrix);
  matrices[name] = std::move(matrix);
}

struct InflateEnd {
  z_stream& stream;
  ~InflateEnd() { inflateEnd(&stream); }
};

std::string inflated(const ByteReader& reader, std::string_view packed) {
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  const InflateEnd end{stream};
  std::string bytes;
  char block[1 << 14];
  for (int result = Z_OK; result != Z_STREAM_END;) {
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof(block);
    result = inflate(&stream, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_STREAM_END) reader.fail("a matrix cannot be decompressed");
    bytes.append(block, sizeof(block) - stream.avail_out);
    if (bytes.size() > kLargestMatrix) reader.fail("a matrix takes more than 1 GiB");
  }
  return bytes;
}

void addElements(ByteReader reader, Matrices& matrices) {
  while (!reader.isAtEnd()) {
    const auto element = elementAt(reader);
    if (element.type == kMatrix) addMatrix(within(reader, element.bytes), matrices);
    if (element.type != kCompressed) continue;
    const auto bytes = inflated(reader, element.bytes);
    ByteReader unpacked = within(reader, bytes);
    const auto inner = elementAt(unpacked);
    if (inner.type == kMatrix) addMatrix(within(reader, inner.bytes), matrices);
  }
}

Matrices readLevel5(const std::string& path, std::string_view bytes) {
  const auto order = bytes.substr(kEndianOffset, 2);
  if (order != "IM" && order != "MI")
    throw ImportError(path + " is no MATLAB file: its header names no byte order");
  Matrices matrices;
  addElements({path, bytes.substr(kHeaderBytes), order == "MI"}, matrices);
  return matrices;
}

/// The number "MOPT" that a matrix of level 4 begins with; M: byte order, P: type, T: kind.
struct Level4Type {
  std::uint32_t order, precision, kind;
};

std::optional<Level4Type> level4Type(std::uint32_t mopt) {
  const Level4Type type{mopt / 1000, mopt / 10 % 10, mopt % 10};
  if (type.order > 1 || mopt / 100 % 10 != 0 || type.precision > 5 || type.kind > 2)
    return std::nullopt;
  return type;
}

std::optional<MatlabMatrix> level4Matrix(ByteReader& reader, std::string& name) {
  constexpr std::uint32_t kTypes[] = {kDouble, kSingle, kInt32, kInt16, kUint16, kUint8};
  const auto type = level4Type(reader.number<std::uint32_t>());
  if (!type) reader.fail("a matrix of level 4 begins with a type that is none");
  MatlabMatrix matrix;
  matrix.rows = reader.number<std::uint32_t>();
  matrix.columns = reader.number<std::uint32_t>();
  const bool is_complex = reader.number<std::uint32_t>() != 0;
  name = std::string(reader.take(reader.number<std::uint32_t>()));
  name.resize(std::min(name.size(), name.find('\0')));
  if (matrix.columns > 0 && matrix.rows > kLargestMatrix / matrix.columns)
    reader.fail("a matrix takes more than 1 GiB");
  const std::size_t count = matrix.rows * matrix.columns;
  const auto code = kTypes[type->precision];
  ByteReader values = within(reader, reader.take(count * sizeOfType(code)));
  if (is_complex) reader.take(count * sizeOfType(code));
  if (type->kind != 0) return std::nullopt;
  matrix.values = numbersOf(values, code, count);
  return matrix;
}

/// Whether the bytes of level 4's numbers stand the other way round; empty: it is none.
std::optional<bool> level4Swap(const std::string& path, std::string_view bytes) {
  for (const bool swap : {false, true})
    if (level4Type(ByteReader(path, bytes, swap).number<std::uint32_t>())) return swap;
  return std::nullopt;
}

Matrices readLevel4(ByteReader reader) {
  Matrices matrices;
  while (!reader.isAtEnd()) {
    std::string name;
    if (auto matrix = level4Matrix(reader, name)) matrices[name] = std::move(*matrix);
  }
  return matrices;
}

}  // namespace

Matrices readMatlabFile(const std::string& path) {
  requireFile(path);
  const auto bytes = readInputFile(path);
  if (bytes.rfind("MATLAB 7.3", 0) == 0 || bytes.rfind("\x89HDF", 0) == 0)
    throw ImportError(path + " is of MATLAB's version 7.3, which is not read; save it with -v7");
  if (bytes.size() >= kHeaderBytes && bytes.rfind("MATLAB", 0) == 0) return readLevel5(path, bytes);
  const auto swap = bytes.size() >= 20 ? level4Swap(path, bytes) : std::nullopt;
  if (!swap) throw ImportError(path + " is no MATLAB file of level 4 or 5");
  return readLevel4({path, bytes, *swap});
}

}  // namespace slam::eval
