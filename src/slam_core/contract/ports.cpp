// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/contract/ports.hpp"

#include <cxxabi.h>

#include <cstdlib>

namespace slam {

std::string nameOf(Kind kind) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(kind.name(), nullptr, nullptr, &status), std::free);
  return status == 0 ? name.get() : kind.name();
}

}  // namespace slam
