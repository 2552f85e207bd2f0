// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/contract/ports.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>

namespace slam {
namespace {

template <class Port>
const Port* find(const std::deque<Port>& ports, const std::string& name, Kind kind) {
  const auto found = std::find_if(ports.begin(), ports.end(), [&](const Port& port) {
    return port.name == name && port.kind == kind;
  });
  return found == ports.end() ? nullptr : &*found;
}

}  // namespace

std::string nameOf(Kind kind) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(kind.name(), nullptr, nullptr, &status), std::free);
  return status == 0 ? name.get() : kind.name();
}

const InputPort* Ports::input(const std::string& name, Kind kind) const {
  return find(inputs_, name, kind);
}

const OutputPort* Ports::output(const std::string& name, Kind kind) const {
  return find(outputs_, name, kind);
}

}  // namespace slam
