// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/after_load.hpp"

#include <ros/callback_queue.h>
#include <ros/init.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <utility>

namespace slam_ros {
namespace {

class Call final : public ros::CallbackInterface {
 public:
  explicit Call(std::function<void()> call) : call_(std::move(call)) {}
  CallResult call() override {
    call_();
    return Success;
  }

 private:
  std::function<void()> call_;
};

std::uint64_t idOf(const AfterLoad* owner) { return reinterpret_cast<std::uintptr_t>(owner); }

}  // namespace

AfterLoad::AfterLoad(std::function<void()> call) {
  ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<Call>(std::move(call)), idOf(this));
}

AfterLoad::~AfterLoad() { ros::getGlobalCallbackQueue()->removeByID(idOf(this)); }

}  // namespace slam_ros
