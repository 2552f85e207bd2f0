// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <type_traits>
#include <utility>

/// What archives ask of a type.
namespace slam::archive_traits {

/// A matrix or an array of Eigen; asked without Eigen, which not all of the core links.
template <class T, class = void>
struct IsMatrix : std::false_type {};
template <class T>
struct IsMatrix<T, std::void_t<typename T::Scalar, decltype(T::SizeAtCompileTime),
                               decltype(std::declval<T&>().data())>> : std::true_type {};
template <class T>
constexpr bool kIsMatrix = IsMatrix<T>::value;

/// Numbers whose bytes stand in memory as they stand in an archive. Flags are checked one by one.
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
template <class T>
constexpr bool kIsBlock = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
#else
template <class T>
constexpr bool kIsBlock = std::is_arithmetic_v<T> && sizeof(T) == 1 && !std::is_same_v<T, bool>;
#endif

/// Whether a class lists its members for an archive.
template <class T, class Archive, class = void>
struct HasPersist : std::false_type {};
template <class T, class Archive>
struct HasPersist<T, Archive,
                  std::void_t<decltype(std::declval<T&>().persist(std::declval<Archive&>()))>>
    : std::true_type {};

}  // namespace slam::archive_traits
