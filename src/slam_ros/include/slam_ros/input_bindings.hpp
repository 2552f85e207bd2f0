// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_ros/bag_input.hpp"
#include "slam_ros/input_binding.hpp"

namespace slam_ros {

/// The registry of bindings, by the kind of their data. A binding registers itself, so that a
/// package can bring one for its own kind of data.
class InputBindings {
 public:
  /// Functions that create the two ways by which data of a kind reach an input: `live` subscribes
  /// to topics of other nodes, `in_bag` reads a bag.
  struct Binding {
    std::function<std::unique_ptr<InputBinding>(const InputContext& context,
                                                const slam::InputPort& port)>
        live;
    std::function<std::unique_ptr<BagInput>(const BagContext& context, const std::string& port)>
        in_bag;
  };

  static InputBindings& instance();
  void add(slam::Kind kind, Binding binding) { bindings_.emplace(kind, std::move(binding)); }
  bool has(slam::Kind kind) const { return bindings_.count(kind) > 0; }
  /// The names of the kinds that have bindings, sorted.
  std::vector<std::string> kinds() const;
  /// @throw slam::ConfigError if no binding brings the kind, or if several do
  std::unique_ptr<InputBinding> create(const InputContext& context,
                                       const slam::InputPort& port) const;
  /// The same for a bag. @throw slam::ConfigError as above
  std::unique_ptr<BagInput> createInBag(const BagContext& context, const std::string& port,
                                        slam::Kind kind) const;

 private:
  const Binding& of(const std::string& port, slam::Kind kind) const;

  std::multimap<slam::Kind, Binding> bindings_;
};

/// A static object of this type beside a binding registers it.
/// @tparam Live with the constructor (context, port) @tparam InBag (context, name of the port)
template <class Data, class Live, class InBag>
struct InputBindingRegistrar {
  InputBindingRegistrar() {
    InputBindings::instance().add(slam::kindOf<Data>(),
                                  {[](const auto& context, const auto& port) {
                                     return std::make_unique<Live>(context, port);
                                   },
                                   [](const auto& context, const auto& port) {
                                     return std::make_unique<InBag>(context, port);
                                   }});
  }
};

}  // namespace slam_ros
