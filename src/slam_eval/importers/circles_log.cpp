// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "circles_log.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <fstream>
#include <sstream>

#include "import_error.hpp"
#include "text_table.hpp"

namespace slam::eval {
namespace {

// The columns of a line, the first word being its kind.
constexpr std::size_t kStepColumns = 11;    // image, displacement, six of the covariance
constexpr std::size_t kReadingColumns = 8;  // position, quality, three of the covariance, an id

/// From the file's axes to REP-103.
Eigen::Matrix2d toRep103() { return (Eigen::Matrix2d() << 0, -1, -1, 0).finished(); }

/// [m], [rad] and their squares: a value beyond is no robot's.
constexpr double kLargestValue = 1e6;

double numberOf(const TextRow& row, const std::string& place, std::size_t column) {
  const double value = row.number(column);
  if (std::abs(value) <= kLargestValue) return value;
  std::ostringstream text;
  text << place << ": column " << column + 1 << ": " << value << " is beyond " << kLargestValue
       << ", which nothing on a floor is";
  throw ImportError(text.str());
}

std::int64_t idOf(const TextRow& row, const std::string& place, std::size_t column) {
  const auto id = row.integer(column);
  if (id >= -1) return id;
  throw ImportError(place + ": column " + std::to_string(column + 1) + ": the id " +
                    std::to_string(id) + " is negative; only -1, not identified, may be");
}

template <class Matrix>
const Matrix& requireCovariance(const Matrix& covariance, const std::string& place) {
  if (Eigen::LLT<Matrix>(covariance).info() == Eigen::Success) return covariance;
  throw ImportError(place + ": the covariance is not positive definite");
}

CirclesLog::Step stepOf(const TextRow& row, const std::string& place) {
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero(), Q;
  J.topLeftCorner<2, 2>() = toRep103();
  J(2, 2) = -1.0;
  const double xx = numberOf(row, place, 5), xy = numberOf(row, place, 6),
               yy = numberOf(row, place, 7);
  const double xt = numberOf(row, place, 8), yt = numberOf(row, place, 9),
               tt = numberOf(row, place, 10);
  Q << xx, xy, xt, xy, yy, yt, xt, yt, tt;
  CirclesLog::Step step;
  step.displacement = J * Eigen::Vector3d(numberOf(row, place, 2), numberOf(row, place, 3),
                                          numberOf(row, place, 4));
  step.covariance = J * requireCovariance(Q, place) * J.transpose();
  return step;
}

CirclesLog::Reading readingOf(const TextRow& row, const std::string& place) {
  const Eigen::Vector2d p =
      toRep103() * Eigen::Vector2d(numberOf(row, place, 1), numberOf(row, place, 2));
  const double xx = numberOf(row, place, 4), xy = numberOf(row, place, 5),
               yy = numberOf(row, place, 6), r2 = p.squaredNorm();
  if (r2 == 0.0) throw ImportError(place + ": a circle at the robot's very centre has no bearing");
  Eigen::Matrix2d P, J;
  P << xx, xy, xy, yy;
  CirclesLog::Reading reading;
  numberOf(row, place, 3);  // the quality, which nobody needs
  reading.id = idOf(row, place, 7);
  reading.range = std::sqrt(r2);
  reading.bearing = std::atan2(p.y(), p.x());
  J << p.x() / reading.range, p.y() / reading.range, -p.y() / r2, p.x() / r2;
  J *= toRep103();
  reading.covariance = J * requireCovariance(P, place) * J.transpose();
  return reading;
}

void requireColumns(const TextRow& row, bool right, const std::string& place,
                    const std::string& expected) {
  if (!right)
    throw ImportError(place + ": " + std::to_string(row.size()) + " columns, expected " + expected +
                      " (truncated, or another format)");
}

void addLine(CirclesLog& log, const TextRow& row, const std::string& kind,
             const std::string& place) {
  if (kind == "STEP") {
    requireColumns(row, row.size() == kStepColumns, place, std::to_string(kStepColumns));
    log.steps.push_back(stepOf(row, place));
  } else if (kind == "LANDMARK" || kind == "LANDMARK_C") {
    requireColumns(row, row.size() >= kReadingColumns, place,
                   std::to_string(kReadingColumns) + " or more");
    if (log.steps.empty()) throw ImportError(place + ": a landmark before the first step");
    log.steps.back().readings.push_back(readingOf(row, place));
    log.several_ids += row.size() > kReadingColumns;
    log.unidentified += log.steps.back().readings.back().id < 0;
  } else {
    throw ImportError(place + ": '" + kind + "' is neither STEP nor LANDMARK");
  }
}

}  // namespace

CirclesLog readCircles(const std::string& path) {
  if (const auto fault = inputFileFault(path); !fault.empty())
    throw ImportError("cannot read " + path + ": " + fault);
  std::ifstream file(path);
  if (!file) throw ImportError("cannot read " + path);
  CirclesLog log;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(word);
    if (fields.empty() || fields.front().front() == '#') continue;
    const std::string kind = fields.front(), place = path + ":" + std::to_string(number);
    addLine(log, TextRow(place, std::move(fields)), kind, place);
  }
  if (file.bad()) throw ImportError("cannot read " + path);
  if (log.steps.empty()) throw ImportError(path + " holds no steps");
  return log;
}

}  // namespace slam::eval
