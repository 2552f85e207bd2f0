// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <typeinfo>

#include "slam_core/contract/data.hpp"

namespace slam {

/// Which class was registered under a name, and in which source file. Names are copied, so that no
/// pointer into an unloaded library remains.
class Registration {
 public:
  template <class T>
  static Registration of(const char* file) {
    return {typeid(T), file};
  }

  /// Whether the same class is registered once more: its library was loaded from two places, or is
  /// linked into two programs. Classes of unnamed namespaces may have the same name in two
  /// libraries; they are the same class only if their source file is the same as well.
  bool isSameAs(const Registration& other) const {
    const bool has_unique_name = symbol_.find("_GLOBAL__N_") == std::string::npos;
    return symbol_ == other.symbol_ && (has_unique_name || file_ == other.file_);
  }
  /// "slam::ekf::EkfSlam (ekf_slam.cpp)", for messages.
  std::string text() const { return class_name_ + " (" + file_.substr(file_.rfind('/') + 1) + ")"; }

 private:
  Registration(const std::type_info& type, const char* file)
      : symbol_(type.name()), class_name_(nameOf(Kind(type))), file_(file) {}

  std::string symbol_, class_name_, file_;
};

}  // namespace slam
