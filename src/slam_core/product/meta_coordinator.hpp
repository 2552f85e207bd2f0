// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slam_core/product/product_components.hpp"
#include "slam_core/product/wiring.hpp"

namespace slam {

/// A product, or a part of it, in one process (thesis Fig. 4.4): creates the components that the
/// product names and wires them by their ports. Components know nothing of one another.
class MetaCoordinator {
 public:
  /// A fresh start. @throw ConfigError listing the faults of all sections
  void configure(Settings& settings, const ProductPart& part = {});

  /// A value for the input of this name: of a sensor, or what a component would make. Nothing
  /// happens where no component takes it.
  template <class T>
  void put(const std::string& port, const T& value) {
    wiring_.put(port, kindOf<T>(), &value);
  }
  /// The same of data whose kind the caller need not know.
  void put(const std::string& port, Kind kind, const void* value) {
    wiring_.put(port, kind, value);
  }
  /// The same for the input of this kind; nothing happens where there is none.
  /// @throw std::logic_error where inputs of this kind have different names
  template <class T>
  void set(const T& value) {
    if (const auto port = portOf(kindOf<T>()); !port.empty()) put(port, value);
  }
  /// The map is in force at once, as with Estimator::set(). The modules are reset, since poses have
  /// another frame from there on.
  Status set(const MapState& map);
  /// The same with a saved session.
  Status set(const SavedSession& session);
  /// Calls the listener with every value that a component or an input gate makes at this output.
  /// Values from outside, by put(), do not reach it.
  template <class T>
  void listen(const std::string& port, std::function<void(const T&)> listener) {
    wiring_.listen(port, kindOf<T>(), [listener = std::move(listener)](const void* value) {
      listener(*static_cast<const T*>(value));
    });
  }

  /// One step of the estimator, as Estimator::execute(), where the part has one.
  /// @return the more urgent one of its status and of the last warning of the other components
  Status execute() { return wiring_.step(); }

  const ProductComponents& components() const { return parts_; }
  /// Only a part with a back-end has one.
  Estimator& estimator() { return *parts_.estimator; }
  const Estimator& estimator() const { return *parts_.estimator; }
  const Wiring& wiring() const { return wiring_; }

  /// The counters of all components ("odometry_...", "detector_...", "laser_...", "pointmap_...").
  /// Those of the estimator, or of the only component of a part, have no prefix.
  Counters counters() const { return wiring_.counters(); }
  /// Messages that had no effect on the estimate because they came late, were lost or did not fit.
  std::uint64_t dropped() const;
  void reset() { wiring_.reset(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(wiring_);
  }

 private:
  std::string portOf(Kind kind) const;
  Status beginningModules(Status status);

  ProductComponents parts_;
  Wiring wiring_;
};

/// All that a product knows beyond its configuration, so that one that is configured in the same
/// way goes on bit by bit as this one would. All its components can be resumed, see notResumable().
std::string stateOf(const MetaCoordinator& product);
/// @throw std::runtime_error where it is no state of this product, which has to be configured anew
/// then
void restore(const std::string& state, MetaCoordinator& product);
/// To be called after restore() where the robot has gone on without this process, as
/// goOnLive(Estimator&) of which the product may have one.
void goOnLive(MetaCoordinator& product, Interruption interruption);

}  // namespace slam
