// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <slam_msgs/Consistency.h>
#include <slam_msgs/Event.h>

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <functional>

namespace slam_rviz_plugins {

/// The outcome of a service call, a sentence for people.
struct Answer {
  bool success = false;
  QString message;
};

/// A running product as a panel sees it: what it publishes as signals, its services as functions.
/// All signals come in the thread of the object. Services are called in other threads, one after
/// the other, so that a window does not freeze; each ends in answered().
class ProductLink final : public QObject {
  Q_OBJECT

 public:
  explicit ProductLink(QObject* parent = nullptr);

  /// Topics and services are those in this namespace; "" is the global one. One that is no name
  /// ends in answered(), and so does each service from then on: nothing of the one before is
  /// called.
  void connectTo(const QString& name_space);

  void reset();
  void pause(bool paused);
  void relocalise();
  /// @param path below the product's map_folder
  void save(const QString& path);
  void load(const QString& path);

 Q_SIGNALS:
  /// @param trust "confident", "doubtful", "lost" or "unknown" @param doubt why; else empty
  void trustTold(const QString& trust, const QString& doubt);
  void poseTold(const geometry_msgs::PoseWithCovarianceStamped& pose);
  void eventTold(const QString& sentence);
  void productTold(const QString& features);  ///< empty where no product runs
  void answered(bool success, const QString& message);
  void productReplaced();  ///< one has started where another one had ended

 private:
  void disconnectFromProduct();
  void subscribeIn(const QString& name_space);
  void noticeProduct();
  void call(const QString& what, std::function<Answer(ros::NodeHandle&)> service);
  void readProduct();
  void takeConsistency(const slam_msgs::Consistency& message);
  void takeEvent(const slam_msgs::Event& message);

  QString fault_;  ///< of the namespace; empty: it is a name
  ros::NodeHandle handle_;
  ros::Subscriber consistency_, pose_, events_;
  QTimer watch_;
  bool was_there_ = false;  ///< a product, when it was looked for last
  bool has_ended_ = false;  ///< a product, and none has started since
  QThreadPool calls_;       ///< destroyed first, when the last call has ended
};

}  // namespace slam_rviz_plugins
