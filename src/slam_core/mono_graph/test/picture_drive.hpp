// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/LU>
#include <cmath>

#include "slam_core/mono_graph/mono_graph.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"

namespace slam::test {

/// A robot in a room of pictures, step by step.
class PictureDrive {
 public:
  using Walls = RoundOfPictures::Walls;

  explicit PictureDrive(std::uint64_t seed, const mono_graph::MonoGraphConfig& config = {},
                        Walls walls = Walls::kDifferent)
      : drive_(seed, walls), inputs_(graph_) {
    graph_.configure(config);
  }

  Status step() {
    truth_ = drive_.give(inputs_);
    return graph_.execute();
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  /// An image of another kind than the camera's; null where none comes.
  Status stepWith(const cv::Mat* gray, bool is_usable = true) {
    const auto motion = drive_.drive();
    inputs_.set(motion);
    if (gray != nullptr) {
      auto view = drive_.room().view(motion.end, drive_.place());
      view.image.gray = *gray;
      if (!is_usable) view.camera = nullptr;
      inputs_.set(view);
    }
    truth_ = truth_ * Pose2::exp({0.06, 0.0, 0.05});
    return graph_.execute();
  }
  double error() const { return (graph_.pose().pose.position() - truth_.position()).norm(); }
  double headingError() const { return std::abs(truth_.between(graph_.pose().pose).theta()); }
  double nees() const {
    const auto pose = graph_.pose();
    Eigen::Vector3d e = pose.pose.vector() - truth_.vector();
    e.z() = Pose2(0, 0, e.z()).theta();
    return e.dot(pose.covariance.inverse() * e);
  }
  bool isLost() { return capabilitiesOf(graph_).find<LostReporter>()->lostSince().has_value(); }

  mono_graph::MonoGraph& graph() { return graph_; }
  RoundOfPictures& round() { return drive_; }
  ComponentDriver& inputs() { return inputs_; }
  void know(const Pose2& truth) { truth_ = truth; }

 private:
  RoundOfPictures drive_;
  mono_graph::MonoGraph graph_;
  ComponentDriver inputs_;
  Pose2 truth_;
};

}  // namespace slam::test
