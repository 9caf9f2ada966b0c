// SPDX-License-Identifier: GPL-3.0-or-later
// The ways in which a scene states points, outlines and the components of vectors and stresses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/read/table_reader.hpp"

namespace blockweir::scene {
namespace {

constexpr std::size_t most_vertices = 10'000;
constexpr double farthest_m = 1e7;  // beyond it, round-off in the coordinates is no longer small against a block

std::optional<Point> point_of(const toml::node& node) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2) return std::nullopt;
  const auto x = finite_number((*pair)[0]);
  const auto y = finite_number((*pair)[1]);
  if (!x || !y || std::max(std::abs(*x), std::abs(*y)) > farthest_m) return std::nullopt;
  return Point(*x, *y);
}

}  // namespace

bool TableReader::stress(const char* key, std::optional<Eigen::Vector3d>& into) {
  constexpr const char* words = "three finite numbers [xx, yy, xy]";
  const toml::node* node = ask(key, false, words);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != 3) return wrong(key, *node, words);
  Eigen::Vector3d read;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = finite_number((*list)[i]);
    if (!value) return wrong(key, (*list)[i], words);
    read[static_cast<Eigen::Index>(i)] = *value;
  }
  into = read;
  return true;
}

bool TableReader::point(const char* key, Point& into, bool required) {
  constexpr const char* words = "a pair of numbers [x, y] within 1e7";
  const toml::node* node = ask(key, required, words);
  if (node == nullptr) return false;
  const auto value = point_of(*node);
  if (!value) return wrong_point(key, *node, words);
  into = *value;
  return true;
}

bool TableReader::vector(const char* key, Eigen::Vector2d& into) {
  constexpr const char* words = "two finite numbers [x, y]";
  const toml::node* node = ask(key, false, words);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != 2) return wrong(key, *node, words);
  const auto x = finite_number((*list)[0]);
  const auto y = finite_number((*list)[1]);
  if (!x || !y) return wrong(key, *node, words);
  into = {*x, *y};
  return true;
}

bool TableReader::wrong_point(const std::string& key, const toml::node& node, const char* words) {
  const toml::array* list = node.as_array();
  for (std::size_t i = 0; list != nullptr && list->size() == 2 && i < 2; ++i) {
    const auto number = finite_number((*list)[i]);
    if (number && std::abs(*number) <= farthest_m) continue;
    const std::string part = (i == 0 ? "x of " : "y of ") + key;
    const bool is_far = number || (*list)[i].is_integer();
    return wrong(part.c_str(), (*list)[i], is_far ? "a number within 1e7, in metres" : "a finite number");
  }
  const bool long_list = list != nullptr && list->size() > 2 &&
                         std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_number(); });
  return wrong(key.c_str(), node, words,
               long_list ? "a point has two numbers; decimals have a point: 2.5, not 2,5" : "");
}

bool TableReader::points(const char* key, std::vector<Point>& into, std::size_t least) {
  const toml::node* node = ask(key, true, "a list of points [[x, y], ...]");
  return node != nullptr && points_of(key, *node, into, least);
}

bool TableReader::outlines(const char* key, std::vector<std::vector<Point>>& into) {
  const toml::node* node = ask(key, false, "");
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr) return wrong(key, *node, "a list of outlines [[[x, y], ...], ...]");
  for (const auto& entry : *list) {
    if (!points_of(key, entry, into.emplace_back(), 3)) return false;
  }
  return true;
}

bool TableReader::points_of(const char* key, const toml::node& node, std::vector<Point>& into, std::size_t least) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() < least || list->size() > most_vertices) {
    return wrong(key, node, fmt::format("a list of {} to {} points [[x, y], ...]", least, most_vertices));
  }
  std::vector<Point> read;
  for (const auto& entry : *list) {
    const auto p = point_of(entry);
    if (!p) {
      return wrong_point(fmt::format("point {} of {}", read.size() + 1, key), entry,
                         "a pair of numbers [x, y] in metres, within 1e7");
    }
    read.push_back(*p);
  }
  into = std::move(read);
  return true;
}

}  // namespace blockweir::scene
