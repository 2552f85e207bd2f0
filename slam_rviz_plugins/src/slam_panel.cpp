// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_panel.hpp"

#include <rviz/display_group.h>
#include <rviz/visualization_manager.h>

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>

namespace slam_rviz_plugins {
namespace {

constexpr qint64 kSilence = 5000;  // [ms]
constexpr int kColumns = 3;

/// A label that breaks long sentences; tests and style sheets find it by its name.
QLabel* makeLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// A label without a text takes no room, which is scarce in a dock.
void write(QLabel& label, const QString& text) {
  label.setText(text);
  label.setVisible(!text.isEmpty());
}

QPushButton* makeButton(const char* name, const char* text, const char* help) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(help);
  return button;
}

QString colourOf(const QString& trust) {
  if (trust == "confident") return "#2e7d32";
  if (trust == "doubtful") return "#b26a00";
  if (trust == "lost") return "#b71c1c";
  return "#757575";  // unknown, and where nothing runs
}

void paint(QLabel& label, const QString& trust, const QString& text) {
  label.setText(text);
  label.setStyleSheet(QString("background: %1; color: white; font-weight: bold; padding: 6px;")
                          .arg(colourOf(trust)));
}

/// The standard deviations of a pose. Zeros are no covariance, as in sensor_msgs.
QString uncertaintyOf(const geometry_msgs::PoseWithCovariance& pose) {
  const auto& P = pose.covariance;
  if (std::all_of(P.begin(), P.end(), [](double value) { return value == 0.0; }))
    return QString::fromUtf8("σ unknown");
  return QString::fromUtf8("σ %1 m, %2 rad")
      .arg(std::sqrt(std::max(P[0], P[7])), 0, 'f', 3)
      .arg(std::sqrt(P[35]), 0, 'f', 3);
}

double headingOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace

SlamPanel::SlamPanel(QWidget* parent) : rviz::Panel(parent) {
  auto* layout = new QGridLayout(this);
  addState(*layout);
  addButtons(*layout);
  addFiles(*layout);
  answer_ = makeLabel("answer");
  layout->addWidget(answer_, layout->rowCount(), 0, 1, kColumns);
  layout->setRowStretch(layout->rowCount(), 1);
  connectLink();
  since_news_.start();
  noticeSilence();
  connect(&silence_timer_, &QTimer::timeout, this, &SlamPanel::noticeSilence);
  silence_timer_.start(1000);
}

void SlamPanel::onInitialize() { displays_ = vis_manager_->getRootDisplayGroup(); }

void SlamPanel::addState(QGridLayout& layout) {
  namespace_ = new QLineEdit;
  namespace_->setObjectName("namespace");
  namespace_->setPlaceholderText("none");
  namespace_->setToolTip("of the product, where several run on one master");
  layout.addWidget(new QLabel("Namespace"), 0, 0);
  layout.addWidget(namespace_, 0, 1, 1, kColumns - 1);
  for (auto [member, name] :
       {std::pair(&product_, "product"), std::pair(&trust_, "trust"), std::pair(&doubt_, "doubt"),
        std::pair(&pose_, "pose"), std::pair(&event_, "event")}) {
    *member = makeLabel(name);
    layout.addWidget(*member, layout.rowCount(), 0, 1, kColumns);
  }
  trust_->setAlignment(Qt::AlignCenter);
  trust_->setMinimumHeight(2 * trust_->fontMetrics().height());
}

void SlamPanel::addButtons(QGridLayout& layout) {
  const int row = layout.rowCount();
  pause_ = makeButton("pause", "Pause", "ignores observations; motion is still applied");
  relocalise_ = makeButton("relocalise", "Relocalise", "looks for the robot in the whole map");
  reset_ = makeButton("reset", "Reset ...", "forgets the map and the pose");
  layout.addWidget(pause_, row, 0);
  layout.addWidget(relocalise_, row, 1);
  layout.addWidget(reset_, row, 2);
}

void SlamPanel::addFiles(QGridLayout& layout) {
  const int row = layout.rowCount();
  path_ = new QLineEdit("map");
  path_->setObjectName("path");
  path_->setToolTip("file or folder of the map, below the product's map_folder");
  save_ = makeButton("save", "Save map", "writes the map to this file");
  load_ = makeButton("load", "Load map", "replaces the map by that of this file");
  layout.addWidget(path_, row, 0);
  layout.addWidget(save_, row, 1);
  layout.addWidget(load_, row, 2);
}

void SlamPanel::connectLink() {
  connect(&link_, &ProductLink::trustTold, this, &SlamPanel::showTrust);
  connect(&link_, &ProductLink::poseTold, this, &SlamPanel::showPose);
  connect(&link_, &ProductLink::eventTold, event_,
          [this](const QString& sentence) { write(*event_, sentence); });
  connect(&link_, &ProductLink::answered, this, &SlamPanel::showAnswer);
  connect(&link_, &ProductLink::productReplaced, this, &SlamPanel::showReplacement);
  connect(&link_, &ProductLink::productTold, product_, [this](const QString& features) {
    product_->setText(features.isEmpty() ? "no product is running" : features);
  });
  connect(namespace_, &QLineEdit::editingFinished, this, [this] {
    connectTo(namespace_->text());
    Q_EMIT configChanged();
  });
  connect(pause_, &QPushButton::clicked, this, &SlamPanel::togglePause);
  connect(relocalise_, &QPushButton::clicked, &link_, &ProductLink::relocalise);
  connect(reset_, &QPushButton::clicked, this, &SlamPanel::resetIfConfirmed);
  connect(save_, &QPushButton::clicked, &link_, [this] { link_.save(path_->text()); });
  connect(load_, &QPushButton::clicked, &link_, [this] { link_.load(path_->text()); });
}

void SlamPanel::connectTo(const QString& name_space) {
  for (auto* label : {doubt_, pose_, event_, answer_}) write(*label, "");
  since_news_.start();
  paint(*trust_, "", "waiting for the first step");
  link_.connectTo(name_space);
}

void SlamPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString name_space, path;
  if (config.mapGetString("Namespace", &name_space)) namespace_->setText(name_space);
  if (config.mapGetString("Map", &path)) path_->setText(path);
  connectTo(namespace_->text());
}

void SlamPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Namespace", namespace_->text());
  config.mapSetValue("Map", path_->text());
}

void SlamPanel::showTrust(const QString& trust, const QString& doubt) {
  since_news_.start();
  paint(*trust_, trust, trust);
  write(*doubt_, doubt);
}

void SlamPanel::showPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto& pose = message.pose.pose;
  write(*pose_, QString("x %1 m, y %2 m, heading %3 rad\n%4")
                    .arg(pose.position.x, 0, 'f', 2)
                    .arg(pose.position.y, 0, 'f', 2)
                    .arg(headingOf(pose.orientation), 0, 'f', 2)
                    .arg(uncertaintyOf(message.pose)));
}

void SlamPanel::showAnswer(bool success, const QString& message) {
  write(*answer_, message);
  answer_->setStyleSheet(success ? "" : "color: #b71c1c;");
}

/// What was shown last says nothing of a product that has stopped.
void SlamPanel::noticeSilence() {
  if (since_news_.elapsed() < kSilence && !trust_->text().isEmpty()) return;
  paint(*trust_, "", "no step: no product runs here, or its sensors send nothing");
  write(*doubt_, "");
}

/// Clears what the product before has drawn, which does not belong to this one's map.
void SlamPanel::showReplacement() {
  write(*event_, "");
  setPaused(false);
  if (displays_ != nullptr) displays_->reset();
}

void SlamPanel::togglePause() {
  setPaused(!is_paused_);
  link_.pause(is_paused_);
}

void SlamPanel::setPaused(bool paused) {
  is_paused_ = paused;
  pause_->setText(paused ? "Go on" : "Pause");
}

void SlamPanel::resetIfConfirmed() {
  const auto choice = QMessageBox::question(this, "Reset", "Forget the map and the pose?");
  if (choice == QMessageBox::Yes) link_.reset();
}

}  // namespace slam_rviz_plugins

PLUGINLIB_EXPORT_CLASS(slam_rviz_plugins::SlamPanel, rviz::Panel)
