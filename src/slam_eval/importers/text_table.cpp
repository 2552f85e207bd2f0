// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_table.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "import_error.hpp"

namespace slam::eval {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::size_t kDecimals = 9;

/// Digits only: no sign, no space, nothing behind.
bool parseDigits(std::string_view text, std::int64_t& value) {
  if (text.empty() || text.find_first_not_of("0123456789") != text.npos) return false;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc();
}

bool parseStamp(std::string_view text, std::int64_t& stamp) {
  const std::size_t point = text.find('.');
  std::string decimals(point == text.npos ? "0" : text.substr(point + 1));
  if (decimals.empty() || decimals.size() > kDecimals) return false;
  decimals.append(kDecimals - decimals.size(), '0');
  std::int64_t seconds = 0;
  std::int64_t nanoseconds = 0;
  if (!parseDigits(text.substr(0, point), seconds) || !parseDigits(decimals, nanoseconds)) {
    return false;
  }
  if (seconds > std::numeric_limits<std::uint32_t>::max()) return false;
  stamp = seconds * kNanosecondsPerSecond + nanoseconds;
  return stamp > 0;
}

std::vector<std::string> split(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

}  // namespace

TextRow::TextRow(std::string place, std::vector<std::string> fields)
    : place_(std::move(place)), fields_(std::move(fields)) {}

std::int64_t TextRow::stamp(std::size_t column) const {
  std::int64_t value = 0;
  if (!parseStamp(fields_.at(column), value)) fail(column, "a time in seconds above 0");
  return value;
}

double TextRow::number(std::size_t column) const {
  const std::string& text = fields_.at(column);
  const char* end = text.data() + text.size();
  double value = 0.0;
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) {
    fail(column, "a number");
  }
  return value;
}

std::int64_t TextRow::integer(std::size_t column) const {
  const std::string& text = fields_.at(column);
  const char* end = text.data() + text.size();
  std::int64_t value = 0;
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) fail(column, "a whole number");
  return value;
}

void TextRow::fail(std::size_t column, std::string_view expected) const {
  throw ImportError(place_ + ": column " + std::to_string(column + 1) + " is '" +
                    fields_.at(column) + "', expected " + std::string(expected));
}

std::vector<TextRow> readRows(const std::string& path, char comment) {
  if (const auto fault = inputFileFault(path); !fault.empty())
    throw ImportError("cannot read " + path + ": " + fault);
  std::ifstream file(path);
  if (!file) throw ImportError("cannot read " + path);
  std::vector<TextRow> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::vector<std::string> fields = split(line);
    if (fields.empty() || fields.front().front() == comment) continue;
    rows.emplace_back(path + ":" + std::to_string(number), std::move(fields));
  }
  if (file.bad()) throw ImportError("cannot read " + path);
  if (rows.empty()) throw ImportError(path + " holds no rows");
  return rows;
}

std::vector<TextRow> readTable(const std::string& path, std::size_t columns, char comment) {
  auto rows = readRows(path, comment);
  for (const auto& row : rows) {
    if (row.size() == columns) continue;
    throw ImportError(row.place() + ": " + std::to_string(row.size()) + " columns, expected " +
                      std::to_string(columns) + " (truncated, or another format)");
  }
  return rows;
}

}  // namespace slam::eval
