// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "slam_core/common/byte_stream.hpp"
#include "slam_core/graph_slam/session_fields.hpp"

namespace slam::graph_slam {

/// Appends fields to a string of bytes.
class SessionWriter {
 public:
  template <class... Fields>
  void operator()(Fields&... each) {
    (put(each), ...);
  }
  std::string take() { return bytes_.take(); }

 private:
  template <class T>
  std::enable_if_t<std::is_arithmetic_v<T>> put(T value) {
    bytes_.number(value);
  }
  template <class T>
  std::enable_if_t<std::is_class_v<T>> put(T& record) {
    fields(*this, record);
  }
  void put(Stamp& stamp) { put(nanoseconds(stamp)); }
  void put(Pose2& pose) {
    for (const double value : {pose.x(), pose.y(), pose.theta()}) put(value);
  }
  template <int Rows, int Columns>
  void put(Eigen::Matrix<double, Rows, Columns>& matrix) {
    if (Rows == Eigen::Dynamic) put(static_cast<std::uint32_t>(matrix.rows()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) put(matrix(i, j));
  }
  void put(Descriptor::Vector& values) {
    put(static_cast<std::uint8_t>(values.size()));
    for (const float value : values) put(value);
  }
  void put(std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text.data(), text.size());
  }
  template <class T>
  void put(std::vector<T>& list) {
    put(static_cast<std::uint64_t>(list.size()));
    for (auto& each : list) put(each);
  }
  template <class T>
  void put(std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  void put(Session::Factor& factor) {
    put(static_cast<std::uint8_t>(factor.index()));
    std::visit([this](auto& record) { put(record); }, factor);
  }
  void put(SharedScan& scan) {
    LaserScan copy = *scan;
    put(copy);
  }

  ByteWriter bytes_;
};

/// Takes fields off a string of bytes. Lists grow with what is read, so that a count without the
/// bytes to match takes no memory.
/// @throw std::runtime_error from each call where the bytes are none of a session
class SessionReader {
 public:
  /// @param bytes outlive this
  SessionReader(const char* bytes, std::size_t size) : bytes_(bytes, size) {}

  template <class... Fields>
  void operator()(Fields&... each) {
    (get(each), ...);
  }
  std::size_t left() const { return bytes_.left(); }

 private:
  template <class T>
  std::enable_if_t<std::is_arithmetic_v<T>> get(T& value) {
    bytes_.number(value);
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value))
        throw std::runtime_error("it holds a value that is not finite: save the session again");
  }
  void get(bool& value) {
    const char byte = *bytes_.take(1);
    if (byte != 0 && byte != 1) refuse("a flag that is neither 0 nor 1");
    value = byte == 1;
  }
  template <class T>
  std::enable_if_t<std::is_class_v<T>> get(T& record) {
    fields(*this, record);
  }
  void get(Stamp& stamp) {
    std::int64_t ns = 0;
    get(ns);
    stamp = stampFromNanoseconds(ns);
  }
  void get(Pose2& pose) {
    double x = 0.0, y = 0.0, theta = 0.0;
    (*this)(x, y, theta);
    if (std::abs(theta) > M_PI) refuse("a heading beyond half a turn");
    pose = Pose2(x, y, theta);
  }
  template <int Rows, int Columns>
  void get(Eigen::Matrix<double, Rows, Columns>& matrix) {
    if constexpr (Rows == Eigen::Dynamic) matrix.resize(edge(), matrix.cols());
    if constexpr (Columns == Eigen::Dynamic) matrix.resize(matrix.rows(), matrix.rows());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        double value = 0.0;
        get(value);
        matrix(i, j) = value;
      }
  }
  void get(Descriptor::Vector& values) {
    std::uint8_t size = 0;
    get(size);
    if (size > Descriptor::kMostElements) refuse("a descriptor that is too long");
    values.resize(size);
    for (auto& value : values) get(value);
  }
  /// Takes the number of rows of a square matrix, whose values follow.
  Eigen::Index edge() {
    std::uint32_t rows = 0;
    get(rows);
    if (std::uint64_t{rows} * rows > left() / sizeof(double)) refuse("a matrix without its values");
    return rows;
  }
  void get(std::string& text) {
    const auto size = bytes_.count();
    text.assign(bytes_.take(size), size);
  }
  template <class T>
  void get(std::vector<T>& list) {
    list.clear();
    for (auto left = bytes_.count(); left > 0; --left) get(list.emplace_back());
  }
  template <class T>
  void get(std::optional<T>& value) {
    bool has_value = false;
    get(has_value);
    value.reset();
    if (!has_value) return;
    value = T();  // clang 14 takes no emplace() of a nested struct with default values
    get(*value);
  }
  void get(Session::Factor& factor) {
    std::uint8_t kind = 0;
    get(kind);
    getFactor(kind, factor, std::make_index_sequence<std::variant_size_v<Session::Factor>>());
  }
  template <std::size_t... Kinds>
  void getFactor(std::uint8_t kind, Session::Factor& factor, std::index_sequence<Kinds...>) {
    const bool is_known = ((kind == Kinds && (get(factor.template emplace<Kinds>()), true)) || ...);
    if (!is_known) refuse("a factor of unknown kind");
  }
  void get(SharedScan& scan) {
    auto read = std::make_shared<LaserScan>();
    get(*read);
    scan = std::move(read);
  }
  [[noreturn]] static void refuse(const std::string& what) {
    throw std::runtime_error("it holds " + what + ": save the session again");
  }

  ByteReader bytes_;
};

}  // namespace slam::graph_slam
