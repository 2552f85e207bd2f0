// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "slam_core/common/archive_traits.hpp"
#include "slam_core/common/test/fuzz/fuzz_bytes.hpp"

namespace slam::test {

/// Changes a field of a message or a map to what bytes say. It looks at the fields as an archive
/// does, so that it knows those of every kind that has persist(): numbers, elements of matrices,
/// stamps, texts, how long lists are, whether an optional value is there.
class FieldChange {
 public:
  static constexpr bool kReads = true;

  /// Changes one field of the value.
  template <class T>
  static void in(T& value, FuzzBytes& bytes) {
    FieldChange all(bytes, kNone);
    value.persist(all);
    FieldChange one(bytes, bytes.below(all.fields_));
    value.persist(one);
  }

  template <class... Members>
  void operator()(Members&&... each) {
    (look(each), ...);
  }

 private:
  static constexpr std::uint64_t kNone = UINT64_MAX;
  static constexpr std::uint64_t kLongest = 600;  ///< list

  FuzzBytes& bytes_;
  std::uint64_t chosen_, fields_ = 0;

  FieldChange(FuzzBytes& bytes, std::uint64_t chosen) : bytes_(bytes), chosen_(chosen) {}

  bool isChosen() { return fields_++ == chosen_; }

  template <class T>
  void look(T& value) {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
      if (isChosen()) value = static_cast<T>(bytes_.below(2));
    } else if constexpr (std::is_floating_point_v<T>) {
      if (isChosen()) value = narrowed<T>(bytes_.number());
    } else if constexpr (std::is_arithmetic_v<T>) {
      if (isChosen()) value = bytes_.below(2) == 0 ? bytes_.bits<T>() : T(value + 1);
    } else if constexpr (archive_traits::kIsMatrix<T>) {
      for (Eigen::Index i = 0; i < value.size(); ++i) look(value.data()[i]);
    } else {
      value.persist(*this);
    }
  }
  /// A double that a float cannot hold becomes infinite.
  template <class T>
  static T narrowed(double value) {
    if (std::abs(value) <= double(std::numeric_limits<T>::max())) return static_cast<T>(value);
    return value > 0.0   ? std::numeric_limits<T>::infinity()
           : value < 0.0 ? -std::numeric_limits<T>::infinity()
                         : std::numeric_limits<T>::quiet_NaN();
  }
  /// Stamps are some time off, or any.
  template <class Clock, class Unit>
  void look(std::chrono::time_point<Clock, Unit>& stamp) {
    if (!isChosen()) return;
    const auto since = stamp.time_since_epoch().count();
    const auto off = static_cast<std::int64_t>(bytes_.bits<std::int16_t>()) * 10'000'000;
    stamp = std::chrono::time_point<Clock, Unit>(
        Unit(bytes_.below(8) == 0 ? bytes_.bits<std::int64_t>() : since + off));
  }
  void look(std::string& text) {
    static const std::string kTexts[] = {"", "map", "odom", "base_link", "laser", "another"};
    if (isChosen()) text = kTexts[bytes_.below(std::size(kTexts))];
  }
  template <class T>
  void look(std::vector<T>& list) {
    const T last = list.empty() ? T() : list.back();
    if (isChosen()) list.resize(bytes_.below(kLongest), last);
    for (auto& each : list) look(each);
  }
  template <class T>
  void look(std::optional<T>& value) {
    if (isChosen()) value = value ? std::optional<T>() : std::optional<T>(T());
    if (value) look(*value);
  }
};

}  // namespace slam::test
