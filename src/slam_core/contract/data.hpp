// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// A kind of data is a C++ type. Kinds need not be registered: including the type is enough.
using Kind = std::type_index;

template <class T>
Kind kindOf() {
  return typeid(T);
}

/// The type's name as C++ writes it ("slam::Motion"), for messages.
std::string nameOf(Kind kind);

/// A reference to a value of some kind that is passed from one port to another. The component that
/// made the value owns it.
class Datum {
 public:
  template <class T>
  static Datum of(const T& value) {
    return {kindOf<T>(), &value};
  }
  Kind kind() const { return kind_; }
  const void* value() const { return value_; }
  /// Null if it is of another kind.
  template <class T>
  const T* as() const {
    return kind_ == kindOf<T>() ? static_cast<const T*>(value_) : nullptr;
  }

 private:
  Datum(Kind kind, const void* value) : kind_(kind), value_(value) {}

  Kind kind_;
  const void* value_;
};

/// A value that waits for its turn, with its stamp and its number, by which it is ordered.
struct HeldDatum {
  Stamp stamp;
  std::uint64_t sequence = 0;
  std::shared_ptr<void> value;
};

namespace detail {

template <class T, class = void>
struct HasSequence : std::false_type {};
template <class T>
struct HasSequence<T, std::void_t<decltype(std::declval<T>().sequence)>> : std::true_type {};

template <class T, class = void>
struct HasStamp : std::false_type {};
template <class T>
struct HasStamp<T, std::void_t<decltype(std::declval<T>().stamp)>> : std::true_type {};

template <class T, class = void>
struct HasFault : std::false_type {};
template <class T>
struct HasFault<T, std::void_t<decltype(faultOf(std::declval<const T&>()))>> : std::true_type {};

}  // namespace detail

/// The functions by which values of a kind are ordered in time, checked, saved and restored. A kind
/// whose values trigger steps has a member `stamp`, and `sequence` if its source numbers them. A
/// free function `std::string faultOf(const T&)` beside the type says what makes a value unusable.
struct KindTraits {
  HeldDatum (*hold)(const void* value);        ///< null: the kind has no stamp
  std::string (*fault_of)(const void* value);  ///< empty: the value can be used
  /// Null: values of this kind cannot be put into a checkpoint, since they have no persist().
  void (*save)(const void* value, ArchiveWriter& archive) = nullptr;
  std::shared_ptr<void> (*restore)(ArchiveReader& archive) = nullptr;

  template <class T>
  static KindTraits of() {
    KindTraits traits{nullptr, [](const void*) { return std::string(); }, nullptr, nullptr};
    if constexpr (detail::HasStamp<T>::value)
      traits.hold = [](const void* value) {
        auto copy = std::make_shared<T>(*static_cast<const T*>(value));
        HeldDatum held{copy->stamp, 0, copy};
        if constexpr (detail::HasSequence<T>::value) held.sequence = copy->sequence;
        return held;
      };
    if constexpr (detail::HasFault<T>::value)
      traits.fault_of = [](const void* value) { return faultOf(*static_cast<const T*>(value)); };
    if constexpr (archive_traits::HasPersist<T, ArchiveWriter>::value) {
      traits.save = [](const void* value, ArchiveWriter& archive) {
        archive(*static_cast<const T*>(value));
      };
      traits.restore = [](ArchiveReader& archive) -> std::shared_ptr<void> {
        const auto value = std::make_shared<T>();
        archive(*value);
        return value;
      };
    }
    return traits;
  }
};

}  // namespace slam
