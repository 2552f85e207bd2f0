// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slam::eval {

/// Writes .mat files for tests.
class MatlabMaker {
 public:
  enum class Form { kLevel4, kLevel5, kLevel5Compressed };

  explicit MatlabMaker(Form form) : form_(form) {
    if (form == Form::kLevel4) return;
    bytes_ = "MATLAB 5.0 MAT-file, written by a test";
    bytes_.resize(124, ' ');
    append<std::uint16_t>(bytes_, 0x0100);
    bytes_ += "IM";
  }

  /// A matrix of doubles; values column by column.
  MatlabMaker& add(const std::string& name, std::uint32_t rows, std::uint32_t columns,
                   const std::vector<double>& values) {
    return add<double>(name, rows, columns, values, 6, 9, 0);
  }

  /// A matrix of unsigned 16 bit numbers, which the data set's scans are.
  MatlabMaker& addUint16(const std::string& name, std::uint32_t rows, std::uint32_t columns,
                         const std::vector<double>& values) {
    return add<std::uint16_t>(name, rows, columns, values, 11, 4, 40);
  }

  MatlabMaker& addColumn(const std::string& name, const std::vector<double>& values) {
    return add(name, static_cast<std::uint32_t>(values.size()), 1, values);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  static void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  static std::string element(std::uint32_t type, const std::string& data) {
    std::string bytes;
    append<std::uint32_t>(bytes, type);
    append<std::uint32_t>(bytes, static_cast<std::uint32_t>(data.size()));
    bytes += data;
    bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
    return bytes;
  }

  static std::string compressed(const std::string& bytes) {
    auto size = ::compressBound(bytes.size());
    std::string packed(size, '\0');
    ::compress(reinterpret_cast<Bytef*>(packed.data()), &size,
               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    packed.resize(size);
    std::string whole;
    append<std::uint32_t>(whole, 15);
    append<std::uint32_t>(whole, static_cast<std::uint32_t>(size));
    return whole + packed;
  }

  template <class T>
  MatlabMaker& add(const std::string& name, std::uint32_t rows, std::uint32_t columns,
                   const std::vector<double>& values, std::uint32_t array_class, std::uint32_t type,
                   std::uint32_t mopt) {
    std::string data;
    for (const double value : values) append<T>(data, static_cast<T>(value));
    if (form_ == Form::kLevel4) {
      for (const auto number : {mopt, rows, columns, 0u}) append(bytes_, number);
      append<std::uint32_t>(bytes_, static_cast<std::uint32_t>(name.size() + 1));
      bytes_ += name + '\0' + data;
      return *this;
    }
    std::string flags, dimensions;
    append(flags, array_class);
    append<std::uint32_t>(flags, 0);
    append(dimensions, rows);
    append(dimensions, columns);
    const auto matrix = element(
        14, element(6, flags) + element(5, dimensions) + element(1, name) + element(type, data));
    bytes_ += form_ == Form::kLevel5Compressed ? compressed(matrix) : matrix;
    return *this;
  }

  Form form_;
  std::string bytes_;
};

}  // namespace slam::eval
