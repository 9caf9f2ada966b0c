// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/box_index.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace blockweir::geometry {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::d2::point_xy<double>;
using Box = bg::model::box<Corner>;
using Numbered = std::pair<Box, std::size_t>;

Box box(const Bounds& b) {
  return {Corner(b.low.x(), b.low.y()), Corner(b.high.x(), b.high.y())};
}

template <class Predicate, class Tree>
std::vector<std::size_t> numbers(const Tree& tree, const Predicate& wanted) {
  std::vector<std::size_t> found;
  tree.query(wanted, boost::make_function_output_iterator([&](const Numbered& n) { found.push_back(n.second); }));
  return found;
}

}  // namespace

struct BoxIndex::Tree : bg::index::rtree<Numbered, bg::index::linear<16>> {
  using rtree::rtree;
};

BoxIndex::BoxIndex(const std::vector<Entry>& entries) {
  std::vector<Numbered> boxes;
  boxes.reserve(entries.size());
  for (const auto& [bounds, number] : entries) boxes.emplace_back(box(bounds), number);
  tree_ = std::make_unique<Tree>(boxes);
}

BoxIndex::BoxIndex(const std::vector<Point>& points) {
  std::vector<Numbered> boxes;
  boxes.reserve(points.size());
  for (const Point& p : points) boxes.emplace_back(box({p, p}), boxes.size());
  tree_ = std::make_unique<Tree>(boxes);
}

BoxIndex::~BoxIndex() = default;

std::vector<std::size_t> BoxIndex::meeting(const Bounds& bounds) const {
  return numbers(*tree_, bg::index::intersects(box(bounds)));
}

bool BoxIndex::any_meets(const Bounds& bounds) const {
  return tree_->qbegin(bg::index::intersects(box(bounds))) != tree_->qend();
}

std::vector<std::size_t> BoxIndex::nearest(const Point& p, unsigned count) const {
  return numbers(*tree_, bg::index::nearest(Corner(p.x(), p.y()), count));
}

void BoxIndex::forget(const Entry& entry) {
  tree_->remove(Numbered(box(entry.first), entry.second));
}

}  // namespace blockweir::geometry
