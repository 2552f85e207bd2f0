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

/// Reads the state of objects that are configured as those that were written.
/// @throw std::runtime_error from each call where the bytes are none of such objects; these are
/// then in no state to go on in
class ArchiveReader {
 public:
  static constexpr bool kReads = true;

  /// @param bytes outlive this
  explicit ArchiveReader(const std::string& bytes) : ArchiveReader(bytes.data(), bytes.size()) {}
  ArchiveReader(const char* bytes, std::size_t size) : bytes_(bytes, size) {}

  template <class... Members>
  void operator()(Members&... each) {
    (get(each), ...);
  }
  template <class Slot, class Make>
  void made(Slot& slot, const Make& make) {
    bool is_there = false;
    get(is_there);
    slot.reset();
    if (!is_there) return;
    slot = make();
    get(*slot);
  }
  template <class List, class Make>
  void list(List& list, const Make& make) {
    list.clear();
    for (auto left = bytes_.count(); left > 0; --left) {
      list.push_back(make());
      get(list.back());
    }
  }
  /// Each element that the caller reads takes at least a byte.
  void count(std::uint64_t& count) { count = bytes_.count(); }
  /// Reads the number that stands for an object which several may hold, and gives the object.
  /// @return whether the object follows; then the caller makes it, calls bind(), and reads it. Else
  /// the caller holds the object from now on, too, where it is not null.
  template <class T>
  bool refer(T*& object) {
    object = nullptr;
    std::uint64_t number = 0;
    get(number);
    if (number > shared_.size() + 1) refuse("a reference to nothing");
    if (number > shared_.size()) {
      shared_.push_back({typeid(std::remove_const_t<T>), nullptr});
      return true;
    }
    if (number == 0) return false;
    const auto& shared = shared_[number - 1];
    if (shared.type != typeid(std::remove_const_t<T>) || shared.object == nullptr)
      refuse("a reference to another kind of object");
    object = static_cast<T*>(shared.object);
    return false;
  }
  /// The object that refer() has asked for; it stays in its place while this reads.
  template <class T>
  void bind(T* object) {
    shared_.back().object = object;
  }
  /// @param read returns an object that it has read. Objects must not share themselves.
  template <class T, class Read>
  void shared(std::shared_ptr<T>& pointer, const Read& read) {
    T* object = nullptr;
    if (refer(object)) {
      const auto place = shared_.size() - 1;
      pointer = read();
      shared_[place].object = const_cast<std::remove_const_t<T>*>(pointer.get());
      owners_[shared_[place].object] = pointer;
    } else if (object == nullptr) {
      pointer.reset();
    } else {
      pointer = std::const_pointer_cast<T>(std::static_pointer_cast<const T>(owners_.at(object)));
    }
  }
  template <class T>
  void block(T* values, std::size_t count) {
    if constexpr (archive_traits::kIsBlock<T>) {
      if (count > 0) std::memcpy(values, bytes_.take(count * sizeof(T)), count * sizeof(T));
    } else {
      for (std::size_t i = 0; i < count; ++i) get(values[i]);
    }
  }
  std::size_t left() const { return bytes_.left(); }

 private:
  [[noreturn]] static void refuse(const std::string& what) {
    throw std::runtime_error("it holds " + what + ": save it again");
  }

