// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "slam_core/common/archive_traits.hpp"
#include "slam_core/common/byte_stream.hpp"

namespace slam {

/// Writes the state of objects. It refers to objects that it has written until it is destroyed.
class ArchiveWriter {
 public:
  static constexpr bool kReads = false;

  template <class... Members>
  void operator()(const Members&... each) {
    (put(each), ...);
  }
  /// An optional or a pointer to an object that `make` makes as its configuration says.
  template <class Slot, class Make>
  void made(const Slot& slot, const Make& /*make*/) {
    put(bool(slot));
    if (slot) put(*slot);
  }
  /// A vector or deque of objects that `make` makes as their configuration says.
  template <class List, class Make>
  void list(const List& list, const Make& /*make*/) {
    putAll(list);
  }
  /// The number of elements that the caller writes one by one.
  void count(std::uint64_t count) { put(count); }
  /// Writes the number that stands for an object which several may hold, 0 for none.
  /// @return whether it is the first time, so that the object has to follow
  template <class T>
  bool refer(T* const& object) {
    if (object == nullptr) return put(std::uint64_t{0}), false;
    const auto key = std::make_pair(static_cast<const void*>(object),
                                    std::type_index(typeid(std::remove_const_t<T>)));
    const auto [entry, is_new] = shared_.emplace(key, std::uint64_t{shared_.size() + 1});
    put(entry->second);
    return is_new;
  }
  template <class T>
  void bind(T* /*object*/) {}  ///< see ArchiveReader
  /// An object of a kind that `write` writes, the first time.
  template <class T, class Write>
  void shared(const std::shared_ptr<T>& pointer, const Write& write) {
    if (refer(pointer.get())) write();
  }
  /// Numbers that stand one behind another.
  template <class T>
  void block(const T* values, std::size_t count) {
    if constexpr (archive_traits::kIsBlock<T>)
      bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
    else
      for (std::size_t i = 0; i < count; ++i) put(values[i]);
  }
  std::string take() { return bytes_.take(); }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_enum_v<T>)
      put(static_cast<std::underlying_type_t<T>>(value));
    else if constexpr (std::is_arithmetic_v<T>)
      bytes_.number(value);
    else if constexpr (archive_traits::kIsMatrix<T>)
      putMatrix(value);
    else
      const_cast<T&>(value).persist(*this);  // which changes nothing where it writes
  }
  template <class T>
  void putMatrix(const T& matrix) {
    if constexpr (T::SizeAtCompileTime < 0)
      (*this)(std::uint64_t(matrix.rows()), std::uint64_t(matrix.cols()));
    block(matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
  template <class Rep, class Period>
  void put(const std::chrono::duration<Rep, Period>& duration) {
    put(duration.count());
  }
  template <class Clock, class Duration>
  void put(const std::chrono::time_point<Clock, Duration>& time) {
    put(time.time_since_epoch());
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    bytes_.append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& list) {
    if constexpr (archive_traits::kIsBlock<T> && !std::is_same_v<T, bool>) {
      put(std::uint64_t{list.size()});
      block(list.data(), list.size());
    } else {
      putAll(list);
    }
  }
  template <class T>
  void put(const std::deque<T>& list) {
    putAll(list);
  }
  template <class T, std::size_t Size>
  void put(const std::array<T, Size>& list) {
    block(list.data(), Size);
  }
  template <class First, class Second>
  void put(const std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class Key, class... Rest>
  void put(const std::set<Key, Rest...>& set) {
    putAll(set);
  }
  template <class Key, class Value, class... Rest>
  void put(const std::map<Key, Value, Rest...>& map) {
    putAll(map);
  }
  template <class Key, class... Rest>
  void put(const std::unordered_set<Key, Rest...>& set) {
    putAll(std::set<Key>(set.begin(), set.end()));
  }
  template <class Key, class Value, class... Rest>
  void put(const std::unordered_map<Key, Value, Rest...>& map) {
    std::map<Key, const Value*> sorted;
    for (const auto& [key, value] : map) sorted[key] = &value;
    put(std::uint64_t{sorted.size()});
    for (const auto& [key, value] : sorted) (*this)(key, *value);
  }
  template <class List>
  void putAll(const List& list) {
    put(std::uint64_t{list.size()});
    for (const auto& each : list) put(each);
  }
  void put(const std::vector<bool>& list) {
    put(std::uint64_t{list.size()});
    for (const bool each : list) put(each);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class T>
  void put(const std::unique_ptr<T>& pointer) {
    put(pointer != nullptr);
    if (pointer) put(*pointer);
  }
  template <class T>
  void put(const std::shared_ptr<T>& pointer) {
    shared(pointer, [&] { put(*pointer); });
  }

  ByteWriter bytes_;
  std::map<std::pair<const void*, std::type_index>, std::uint64_t> shared_;  // is only asked
};

}  // namespace slam
