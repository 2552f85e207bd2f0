// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/localisation_services.hpp"

#include <cmath>
#include <utility>

#include "slam_core/models/motion.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/grid_publisher.hpp"

namespace slam_ros {
namespace {

using slam::Status;

/// Empty, or what makes the request unusable.
std::string faultOf(const nav_msgs::SetMap::Request& request, const std::string& map_frame) {
  const auto& map = request.map;
  const auto frame = frameId(map.header.frame_id);
  if (frame != map_frame)
    return "the map is in frame '" + frame + "', the map frame is '" + map_frame + "'";
  if (!(map.info.resolution > 0.0f) || !std::isfinite(map.info.resolution))
    return "the map's resolution is no length";
  if (map.data.empty() || map.data.size() != std::size_t{map.info.width} * map.info.height)
    return "the map has not as many cells as its width times its height";
  if (isTurned(map))
    return "the map's origin is turned or no number; its axes must be those of the map frame";
  const auto pose = fromMsg(request.initial_pose);
  if (!pose.pose.isFinite() || !slam::isCovariance(pose.covariance))
    return "the initial pose is no number or its covariance of (x, y, yaw) is not positive "
           "definite";
  return "";
}

}  // namespace

LocalisationServices::LocalisationServices(ros::NodeHandle handle, std::string map_frame,
                                           LocalisationActions actions)
    : map_frame_(std::move(map_frame)),
      actions_(std::move(actions)),
      search_(handle.advertiseService("global_localization", &LocalisationServices::search, this)),
      search_anyway_(handle.advertiseService("request_nomotion_update",
                                             &LocalisationServices::searchAnyway, this)) {
  if (actions_.set_map)
    set_map_ = handle.advertiseService("set_map", &LocalisationServices::setMap, this);
}

bool LocalisationServices::search(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  const auto status = actions_.search();
  actions_.report("global_localization", status);
  return status.isOk();
}

bool LocalisationServices::searchAnyway(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  actions_.search_anyway();
  return true;
}

bool LocalisationServices::setMap(nav_msgs::SetMap::Request& request,
                                  nav_msgs::SetMap::Response& response) {
  auto status = Status::ok();
  if (const auto fault = faultOf(request, map_frame_); !fault.empty())
    status = Status::error(fault + "; it is left out");
  else
    status = actions_.set_map({fromMsg(request.initial_pose), {}, {}, fromMsg(request.map)});
  actions_.report("set_map", status);
  response.success = status.level != Status::Level::kError;
  return true;
}

}  // namespace slam_ros
