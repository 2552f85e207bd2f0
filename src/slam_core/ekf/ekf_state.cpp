// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_state.hpp"

#include <algorithm>
#include <numeric>

#include "slam_core/ekf/index.hpp"

namespace slam::ekf {
namespace {

constexpr Eigen::Index kPoseSize = 3;
constexpr Eigen::Index kParameterPairs = kCalibrationRows / 2;
static_assert(kCalibrationRows % 2 == 0);

/// The covariance of (pose, landmarks).
Eigen::MatrixXd jointOf(const MapState& map, double inflation) {
  if (map.joint_covariance.size() > 0) return map.joint_covariance;
  const auto size = kPoseSize + 2 * static_cast<Eigen::Index>(map.landmarks.size());
  Eigen::MatrixXd joint = Eigen::MatrixXd::Zero(size, size);
  joint.topLeftCorner<kPoseSize, kPoseSize>() = map.robot.covariance;
  for (std::size_t i = 0; i < map.landmarks.size(); ++i) {
    const auto row = kPoseSize + 2 * static_cast<Eigen::Index>(i);
    joint.block<2, 2>(row, row) = inflation * inflation * map.landmarks[i].covariance;
  }
  return joint;
}

Neighbourhood neighbourhoodOf(const MapState& map, double inflation) {
  if (map.joint_covariance.size() > 0) return Neighbourhood(map.joint_covariance);
  std::vector<Eigen::Matrix2d> marginals;
  for (const auto& landmark : map.landmarks)
    marginals.push_back(inflation * inflation * landmark.covariance);
  return {map.robot.covariance, marginals};
}

/// Of (pose, parameters, landmarks): the parameters do not depend on the others.
Neighbourhood neighbourhoodOf(const MapState& map, double inflation,
                              const CalibrationEstimate& calibration) {
  const auto joint = jointOf(map, inflation);
  const Eigen::Index landmarks = joint.rows() - kPoseSize, size = joint.rows() + kCalibrationRows;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  all.topLeftCorner<kPoseSize, kPoseSize>() = joint.topLeftCorner<kPoseSize, kPoseSize>();
  all.block<kCalibrationRows, kCalibrationRows>(kPoseSize, kPoseSize) = calibration.covariance;
  all.topRightCorner(kPoseSize, landmarks) = joint.topRightCorner(kPoseSize, landmarks);
  all.bottomLeftCorner(landmarks, kPoseSize) = joint.bottomLeftCorner(landmarks, kPoseSize);
  all.bottomRightCorner(landmarks, landmarks) = joint.bottomRightCorner(landmarks, landmarks);
  return Neighbourhood(all);
}

}  // namespace

EkfState::EkfState(FilterVariant variant, StretchLimits limits, const PoseEstimate& robot,
                   const std::optional<CalibrationEstimate>& calibration)
    : variant_(std::move(variant)),
      limits_(limits),
      robot_(robot.pose),
      neighbourhood_(calibration ? neighbourhoodOf({robot, {}, {}}, 1.0, *calibration)
                                 : Neighbourhood(Eigen::MatrixXd(robot.covariance))) {
  add(calibration);
  takeAlways();
}

EkfState::EkfState(FilterVariant variant, StretchLimits limits, const MapState& map,
                   double inflation, const std::optional<CalibrationEstimate>& calibration)
    : variant_(std::move(variant)),
      limits_(limits),
      robot_(map.robot.pose),
      neighbourhood_(calibration ? neighbourhoodOf(map, inflation, *calibration)
                                 : neighbourhoodOf(map, inflation)) {
  add(calibration);
  for (const auto& landmark : map.landmarks) {
    index_[landmark.id] = static_cast<Eigen::Index>(ids_.size());
    ids_.push_back(landmark.id);
    largest_id_ = std::max(largest_id_, landmark.id);
    const auto& m = landmark;
    starts_.push_back(m.isLine() ? Eigen::Vector2d(0.0, m.direction) : m.position);
    lines_.emplace_back();
    if (m.isLine()) lines_.back() = MappedLine{LineModel(m.position), m.extent};
  }
  firsts_ = starts_;
  born_.assign(ids_.size(), 0.0);
  is_seen_.assign(ids_.size(), false);
  takeAlways();
}

/// The parameters come before all landmarks.
void EkfState::add(const std::optional<CalibrationEstimate>& calibration) {
  if (!calibration) return;
  parameter_pairs_ = kParameterPairs;
  for (Eigen::Index pair = 0; pair < parameter_pairs_; ++pair) {
    ids_.push_back(kUnknownId);
    starts_.emplace_back(calibration->parameters.segment<2>(2 * pair));
    lines_.emplace_back();
  }
  firsts_ = starts_;
  born_.assign(ids_.size(), 0.0);
  is_seen_.assign(ids_.size(), false);
}

std::optional<std::size_t> EkfState::find(LandmarkId id) const {
  const auto found = index_.find(id);
  if (found == index_.end()) return std::nullopt;
  return static_cast<std::size_t>(found->second);
}

LandmarkPoint EkfState::point(Eigen::Index landmark, const Eigen::Vector2d& correction, double turn,
                              double born) const {
  const auto &start = starts_[at(landmark)], &first = firsts_[at(landmark)];
  if (isParameter(landmark)) return {start + correction, start, first};
  if (const auto& line = lines_[at(landmark)])
    return {linearization().moved(line->model, start, correction, turn - born), start, first,
            &line->model};
  return {linearization().moved(start, correction, turn - born), start, first};
}

LandmarkPoint EkfState::point(Eigen::Index slot, const Eigen::Vector2d& correction,
                              double turn) const {
  const auto landmark = neighbourhood_.taken()[at(slot)];
  const Eigen::Vector2d before = neighbourhood_.correction().segment<2>(DenseCovariance::row(slot));
  return point(landmark, before + correction, this->turn() + turn, born_[at(landmark)]);
}

std::vector<LandmarkPoint> EkfState::allPoints() const {
  const auto corrections = neighbourhood_.allCorrections();
  std::vector<LandmarkPoint> points;
  points.reserve(ids_.size());
  for (Eigen::Index i = 0; i < corrections.cols(); ++i)
    points.push_back(point(i, corrections.col(i), turn(), born_[at(i)]));
  return points;
}

Eigen::Matrix2Xd EkfState::transports(const std::vector<LandmarkPoint>& points) const {
  Eigen::Matrix2Xd c(2, static_cast<Eigen::Index>(points.size()));
  c.leftCols(parameter_pairs_).setZero();
  for (Eigen::Index i = parameter_pairs_; i < c.cols(); ++i)
    c.col(i) = linearization().landmarkTransport(points[at(i)]);
  return c;
}

void EkfState::renew() {
  const auto points = allPoints();
  neighbourhood_.renew(transports(points));
  for (std::size_t i = 0; i < points.size(); ++i) starts_[i] = points[i].now;
  std::fill(born_.begin(), born_.end(), 0.0);
  std::fill(is_seen_.begin(), is_seen_.end(), false);
  seen_ = 0;
  takeAlways();
}

void EkfState::takeAlways() {
  const Eigen::Index count = limits_.whole_map ? neighbourhood_.landmarks() : parameter_pairs_;
  for (Eigen::Index i = 0; i < count; ++i) neighbourhood_.take(i);
}

void EkfState::take(const LandmarksInView& view) {
  Eigen::Index more = view.others;  // than were seen in this interval
  for (const auto landmark : view.landmarks) more += is_seen_[at(landmark)] ? 0 : 1;
  // The limit grows with the number of observations in view, so that an interval lasts for more
  // than one step.
  const auto limit = std::max(limits_.landmarks, 2 * view.observations);
  const bool is_full = seen_ > 0 && more > 0 && seen_ + more > limit;
  if (is_full ||
      linearization().isStale(turn(), relativeHeadingVariance(neighbourhood_.covariance()))) {
    renew();
    take(view);
    return;
  }
  for (const auto landmark : view.landmarks) {
    if (is_seen_[at(landmark)]) continue;
    if (neighbourhood_.slot(landmark) < 0) neighbourhood_.take(landmark);
    is_seen_[at(landmark)] = true;
    ++seen_;
  }
}

void EkfState::renewReference() {
  if (neighbourhood_.isFresh()) return;
  const auto taken = neighbourhood_.taken();
  const auto is_seen = is_seen_;
  const auto seen = seen_;
  renew();
  for (const auto landmark : taken)
    if (neighbourhood_.slot(landmark) < 0) neighbourhood_.take(landmark);
  is_seen_ = is_seen;
  seen_ = seen;
}

PosePrediction EkfState::predict(const Pose2& increment, const Eigen::Matrix3d& Q,
                                 const CalibrationJacobian<3>& J_increment) {
  const auto moved = variant_.transform->predict(linearization(), pose(), increment, Q);
  robot_ = moved.robot;
  neighbourhood_.predict(moved.error.F, moved.error.Q, moved.G * J_increment);
  return moved.error;
}

Innovation EkfState::innovation(const ObservedLandmark& observed,
                                const ObservedCovariance& P) const {
  const auto& [model, robot, sensor, landmark, z] = observed;
  auto innovation = linearization().innovation(model, robot, robot_, sensor, landmark, z);
  variant_.transform->observe(observed, P, innovation);
  return innovation;
}

void EkfState::correctRobot(const Eigen::Vector3d& dx) {
  const Pose2 before = robot_;
  robot_ = linearization().moved(before, dx);
  const auto c = linearization().robotTransport(before, robot_);
  if (!c.isZero(0.0)) neighbourhood_.transportRobot(c);
}

void EkfState::update(const Eigen::VectorXd& dx, const Eigen::MatrixXd& W) {
  neighbourhood_.update(W, dx);
  correctRobot(dx.head<3>());
}

void EkfState::updateRobot(const Eigen::VectorXd& dx, const Eigen::MatrixXd& W) {
  neighbourhood_.updateRobot(W);
  correctRobot(dx.head<3>());
}

void EkfState::extend(Eigen::Index slot, const Pose2& sensor, const LandmarkObservation& z) {
  auto& line = lines_[at(neighbourhood_.taken()[at(slot)])];
  if (line)
    line->extent = united(line->extent, line->model.extentOf(robot_ * sensor, z, point(slot).now));
}

void EkfState::append(LandmarkId id, const NewLandmark& m) {
  neighbourhood_.append(m.J_robot, m.R);
  index_[id] = static_cast<Eigen::Index>(ids_.size());
  ids_.push_back(id);
  largest_id_ = std::max(largest_id_, id);
  starts_.push_back(m.m_map);
  firsts_.push_back(m.m_map);
  lines_.push_back(m.line);
  born_.push_back(turn());
  is_seen_.push_back(true);
  ++seen_;
}

void EkfState::beginAnew(LandmarkId id, const NewLandmark& m) {
  const auto landmark = index_.at(id);
  renew();
  neighbourhood_.replace(landmark, m.J_robot, m.R);
  starts_[at(landmark)] = firsts_[at(landmark)] = m.m_map;
  lines_[at(landmark)] = m.line;
  takeAlways();
}

void EkfState::relocate(const PoseEstimate& robot) {
  renew();
  robot_ = robot.pose;
  neighbourhood_.resetRobot(robot.covariance);
  takeAlways();
}

std::optional<CalibrationVector> EkfState::parameters() const {
  if (parameter_pairs_ == 0) return std::nullopt;
  CalibrationVector parameters;
  for (Eigen::Index pair = 0; pair < parameter_pairs_; ++pair)
    parameters.segment<2>(2 * pair) = point(pair).now;
  return parameters;
}

SensorFrame::Joint EkfState::robotAndParameters() const {
  SensorFrame::Joint joint;
  joint.robot = robot_;
  joint.c = *parameters();
  const auto row = [](Eigen::Index i) {
    return i < kPoseSize ? i : DenseCovariance::kParameterRow + i - kPoseSize;
  };
  for (Eigen::Index i = 0; i < joint.covariance.rows(); ++i)
    for (Eigen::Index j = 0; j < joint.covariance.cols(); ++j)
      joint.covariance(i, j) = covariance()(row(i), row(j));
  return joint;
}

std::optional<CalibrationEstimate> EkfState::calibration() const {
  if (parameter_pairs_ == 0) return std::nullopt;
  const auto joint = robotAndParameters();
  return CalibrationEstimate{
      joint.c, joint.covariance.bottomRightCorner<kCalibrationRows, kCalibrationRows>()};
}

void EkfState::retire(LandmarkId id) { index_.erase(id); }

std::vector<association::LandmarkPlace> EkfState::places() const {
  const auto points = allPoints();
  std::vector<association::LandmarkPlace> places;
  for (const auto i : orderById())
    if (!lines_[at(i)]) places.push_back({ids_[at(i)], points[at(i)].now});
  return places;
}

/// The numbers of all that are in the map.
std::vector<Eigen::Index> EkfState::orderById() const {
  std::vector<Eigen::Index> order(ids_.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto is_retired = [this](Eigen::Index i) { return find(ids_[at(i)]) != at(i); };
  if (index_.size() < ids_.size())
    order.erase(std::remove_if(order.begin(), order.end(), is_retired), order.end());
  std::sort(order.begin(), order.end(),
            [this](Eigen::Index a, Eigen::Index b) { return ids_[at(a)] < ids_[at(b)]; });
  return order;
}

Landmark EkfState::landmark(Eigen::Index landmark, const LandmarkPoint& point) const {
  const auto id = ids_[at(landmark)];
  if (const auto& line = lines_[at(landmark)])
    return line->model.landmarkOf(id, point.now, line->extent);
  return {id, point.now, Eigen::Matrix2d::Zero()};
}

/// @param covariance_of a landmark by its number
template <class CovarianceOf>
LandmarkMap EkfState::mapOf(const std::vector<LandmarkPoint>& points,
                            const CovarianceOf& covariance_of) const {
  LandmarkMap map;
  map.reserve(ids_.size());
  for (const auto i : orderById()) {
    map.push_back(landmark(i, points[at(i)]));
    map.back().covariance = covariance_of(i);
  }
  return map;
}

LandmarkMap EkfState::map() const {
  const auto points = allPoints();
  const auto marginals = neighbourhood_.marginals(transports(points));
  return mapOf(points, [&](Eigen::Index i) { return marginals[at(i)]; });
}

LandmarkMap EkfState::boundedMap() const {
  const auto points = allPoints();
  const auto bounds = neighbourhood_.varianceBounds(transports(points));
  return mapOf(points,
               [&](Eigen::Index i) -> Eigen::Matrix2d { return bounds.col(i).asDiagonal(); });
}

MapState EkfState::state() const {
  const auto points = allPoints();
  Neighbourhood updated = neighbourhood_;
  updated.renew(transports(points));
  std::vector<Eigen::Index> rows(at(kPoseSize + 2 * parameter_pairs_));
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  const auto first = static_cast<Eigen::Index>(rows.size());  // of the landmarks
  MapState state{pose(), {}, {}};
  for (const auto i : orderById()) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) rows.push_back(kPoseSize + 2 * i + axis);
    state.landmarks.push_back(landmark(i, points[at(i)]));
  }
  auto& joint = state.joint_covariance;
  joint.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index column = 0; column < joint.cols(); ++column)
    for (Eigen::Index row = 0; row < joint.rows(); ++row)
      joint(row, column) = updated.prior(rows[at(row)], rows[at(column)]);
  for (std::size_t i = 0; i < state.landmarks.size(); ++i) {
    const auto row = first + 2 * static_cast<Eigen::Index>(i);
    state.landmarks[i].covariance = joint.block<2, 2>(row, row);
  }
  return state;
}

}  // namespace slam::ekf
