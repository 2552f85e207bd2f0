// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/contract/component.hpp"
#include "slam_core/product/completions.hpp"
#include "slam_core/product/wired_ports.hpp"

namespace slam {

/// Joins the ports of components: data go from who makes them to all who take in data of that name
/// and kind, and so do data that come from outside. An input gate stands once before all components
/// that need it; what an input gate needs may come through another one.
/// Any part of a product is wired in the same way, which is why all compositions give the same
/// result.
class Wiring {
 public:
  explicit Wiring(Completions completions = {}) : completions_(std::move(completions)) {}

  /// Hands over a value of a kind that is known to whoever gets it.
  using Listener = std::function<void(const void*)>;

  /// When a component executes.
  enum class Turn {
    kAtOnce,     ///< with every value that comes in, until it is not busy
    kOnRequest,  ///< when step() is called
  };

  /// @param prefix of its counters @param component outlives this and stays in its place
  /// @param title what sentences call it: "back-end 'ekf'"
  void add(const std::string& prefix, Component& component, Turn turn = Turn::kAtOnce,
           const std::string& title = "component") {
    add(prefix, component, turn, title, portsOf(component));
  }
  /// @param ports the component's, with the names that they have in the product
  void add(const std::string& prefix, Component& component, Turn turn, const std::string& title,
           Ports ports);
  /// Joins what was added, and places the input gates. @throw ConfigError where two components make
  /// the same output, components take data from one another in a circle, or an input gate cannot be
  /// configured
  void connect(Settings& settings);

  /// A value from outside for an input, or for all inputs that take what a component would make.
  void put(const std::string& port, Kind kind, const void* value);
  /// Calls the listener with every value that a component or an input gate makes at this output.
  void listen(const std::string& port, Kind kind, Listener listener);
  /// One execute() of the component that waits for requests, its outputs handed on. @return its
  /// status, or the last warning of those that took their turn at once, where that is more urgent
  Status step();

  const WiredPorts& ports() const { return ports_; }
  /// The counters of all components and input gates, with their prefixes.
  Counters counters() const;
  /// The figures of all components.
  Component::Figures figures() const;
  const std::vector<std::unique_ptr<Gate>>& gates() const { return ports_.gates(); }
  void reset();

  template <class Archive>
  void persist(Archive& archive) {
    archive(status_);
    for (auto& node : nodes_) {
      if constexpr (Archive::kReads)
        node.component->restoreState(archive);
      else
        node.component->saveState(archive);
    }
  }

 private:
  struct Node {
    std::string prefix;
    Component* component;
    const Ports* ports;
    Turn turn;
  };
  struct Consumer {
    Node* node;
    const InputPort* port;
  };
  struct Route {
    std::vector<Consumer> consumers;
    std::vector<Listener> listeners;
  };
  using Address = std::pair<std::string, Kind>;

  void configureGates(Settings& settings);
  void run(Node& node);
  void handOn(Node& node);
  void pass(const Route& route, const void* value);

  std::deque<Node> nodes_;  // a deque: nodes are referred to
  std::map<Address, Route> routes_;
  Completions completions_;
  WiredPorts ports_;
  Status status_;  ///< the last warning of those that took their turn at once
};

/// The title of a component or gate that cannot be resumed ("back-end 'x'"); empty where all can.
std::string notResumable(const Wiring& wiring);

/// Data that wait at gates, with the gates' prefixes.
Counters heldAtGates(const Wiring& wiring);

}  // namespace slam
