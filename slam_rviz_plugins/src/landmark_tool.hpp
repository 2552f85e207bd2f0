// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <slam_msgs/LandmarkLabels.h>
#include <slam_msgs/LandmarkMap.h>

#include <QString>
#include <vector>

#ifndef Q_MOC_RUN
#include <rviz/tool.h>
#endif

#include "landmark_places.hpp"

namespace Ogre {
class Viewport;
}

namespace rviz {
class RosTopicProperty;
}

namespace slam_rviz_plugins {

/// A tool of rviz: what is known of the landmark under the mouse stands beside it and in the status
/// line. With a button pressed the mouse moves the view, as with rviz's own "Move Camera".
/// Landmarks, and their labels in the same namespace, are subscribed to only while the tool is
/// chosen.
class LandmarkTool final : public rviz::Tool {
  Q_OBJECT

 public:
  LandmarkTool();

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

 private Q_SLOTS:
  /// Does nothing while the tool is not chosen. rviz calls it whenever the property changes.
  void subscribe();

 private:
  void show(rviz::ViewportMouseEvent& event);
  /// The places in the window of the landmarks in front of the camera. It is empty where the
  /// landmarks' frame is not known.
  std::vector<LandmarkPlace> placesIn(const Ogre::Viewport& viewport) const;
  QString sentenceWithoutMap() const;

  ros::NodeHandle handle_;
  ros::Subscriber subscriber_, labels_subscriber_;
  bool is_active_ = false;              ///< the tool is chosen
  QString fault_;                       ///< of the topic; empty: none
  slam_msgs::LandmarkMapConstPtr map_;  ///< the last one that came; null: none
  slam_msgs::LandmarkLabels labels_;    ///< the last ones that came
  rviz::RosTopicProperty* topic_;       ///< owned by the tool's property container
};

}  // namespace slam_rviz_plugins
