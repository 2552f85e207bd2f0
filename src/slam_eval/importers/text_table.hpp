// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace slam::eval {

/// One line of a text file, split at white space.
/// Every reader names file and line in its ImportError when the field is not what it must be.
class TextRow {
 public:
  TextRow(std::string place, std::vector<std::string> fields);

  std::size_t size() const { return fields_.size(); }

  /// File and line, as messages name it.
  const std::string& place() const { return place_; }

  const std::string& text(std::size_t column) const { return fields_.at(column); }

  /// A time "seconds.fraction" [s] as [ns], read digit by digit: a double holds no nanoseconds of
  /// today's clock. At most nine decimals.
  std::int64_t stamp(std::size_t column) const;

  /// A finite number.
  double number(std::size_t column) const;

  std::int64_t integer(std::size_t column) const;

 private:
  [[noreturn]] void fail(std::size_t column, std::string_view expected) const;

  std::string place_;
  std::vector<std::string> fields_;
};

/// The rows of a white-space separated file, of any number of columns; empty lines and those
/// starting with @p comment are left out.
/// @throw ImportError the file cannot be read, or holds no row
std::vector<TextRow> readRows(const std::string& path, char comment);

/// The rows of a white-space separated file; empty lines and those starting with @p comment are
/// left out.
/// @throw ImportError the file cannot be read, holds no row, or a row has not @p columns columns
std::vector<TextRow> readTable(const std::string& path, std::size_t columns, char comment);

}  // namespace slam::eval
