// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#ifndef Q_MOC_RUN
#include <rviz/panel.h>
#endif

#include <QElapsedTimer>
#include <QTimer>

#include "product_link.hpp"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rviz {
class DisplayGroup;
}

namespace slam_rviz_plugins {

/// A panel of rviz for a running product: its features, how far its pose can be relied on and why,
/// and its services as buttons. The namespace of the product is kept in rviz's configuration.
class SlamPanel final : public rviz::Panel {
  Q_OBJECT

 public:
  explicit SlamPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void addState(QGridLayout& layout);
  void addButtons(QGridLayout& layout);
  void addFiles(QGridLayout& layout);
  void connectLink();
  void connectTo(const QString& name_space);
  void showTrust(const QString& trust, const QString& doubt);
  void showPose(const geometry_msgs::PoseWithCovarianceStamped& message);
  void showAnswer(bool success, const QString& message);
  void showReplacement();
  void noticeSilence();
  void togglePause();
  void setPaused(bool paused);
  void resetIfConfirmed();

  ProductLink link_;
  QLineEdit* namespace_;
  QLabel *product_, *trust_, *doubt_, *pose_, *event_, *answer_;
  QPushButton *pause_, *relocalise_, *reset_, *save_, *load_;
  QLineEdit* path_;
  QTimer silence_timer_;
  QElapsedTimer since_news_;
  bool is_paused_ = false;
  rviz::DisplayGroup* displays_ = nullptr;  ///< rviz's; null before onInitialize
};

}  // namespace slam_rviz_plugins
