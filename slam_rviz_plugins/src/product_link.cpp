// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "product_link.hpp"

#include <ros/exception.h>
#include <slam_msgs/LoadMap.h>
#include <slam_msgs/SaveMap.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QStringList>
#include <string>
#include <utility>

namespace slam_rviz_plugins {
namespace {

constexpr int kWatchInterval = 200;  // [ms]

/// Calls a service whose answer is a success and a message.
template <class Service>
Answer callFor(ros::NodeHandle& handle, const std::string& name, Service service) {
  auto client = handle.serviceClient<Service>(name);
  if (!client.exists())
    return {false, QString("no product offers %1: is one running in this namespace?")
                       .arg(QString::fromStdString(handle.resolveName(name)))};
  if (!client.call(service)) return {false, "it gave no answer"};
  return {service.response.success != 0, QString::fromStdString(service.response.message)};
}

Answer callForPlace(ros::NodeHandle& handle) {
  const std::string name = "global_localization";
  auto client = handle.serviceClient<std_srvs::Empty>(name);
  std_srvs::Empty service;
  if (!client.exists()) return {false, "no product is running that offers it"};
  if (!client.call(service))
    return {false, "the map cannot be searched; the product's log says why"};
  return {true, "the robot is looked for in the whole map"};
}

QString featuresOf(ros::NodeHandle& handle) {
  QStringList features;
  for (const auto* key : {"backend", "odometry", "detector", "map"}) {
    std::string value;
    if (handle.getParam(std::string("product/") + key, value))
      features << QString::fromStdString(value);
  }
  return features.join(QString::fromUtf8(" · "));
}

}  // namespace

ProductLink::ProductLink(QObject* parent) : QObject(parent) {
  calls_.setMaxThreadCount(1);
  connectTo("");
  connect(&watch_, &QTimer::timeout, this, &ProductLink::noticeProduct);
  watch_.start(kWatchInterval);
}

/// An exception must not go through Qt's event loop: it would end rviz.
void ProductLink::connectTo(const QString& name_space) {
  disconnectFromProduct();
  try {
    subscribeIn(name_space);
    readProduct();
  } catch (const ros::Exception& exception) {
    disconnectFromProduct();
    fault_ = QString("this namespace cannot be used: %1").arg(exception.what());
    Q_EMIT productTold("");
    Q_EMIT answered(false, fault_);
  }
}

void ProductLink::disconnectFromProduct() {
  for (auto* subscriber : {&consistency_, &events_, &pose_}) subscriber->shutdown();
  was_there_ = has_ended_ = false;
  fault_.clear();
}

void ProductLink::subscribeIn(const QString& name_space) {
  handle_ = ros::NodeHandle(name_space.toStdString());
  consistency_ = handle_.subscribe("consistency", 1, &ProductLink::takeConsistency, this);
  events_ = handle_.subscribe("events", 10, &ProductLink::takeEvent, this);
  pose_ = handle_.subscribe<geometry_msgs::PoseWithCovarianceStamped>(
      "pose", 1, [this](const geometry_msgs::PoseWithCovarianceStampedConstPtr& message) {
        Q_EMIT poseTold(*message);
      });
}

void ProductLink::noticeProduct() {
  const bool is_there = consistency_.getNumPublishers() > 0;
  if (is_there && !was_there_) readProduct();
  if (is_there && has_ended_) Q_EMIT productReplaced();
  has_ended_ = !is_there && (has_ended_ || was_there_);
  was_there_ = is_there;
}

void ProductLink::call(const QString& what, std::function<Answer(ros::NodeHandle&)> service) {
  if (!fault_.isEmpty()) {
    Q_EMIT answered(false, what + ": " + fault_);
    return;
  }
  calls_.start([this, what, handle = handle_, service = std::move(service)]() mutable {
    const auto answer = service(handle);
    const auto sentence = what + ": " + answer.message;
    QMetaObject::invokeMethod(
        this, [this, success = answer.success, sentence] { Q_EMIT answered(success, sentence); },
        Qt::QueuedConnection);
  });
}

/// The master answers in its own time.
void ProductLink::readProduct() {
  calls_.start([this, handle = handle_]() mutable {
    const auto features = featuresOf(handle);
    QMetaObject::invokeMethod(
        this, [this, features] { Q_EMIT productTold(fault_.isEmpty() ? features : ""); },
        Qt::QueuedConnection);
  });
}

void ProductLink::reset() {
  call("Reset",
       [](ros::NodeHandle& handle) { return callFor(handle, "reset", std_srvs::Trigger()); });
}

void ProductLink::pause(bool paused) {
  call(paused ? "Pause" : "Go on", [paused](ros::NodeHandle& handle) {
    std_srvs::SetBool service;
    service.request.data = paused;
    return callFor(handle, "pause", service);
  });
}

void ProductLink::relocalise() { call("Relocalise", callForPlace); }

void ProductLink::save(const QString& path) {
  call("Save", [path](ros::NodeHandle& handle) {
    slam_msgs::SaveMap service;
    service.request.path = path.toStdString();
    return callFor(handle, "save_map", service);
  });
}

void ProductLink::load(const QString& path) {
  call("Load", [path](ros::NodeHandle& handle) {
    slam_msgs::LoadMap service;
    service.request.path = path.toStdString();
    return callFor(handle, "load_map", service);
  });
}

void ProductLink::takeConsistency(const slam_msgs::Consistency& message) {
  Q_EMIT trustTold(QString::fromStdString(message.trust), QString::fromStdString(message.doubt));
}

void ProductLink::takeEvent(const slam_msgs::Event& message) {
  readProduct();
  Q_EMIT eventTold(QString("%1 at %2 s: %3")
                       .arg(QString::fromStdString(message.kind))
                       .arg(message.header.stamp.toSec(), 0, 'f', 1)
                       .arg(QString::fromStdString(message.reason)));
}

}  // namespace slam_rviz_plugins
