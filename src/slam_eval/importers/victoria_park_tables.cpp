// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <initializer_list>
#include <optional>

#include "import_error.hpp"
#include "matlab_file.hpp"
#include "victoria_park_log.hpp"

namespace slam::eval {
namespace {

namespace fs = std::filesystem;

using ParkTable = VictoriaParkTables::Table;
using Matrices = std::map<std::string, MatlabMatrix>;

constexpr std::size_t kBeams = 361;

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The folder's files by their names in lower case.
std::map<std::string, std::string> filesOf(const std::string& folder) {
  if (!fs::is_directory(folder)) throw UsageError("there is no folder " + folder);
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[lowerCase(entry.path().filename().string())] = entry.path().string();
  return files;
}

const std::vector<double>* vectorIn(const Matrices& matrices,
                                    std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto found = matrices.find(name); found != matrices.end() && found->second.isVector())
      return &found->second.values;
  return nullptr;
}

std::optional<ParkTable> vectorsIn(const std::string& path, const Matrices& matrices,
                                   std::initializer_list<const char*> time_names,
                                   std::initializer_list<const char*> columns) {
  ParkTable table{path, {}, {}};
  for (const char* name : columns) {
    const auto* column = vectorIn(matrices, {name});
    if (column == nullptr) return std::nullopt;
    table.columns.push_back(*column);
  }
  const auto* time = vectorIn(matrices, time_names);
  if (time == nullptr)
    throw ImportError(path + " holds " + *columns.begin() + ", but no " + *time_names.begin());
  table.time = *time;
  return table;
}

/// One row a scan, as the data set has it, or one column.
std::optional<ParkTable> scansIn(const std::string& path, const Matrices& matrices) {
  const auto found = matrices.find("LASER");
  if (found == matrices.end()) return std::nullopt;
  const auto& laser = found->second;
  const auto* time = vectorIn(matrices, {"TLsr", "timeLsr", "timeLaser", "TimeLaser"});
  if (time == nullptr) throw ImportError(path + " holds LASER, but no TLsr");
  if (laser.columns != kBeams && laser.rows != kBeams)
    throw ImportError(path + ": LASER is " + std::to_string(laser.rows) + " x " +
                      std::to_string(laser.columns) + ", where scans have 361 ranges");
  const bool is_row_a_scan = laser.columns == kBeams;
  ParkTable table{path, *time, std::vector<std::vector<double>>(kBeams)};
  const std::size_t scans = is_row_a_scan ? laser.rows : laser.columns;
  for (std::size_t beam = 0; beam < kBeams; ++beam)
    for (std::size_t scan = 0; scan < scans; ++scan)
      table.columns[beam].push_back(is_row_a_scan ? laser.at(scan, beam) : laser.at(beam, scan));
  return table;
}

void requireEqualLengths(const ParkTable& table) {
  for (const auto& column : table.columns)
    if (column.size() != table.time.size())
      throw ImportError(table.path + " holds " + std::to_string(table.time.size()) +
                        " times, but " + std::to_string(column.size()) + " values");
}

void takeFirst(ParkTable& target, const std::optional<ParkTable>& found) {
  if (!found || !target.path.empty()) return;
  requireEqualLengths(*found);
  target = *found;
}

void addMatlabFile(const std::string& path, VictoriaParkTables& tables) {
  const auto matrices = readMatlabFile(path);
  takeFirst(tables.laser, scansIn(path, matrices));
  takeFirst(tables.driving,
            vectorsIn(path, matrices, {"time", "timeOdo", "time_VS"}, {"speed", "steering"}));
  takeFirst(tables.gps, vectorsIn(path, matrices, {"timeGps", "timeGPS"}, {"Lo_m", "La_m"}));
}

bool isSeparator(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; }

/// The numbers of a text file, wherever its lines break; words of a first line are headings.
std::vector<double> numbersIn(const std::string& path) {
  const auto text = readInputFile(path);
  std::vector<double> numbers;
  std::size_t line = 1;
  for (const char *at = text.data(), *end = at + text.size(); at < end;) {
    if (isSeparator(*at)) {
      line += *at++ == '\n';
      continue;
    }
    double value = 0.0;
    const char* word_end = std::find_if(at, end, isSeparator);
    const auto [rest, error] = std::from_chars(at, word_end, value);
    const bool is_number = error == std::errc() && rest == word_end;
    if (!is_number && !(line == 1 && numbers.empty()))
      throw ImportError(path + ":" + std::to_string(line) + ": '" + std::string(at, word_end) +
                        "' is no number");
    if (is_number) numbers.push_back(value);
    at = word_end;
  }
  return numbers;
}

ParkTable textTable(const std::string& path, std::size_t columns) {
  const auto numbers = numbersIn(path);
  const std::size_t width = columns + 1;
  if (numbers.empty() || numbers.size() % width != 0)
    throw ImportError(path + " holds " + std::to_string(numbers.size()) +
                      " numbers, where each row has " + std::to_string(width) +
                      " (truncated, or another format)");
  ParkTable table{path, {}, std::vector<std::vector<double>>(columns)};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    (i % width == 0 ? table.time : table.columns[i % width - 1]).push_back(numbers[i]);
  return table;
}

void addTextFiles(const std::map<std::string, std::string>& files, VictoriaParkTables& tables) {
  const auto add = [&](ParkTable& table, std::initializer_list<const char*> names,
                       std::size_t columns) {
    for (const char* name : names)
      if (const auto found = files.find(name); found != files.end() && table.path.empty())
        table = textTable(found->second, columns);
  };
  add(tables.laser, {"laser.txt", "aa3_lsr2.txt", "aa3_lsr.txt"}, kBeams);
  add(tables.driving, {"drs.txt", "dr.txt", "aa3_dr.txt"}, 2);
  const bool is_named = !tables.gps.path.empty();
  add(tables.gps, {"gps.txt", "aa3_gpsx.txt", "aa3_gps.txt"}, 2);
  tables.is_gps_named = is_named || tables.gps.path.empty();
}

}  // namespace

VictoriaParkTables readVictoriaParkTables(const std::string& folder) {
  const auto files = filesOf(folder);
  VictoriaParkTables tables;
  for (const auto& [name, path] : files)
    if (fs::path(name).extension() == ".mat") addMatlabFile(path, tables);
  addTextFiles(files, tables);
  if (tables.laser.path.empty())
    throw ImportError(folder + " holds no laser scans (aa3_lsr2.mat or LASER.txt)");
  if (tables.driving.path.empty())
    throw ImportError(folder + " holds no speed and steering (aa3_dr.mat or DRS.txt)");
  return tables;
}

}  // namespace slam::eval
