// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <string>

namespace slam {

/// What a landmark looks like beside its place: the signature s of an observation (r, phi, s)
/// (Thrun, Burgard, Fox 2005, ch. 6.6.1), a few numbers whose meaning and units the detector
/// defines, such as the radius of a trunk [m]. Their errors are independent of one another and of
/// the robot's pose. Empty where there is none.
struct Descriptor {
  static constexpr int kMostElements = 8;
  /// There is room for one element more, so that a descriptor that is too long shows.
  using Vector = Eigen::Matrix<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMostElements + 1, 1>;

  Vector values;
  Vector sigmas;  ///< standard deviation of each

  bool isEmpty() const { return values.size() == 0 && sigmas.size() == 0; }
  Eigen::Index size() const { return values.size(); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(values, sigmas);
  }
};

/// A descriptor of one number.
inline Descriptor descriptorOf(double value, double sigma) {
  return {Descriptor::Vector::Constant(1, static_cast<float>(value)),
          Descriptor::Vector::Constant(1, static_cast<float>(sigma))};
}

/// Empty, or what makes the descriptor unusable, to stand behind whose it is (" has a descriptor
/// that holds a value that is not a number").
std::string faultOf(const Descriptor& descriptor);

}  // namespace slam
