// SPDX-License-Identifier: GPL-3.0-or-later
// Points in JSON: pairs of numbers.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// The point at index `first` of a list of numbers.
inline Eigen::Vector2d point_of(const nlohmann::json& list, std::size_t first = 0) {
  return {list[first].get<double>(), list[first + 1].get<double>()};
}

inline nlohmann::json pair(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

}  // namespace blockweir::picture