  template <class T>
  void get(T& value) {
    if constexpr (std::is_enum_v<T>) {
      std::underlying_type_t<T> number;
      get(number);
      value = static_cast<T>(number);
    } else if constexpr (std::is_arithmetic_v<T>) {
      bytes_.number(value);
    } else if constexpr (archive_traits::kIsMatrix<T>) {
      getMatrix(value);
    } else {
      value.persist(*this);
    }
  }
  void get(bool& value) {
    const char byte = *bytes_.take(1);
    if (byte != 0 && byte != 1) refuse("a flag that is neither 0 nor 1");
    value = byte == 1;
  }
  template <class T>
  void getMatrix(T& matrix) {
    if constexpr (T::SizeAtCompileTime < 0) {
      std::uint64_t rows = 0, columns = 0;
      (*this)(rows, columns);
      requireFit<T>(rows, columns);
      matrix.resize(static_cast<std::ptrdiff_t>(rows), static_cast<std::ptrdiff_t>(columns));
    }
    block(matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
  template <class T>
  void requireFit(std::uint64_t rows, std::uint64_t columns) const {
    const auto most = left() / sizeof(typename T::Scalar);
    const auto fits = [](std::uint64_t edge, int fixed, int largest) {
      return fixed >= 0 ? edge == std::uint64_t(fixed)
                        : largest < 0 || edge <= std::uint64_t(largest);
    };
    if (!fits(rows, T::RowsAtCompileTime, T::MaxRowsAtCompileTime) ||
        !fits(columns, T::ColsAtCompileTime, T::MaxColsAtCompileTime) ||
        (columns > 0 && rows > most / columns) || rows > kLargestEdge || columns > kLargestEdge)
      refuse("a matrix of another size");
  }
  template <class Rep, class Period>
  void get(std::chrono::duration<Rep, Period>& duration) {
    Rep count;
    get(count);
    duration = std::chrono::duration<Rep, Period>(count);
  }
  template <class Clock, class Duration>
  void get(std::chrono::time_point<Clock, Duration>& time) {
    Duration since;
    get(since);
    time = std::chrono::time_point<Clock, Duration>(since);
  }
  void get(std::string& text) {
    const auto size = bytes_.count();
    text.assign(bytes_.take(size), size);
  }
  /// Lists grow with what is read, so that a number without the bytes to match takes no memory.
  template <class T>
  void get(std::vector<T>& list) {
    if constexpr (archive_traits::kIsBlock<T> && !std::is_same_v<T, bool>) {
      list.resize(bytes_.count(sizeof(T)));
      block(list.data(), list.size());
    } else {
      getAll(list);
    }
  }
  template <class T>
  void get(std::deque<T>& list) {
    getAll(list);
  }
  template <class List>
  void getAll(List& list) {
    list.clear();
    for (auto left = bytes_.count(); left > 0; --left) get(list.emplace_back());
  }
  void get(std::vector<bool>& list) {
    list.clear();
    for (auto left = bytes_.count(); left > 0; --left) {
      bool each = false;
      get(each);
      list.push_back(each);
    }
  }
  template <class T, std::size_t Size>
  void get(std::array<T, Size>& list) {
    block(list.data(), Size);
  }
  template <class First, class Second>
  void get(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class Key, class... Rest>
  void get(std::set<Key, Rest...>& set) {
    getKeys<Key>(set);
  }
  template <class Key, class... Rest>
  void get(std::unordered_set<Key, Rest...>& set) {
    getKeys<Key>(set);
  }
  template <class Key, class Set>
  void getKeys(Set& set) {
    set.clear();
    for (auto left = bytes_.count(); left > 0; --left) {
      Key key;
      get(key);
      set.insert(std::move(key));
    }
  }
  template <class Key, class Value, class... Rest>
  void get(std::map<Key, Value, Rest...>& map) {
    getEntries<Key>(map);
  }
  template <class Key, class Value, class... Rest>
  void get(std::unordered_map<Key, Value, Rest...>& map) {
    getEntries<Key>(map);
  }
  template <class Key, class Map>
  void getEntries(Map& map) {
    map.clear();
    for (auto left = bytes_.count(); left > 0; --left) {
      Key key;
      get(key);
      get(map[key]);
    }
  }
  template <class T>
  void get(std::optional<T>& value) {
    made(value, [] { return T(); });
  }
  template <class T>
  void get(std::unique_ptr<T>& pointer) {
    made(pointer, [] { return std::make_unique<T>(); });
  }
  template <class T>
  void get(std::shared_ptr<T>& pointer) {
    shared(pointer, [this] {
      const auto made = std::make_shared<std::remove_const_t<T>>();
      get(*made);
      return made;
    });
  }

  static constexpr std::uint64_t kLargestEdge = 1'000'000'000;  ///< of a matrix

  ByteReader bytes_;
  struct Shared {
    std::type_index type;
    void* object;
  };
  std::vector<Shared> shared_;                                 ///< in the order of their numbers
  std::map<const void*, std::shared_ptr<const void>> owners_;  // is only asked
};

}  // namespace slam
