// SPDX-License-Identifier: GPL-3.0-or-later
// A load that is being put together from what presses along edges, for pictures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bridge/picture/json_point.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

class Pressing {
 public:
  /// A force a metre that is linear from one point to the other; it goes on where the last one ended.
  void add(const scene::Point& from, const scene::Point& to, const scene::Point& q_from, const scene::Point& q_to) {
    const double length = (to - from).norm();
    if (length == 0 || (q_from.isZero(0) && q_to.isZero(0))) return;
    force_ += length / 2 * (q_from + q_to);
    middle_ += length / 6 * ((2 * q_from.norm() + q_to.norm()) * from + (q_from.norm() + 2 * q_to.norm()) * to);
    size_ += length / 2 * (q_from.norm() + q_to.norm());
    if (strips_.empty() || (from - end_).norm() > 1e-9 * length) strips_.push_back(nlohmann::json::array());
    strips_.back().push_back({from.x(), from.y(), q_from.x(), q_from.y()});
    strips_.back().push_back({to.x(), to.y(), q_to.x(), q_to.y()});
    end_ = to;
  }
  void put(const std::string& name, const char* kind, nlohmann::json& list) const {
    if (size_ == 0) return;
    list.push_back(
        {{"name", name}, {"kind", kind}, {"force", pair(force_)}, {"at", pair(middle_ / size_)}, {"strips", strips_}});
  }

 private:
  nlohmann::json strips_ = nlohmann::json::array();
  scene::Point end_ = scene::Point::Zero();
  scene::Point force_ = scene::Point::Zero();
  scene::Point middle_ = scene::Point::Zero();
  double size_ = 0;
};

}  // namespace blockweir::picture
