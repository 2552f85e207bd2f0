// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "landmark_tool.hpp"

#include <OgreCamera.h>
#include <OgreQuaternion.h>
#include <OgreVector.h>
#include <OgreViewport.h>
#include <ros/exception.h>
#include <ros/message_traits.h>
#include <ros/names.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/geometry.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>

#include <QToolTip>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "landmark_text.hpp"

namespace slam_rviz_plugins {
namespace {

constexpr double kReach = 12.0;  // [px]
constexpr const char* kLabels = "landmark_labels";

/// A point of a landmark in its map's frame. @param along a wall, from (x, y) [m]
Ogre::Vector3 pointOf(const slam_msgs::Landmark& landmark, double along) {
  return {static_cast<float>(landmark.x - along * std::sin(landmark.direction)),
          static_cast<float>(landmark.y + along * std::cos(landmark.direction)), 0.0F};
}

bool isInFront(const Ogre::Camera& camera, const Ogre::Vector3& point) {
  return camera.getDerivedDirection().dotProduct(point - camera.getDerivedPosition()) > 0.0F;
}

QPointF toPixels(const Ogre::Viewport& viewport, const Ogre::Vector3& point) {
  const auto pixel = rviz::project3DPointToViewportXY(&viewport, point);
  return {pixel.x, pixel.y};
}

}  // namespace

LandmarkTool::LandmarkTool()
    : topic_(new rviz::RosTopicProperty(
          "Topic", "landmarks",
          QString::fromStdString(ros::message_traits::datatype<slam_msgs::LandmarkMap>()),
          "landmarks of a product", getPropertyContainer(), SLOT(subscribe()), this)) {
  shortcut_key_ = 'l';
}

void LandmarkTool::onInitialize() { setName("Landmark"); }

void LandmarkTool::activate() {
  is_active_ = true;
  setStatus("Point at a landmark. Buttons and wheel move the view.");
  subscribe();
}

void LandmarkTool::deactivate() {
  is_active_ = false;
  QToolTip::hideText();
  subscriber_.shutdown();
  labels_subscriber_.shutdown();
  map_.reset();
  labels_ = {};
}

/// An exception must not go through Qt's event loop: it would end rviz.
void LandmarkTool::subscribe() {
  if (!is_active_) return;
  map_.reset();
  labels_ = {};
  subscriber_.shutdown();
  labels_subscriber_.shutdown();
  fault_.clear();
  try {
    subscriber_ = handle_.subscribe<slam_msgs::LandmarkMap>(
        topic_->getTopicStd(), 1,
        [this](const slam_msgs::LandmarkMapConstPtr& message) { map_ = message; });
    labels_subscriber_ = handle_.subscribe<slam_msgs::LandmarkLabels>(
        ros::names::append(ros::names::parentNamespace(subscriber_.getTopic()), kLabels), 1,
        [this](const slam_msgs::LandmarkLabelsConstPtr& message) { labels_ = *message; });
  } catch (const ros::Exception& exception) {
    fault_ = QString("the landmark tool's Topic cannot be used: %1").arg(exception.what());
    setStatus(fault_);
  }
}

int LandmarkTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  // The view comes first: it writes into the status line as well.
  if (auto* controller = event.panel->getViewController()) controller->handleMouseEvent(event);
  if (subscriber_.getNumPublishers() == 0) map_.reset();  // the product has ended
  if (labels_subscriber_.getNumPublishers() == 0) labels_ = {};
  if (event.type == QEvent::MouseMove && event.buttons_down == Qt::NoButton)
    show(event);
  else
    QToolTip::hideText();
  return 0;
}

void LandmarkTool::show(rviz::ViewportMouseEvent& event) {
  const QPoint mouse(event.x, event.y);
  const auto nearest = nearestTo(mouse, placesIn(*event.viewport), kReach);
  if (!nearest) {
    QToolTip::hideText();
    if (!map_) setStatus(sentenceWithoutMap());
    return;
  }
  const auto& landmark = map_->landmarks[*nearest];
  const auto lines = describe(landmark, labelOf(landmark, labels_));
  QToolTip::showText(event.panel->mapToGlobal(mouse), lines.join("\n"), event.panel);
  setStatus(lines.join("; "));
}

std::vector<LandmarkPlace> LandmarkTool::placesIn(const Ogre::Viewport& viewport) const {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!map_ || !context_->getFrameManager()->getTransform(map_->header.frame_id, ros::Time(),
                                                          position, orientation))
    return {};
  std::vector<LandmarkPlace> places;
  for (std::size_t i = 0; i < map_->landmarks.size(); ++i) {
    const auto& landmark = map_->landmarks[i];
    const auto begin = position + orientation * pointOf(landmark, landmark.begin);
    const auto end = position + orientation * pointOf(landmark, landmark.end);
    if (isInFront(*viewport.getCamera(), begin) && isInFront(*viewport.getCamera(), end))
      places.push_back({i, {toPixels(viewport, begin), toPixels(viewport, end)}});
  }
  return places;
}

QString LandmarkTool::sentenceWithoutMap() const {
  if (!fault_.isEmpty()) return fault_;
  return QString("no landmarks on %1: is a product running that has them?")
      .arg(QString::fromStdString(subscriber_.getTopic()));
}

}  // namespace slam_rviz_plugins

PLUGINLIB_EXPORT_CLASS(slam_rviz_plugins::LandmarkTool, rviz::Tool)
