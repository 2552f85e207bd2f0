// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/backend_services.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"

namespace slam_ros {
namespace {

/// The service's answer: the sentence of `action`, or of what it threw.
template <class Response, class Action>
bool answer(Response& response, Action&& action) {
  try {
    response.message = action();
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
  }
  return true;
}

std::string inflated(const slam::LandmarkFile& file) {
  const bool complete = file.map.landmarks.empty() || file.map.joint_covariance.size() > 0;
  return complete ? "" : "; it holds no joint covariance, so the landmarks' own were inflated";
}

std::string contents(const slam::LandmarkFile& file, bool has_grid) {
  const auto landmarks = std::to_string(file.map.landmarks.size()) + " landmarks";
  if (file.map.grid) return "a grid, " + landmarks;
  return has_grid ? "no grid found; " + landmarks : landmarks;
}

}  // namespace

BackendServices::BackendServices(ros::NodeHandle handle, std::string map_frame, bool has_grid,
                                 MapFolder folder, BackendActions actions)
    : map_frame_(std::move(map_frame)),
      has_grid_(has_grid),
      folder_(std::move(folder)),
      actions_(std::move(actions)),
      reset_(handle.advertiseService("reset", &BackendServices::reset, this)),
      pause_(handle.advertiseService("pause", &BackendServices::pause, this)),
      save_(handle.advertiseService("save_map", &BackendServices::save, this)),
      load_(handle.advertiseService("load_map", &BackendServices::load, this)),
      remove_(handle.advertiseService("remove_landmark", &BackendServices::remove, this)) {
  if (!actions_.session) return;
  save_session_ = handle.advertiseService("save_session", &BackendServices::saveSession, this);
  load_session_ = handle.advertiseService("load_session", &BackendServices::loadSession, this);
  merge_session_ = handle.advertiseService("merge_session", &BackendServices::mergeSession, this);
}

bool BackendServices::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer(response, [&] {
    actions_.reset();
    return "map and pose begin anew";
  });
}

bool BackendServices::pause(std_srvs::SetBool::Request& request,
                            std_srvs::SetBool::Response& response) {
  return answer(response, [&] {
    actions_.pause(request.data != 0);
    return request.data != 0 ? "observations are ignored, motion is still applied"
                             : "observations are used again";
  });
}

bool BackendServices::save(slam_msgs::SaveMap::Request& request,
                           slam_msgs::SaveMap::Response& response) {
  return answer(response, [&] {
    return slam::saveMap(folder_.resolveMapForWriting(request.path), actions_.map());
  });
}

bool BackendServices::load(slam_msgs::LoadMap::Request& request,
                           slam_msgs::LoadMap::Response& response) {
  return answer(response, [&] {
    const auto path = folder_.resolveMap(request.path);
    const auto file = slam::loadMap(path, map_frame_, has_grid_);
    const auto status = actions_.load(file);
    if (status.level == slam::Status::Level::kError)
      throw std::runtime_error("cannot use the map " + path + ": " + status.message);
    const auto said =
        contents(file, has_grid_) + " and the pose loaded from " + path + inflated(file);
    return status.isOk() ? said : said + "; " + status.message;
  });
}

bool BackendServices::remove(slam_msgs::RemoveLandmark::Request& request,
                             slam_msgs::RemoveLandmark::Response& response) {
  return answer(response, [&] {
    const auto status = actions_.remove(request.id);
    if (!status.isOk()) throw std::runtime_error(status.message);
    return "landmark " + std::to_string(request.id) +
           " is removed; should it be seen again, it is a new one";
  });
}

bool BackendServices::saveSession(slam_msgs::SaveMap::Request& request,
                                  slam_msgs::SaveMap::Response& response) {
  return answer(response, [&] {
    const auto path = folder_.resolveForWriting(request.path);
    slam::writeFileAtomically(path, actions_.session().bytes);
    return "the session is saved in " + path;
  });
}

bool BackendServices::loadSession(slam_msgs::LoadMap::Request& request,
                                  slam_msgs::LoadMap::Response& response) {
  return answer(response, [&] {
    const auto path = folder_.resolve(request.path);
    const auto status = actions_.take_up({slam::readInputFile(path, "the session")});
    if (status.level == slam::Status::Level::kError)
      throw std::runtime_error("cannot use the session " + path + ": " + status.message);
    const auto said = "the session and the pose are those of " + path;
    return status.isOk() ? said : said + "; " + status.message;
  });
}

bool BackendServices::mergeSession(slam_msgs::LoadMap::Request& request,
                                   slam_msgs::LoadMap::Response& response) {
  return answer(response, [&] {
    const auto path = folder_.resolve(request.path);
    const auto status = actions_.merge({slam::readInputFile(path, "the session")});
    if (!status.isOk())
      throw std::runtime_error("cannot use the session " + path + ": " + status.message);
    return path + " waits until it is recognised; then `events` has `merged`";
  });
}

}  // namespace slam_ros
