// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/joint_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/unnamed_joint.hpp"

namespace blockweir::joints {
namespace {

constexpr double reach = 2;  // a search serves until a corner has moved by half of that many widths of an open crack

struct Edge {
  int block;
  int edge;
  Point from;
  Point to;
};

Edge edge_of(int block, const std::vector<Point>& outline, std::size_t e) {
  return {block, static_cast<int>(e), outline[e], outline[e + 1 < outline.size() ? e + 1 : 0]};
}

/// Where edge b runs the other way along edge a, outside of it and nearer than `open_m`.
std::optional<Stretch> facing(const Edge& a, const Edge& b, double open_m, double least_m) {
  if ((a.to - a.from).dot(b.to - b.from) >= 0) return std::nullopt;
  const Point along_a = (a.to - a.from).normalized();
  const Point along_b = (b.from - b.to).normalized();
  constexpr double least_cosine = 0.866;  // 30 degrees: a wider wedge is open
  if (along_a.dot(along_b) < least_cosine) return std::nullopt;
  const Point t = (along_a + along_b).normalized();
  const Point outward(t.y(), -t.x());
  const double low = std::max(t.dot(a.from), t.dot(b.to));
  const double high = std::min(t.dot(a.to), t.dot(b.from));
  if (high - low <= least_m) return std::nullopt;
  Stretch s;
  const auto fraction = [&](const Edge& e, double at) {
    return std::clamp((at - t.dot(e.from)) / t.dot(e.to - e.from), 0.0, 1.0);
  };
  s.sides[0] = {a.block, a.edge, fraction(a, low), fraction(a, high)};
  s.sides[1] = {b.block, b.edge, fraction(b, low), fraction(b, high)};
  const auto place = [](const Edge& e, double share) { return Point(e.from + share * (e.to - e.from)); };
  const std::array<Point, 2> on_a = {place(a, s.sides[0].s_from), place(a, s.sides[0].s_to)};
  const std::array<Point, 2> on_b = {place(b, s.sides[1].s_from), place(b, s.sides[1].s_to)};
  for (const std::size_t end : {0U, 1U}) s.gap_m[end] = outward.dot(on_b[end] - on_a[end]);
  const auto [narrow, wide] = std::minmax(s.gap_m[0], s.gap_m[1]);
  if (narrow >= open_m || narrow <= -open_m || wide <= -open_m) return std::nullopt;
  // A slot that is wider than long is no joint: the step of a face beside another.
  if (high - low < 2 * wide && wide > open_m / 100) return std::nullopt;
  s.from = (on_a[0] + on_b[0]) / 2;
  s.to = (on_a[1] + on_b[1]) / 2;
  return s;
}

geometry::Bounds grown(const geometry::Bounds& box, double by_m) {
  return {box.low - Point::Constant(by_m), box.high + Point::Constant(by_m)};
}

}  // namespace

JointStretches::JointStretches(const scene::Scene& scene, double open_m) : scene_(scene), open_m_(open_m) {
  flows_ = scene::flows_in_joints(scene);
  for (const scene::Joint& joint : scene.joints) {
    named_[std::minmax(joint.between[0], joint.between[1])] = &joint;
  }
}

const scene::JointLaw& JointStretches::law(int a, int b) const {
  const auto named = named_.find(std::minmax(a, b));
  return named == named_.end() ? scene_.default_joint : named->second->law;
}

std::string JointStretches::name(const Stretch& stretch) const {
  const int a = stretch.sides[0].block;
  const int b = stretch.sides[1].block;
  const auto named = named_.find(std::minmax(a, b));
  if (named != named_.end()) return named->second->name;
  return scene::unnamed_joint(scene_, a, b);
}

void JointStretches::search(const std::vector<std::vector<Point>>& outlines) {
  searched_ = outlines;
  pairs_.clear();
  std::vector<scene::Block> moved(outlines.size());
  for (std::size_t b = 0; b < outlines.size(); ++b) moved[b].vertices = outlines[b];
  const scene::BlockIndex index(moved);
  neighbours_.assign(outlines.size(), {});
  for (std::size_t a = 0; a < outlines.size(); ++a) {
    std::vector<std::size_t> near = index.meeting(grown(geometry::bounds_of(outlines[a]), (1 + reach) * open_m_));
    std::sort(near.begin(), near.end());
    for (const std::size_t b : near) {
      if (b == a) continue;
      neighbours_[a].push_back(static_cast<int>(b));
      const Pair pair{static_cast<int>(a), static_cast<int>(b), &law(static_cast<int>(a), static_cast<int>(b))};
      if (b > a && pair.law->uplift == scene::Uplift::flow) pairs_.push_back(pair);
    }
  }
}

std::vector<Stretch> JointStretches::find(const std::vector<std::vector<Point>>& outlines) {
  double moved_m = searched_.empty() ? reach * open_m_ : 0;
  geometry::Bounds box = geometry::bounds_of(outlines.front());
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const geometry::Bounds own = geometry::bounds_of(outlines[b]);
    box = {box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    if (searched_.empty()) continue;
    for (std::size_t v = 0; v < outlines[b].size(); ++v) {
      moved_m = std::max(moved_m, (outlines[b][v] - searched_[b][v]).norm());
    }
  }
  if (moved_m >= reach / 2 * open_m_) search(outlines);
  const double least_m = 1e-9 * box.size();
  std::vector<Stretch> stretches;
  for (const Pair& pair : pairs_) {
    const std::vector<Point>& of_a = outlines[at(pair.a)];
    const std::vector<Point>& of_b = outlines[at(pair.b)];
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      for (std::size_t k = 0; k < of_b.size(); ++k) {
        std::optional<Stretch> found = facing(edge_of(pair.a, of_a, i), edge_of(pair.b, of_b, k), open_m_, least_m);
        if (!found) continue;
        found->law = pair.law;
        stretches.push_back(*found);
      }
    }
  }
  return stretches;
}

}  // namespace blockweir::joints
