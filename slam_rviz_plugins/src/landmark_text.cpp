// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "landmark_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slam_rviz_plugins {
namespace {

QString withSigma(const QString& name, double value, const QString& unit, double variance) {
  return QString::fromUtf8("%1 %2 %3, σ %4 %3")
      .arg(name)
      .arg(value, 0, 'f', 3)
      .arg(unit)
      .arg(std::sqrt(variance), 0, 'f', 3);
}

QStringList describePoint(const slam_msgs::Landmark& landmark) {
  const auto& P = landmark.covariance;
  return {QString("landmark %1").arg(landmark.id), withSigma("x", landmark.x, "m", P[0]),
          withSigma("y", landmark.y, "m", P[3])};
}

QStringList describeLine(const slam_msgs::Landmark& landmark) {
  const auto& P = landmark.covariance;
  return {QString("landmark %1, a wall").arg(landmark.id),
          QString::fromUtf8("through x %1 m, y %2 m, σ across it %3 m")
              .arg(landmark.x, 0, 'f', 3)
              .arg(landmark.y, 0, 'f', 3)
              .arg(std::sqrt(P[0]), 0, 'f', 3),
          withSigma("its perpendicular points to", landmark.direction, "rad", P[3]),
          QString("%1 m of it were seen").arg(landmark.end - landmark.begin, 0, 'f', 2)};
}

QString describeLooks(const slam_msgs::Landmark& landmark) {
  QStringList parts;
  for (std::size_t i = 0; i < landmark.descriptor.size(); ++i) {
    auto part = QString::number(landmark.descriptor[i], 'g', 3);
    if (i < landmark.descriptor_sigma.size())
      part += QString::fromUtf8(" (σ %1)").arg(landmark.descriptor_sigma[i], 0, 'g', 2);
    parts << part;
  }
  return "descriptor " + parts.join(", ");
}

}  // namespace

QStringList describe(const slam_msgs::Landmark& landmark, const QString& label) {
  const bool is_line = landmark.kind == slam_msgs::Landmark::LINE;
  auto lines = is_line ? describeLine(landmark) : describePoint(landmark);
  if (!label.isEmpty()) lines.front() += ": " + label;
  if (!landmark.descriptor.empty()) lines << describeLooks(landmark);
  return lines;
}

QString labelOf(const slam_msgs::Landmark& landmark, const slam_msgs::LandmarkLabels& labels) {
  const auto count = std::min(labels.ids.size(), labels.labels.size());
  for (std::size_t i = 0; i < count; ++i)
    if (labels.ids[i] == landmark.id) return QString::fromStdString(labels.labels[i]);
  return "";
}

}  // namespace slam_rviz_plugins
