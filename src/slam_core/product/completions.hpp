// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "slam_core/contract/data.hpp"

namespace slam {

/// What fills in what data of some kinds lack, before anyone gets them.
class Completions {
 public:
  /// @return this
  template <class T>
  Completions& add(std::function<void(T&)> fill_in) {
    by_kind_[kindOf<T>()] = [fill_in = std::move(fill_in)](const void* value) {
      auto copy = std::make_shared<T>(*static_cast<const T*>(value));
      fill_in(*copy);
      return copy;
    };
    return *this;
  }

  /// The value, or a copy that lacks nothing, which lives as long as `copy`.
  const void* complete(Kind kind, const void* value, std::shared_ptr<void>& copy) const {
    const auto completion = by_kind_.find(kind);
    if (completion == by_kind_.end()) return value;
    copy = completion->second(value);
    return copy.get();
  }

 private:
  std::map<Kind, std::function<std::shared_ptr<void>(const void*)>> by_kind_;
};

}  // namespace slam
