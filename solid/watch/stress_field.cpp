// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/stress_field.hpp"

#include <Eigen/QR>
#include <map>
#include <set>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// Stress from a strain in a frame that is turned by `angle`, in global axes.
Eigen::Vector3d global_stress(const Block& block, const Eigen::Vector3d& strain, double angle) {
  const Eigen::Vector3d s = block.initial_stress + block.elasticity * strain;
  const double c = std::cos(2 * angle);
  const double d = std::sin(2 * angle);
  const double mean = (s[0] + s[1]) / 2;
  const double half = (s[0] - s[1]) / 2;
  return {mean + half * c - s[2] * d, mean - half * c + s[2] * d, half * d + s[2] * c};
}

}  // namespace

StressField::StressField(const Solid& solid, std::size_t block) : solid_(solid), block_(block) {
  if (solid.parts().triangles[block].empty()) return;
  first_ = solid.parts().triangles[block].front();
  number_nodes();
  sample_sides();
}

void StressField::number_nodes() {
  std::map<int, int> number;
  for (const int part : solid_.parts().triangles[block_]) {
    const Block& triangle = solid_.blocks()[at(part)];
    auto& corners = triangles_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [found, is_new] = number.emplace(triangle.nodes[i], static_cast<int>(nodes_.size()));
      corners[i] = found->second;
      if (is_new) {
        nodes_.emplace_back(triangle.centroid + triangle.vertices[i]);
        places_.push_back(solid_.placements()[at(part)].position(triangle.vertices[i]));
        around_.emplace_back();
      }
      around_[at(corners[i])].push_back(part - first_);
    }
  }
}

void StressField::sample_sides() {
  const auto& blocks = solid_.blocks();
  const auto count = static_cast<int>(triangles_.size());
  const auto stress = [&](int part) {
    const Vector6& d = solid_.states()[at(part)].displacement;
    return global_stress(blocks[at(part)], d.tail<3>(), d[2]);
  };
  const auto add = [&](Sample sample) {
    for (const int t : sample.triangles) samples_of_[at(t)].push_back(static_cast<int>(samples_.size()));
    samples_.push_back(std::move(sample));
  };
  samples_of_.resize(triangles_.size());
  for (const StrainCoupling& c : solid_.parts().couplings) {
    if (c.i < first_ || c.i >= first_ + count) continue;
    const double a = blocks[at(c.i)].area;
    const double b = blocks[at(c.j)].area;
    add({{c.i - first_, c.j - first_},
         (a * blocks[at(c.i)].centroid + b * blocks[at(c.j)].centroid) / (a + b),
         (a * stress(c.i) + b * stress(c.j)) / (a + b),
         (a + b) / 3});
  }
  for (const OutlineSide& side : solid_.parts().outlines[block_]) {
    const Block& triangle = blocks[at(side.part)];
    const Point ends = solid_.parts().vertex(side) + solid_.parts().end(side);
    add({{side.part - first_, side.part - first_}, triangle.centroid + ends / 3, stress(side.part), triangle.area / 3});
  }
}

Eigen::Vector3d StressField::fit(const std::vector<int>& seeds, const Point& point) const {
  std::set<int> patch;
  for (const int seed : seeds) {
    for (const int node : triangles_[at(seed)]) {
      for (const int t : around_[at(node)]) patch.insert(samples_of_[at(t)].begin(), samples_of_[at(t)].end());
    }
  }
  const auto n = static_cast<Eigen::Index>(patch.size());
  Eigen::MatrixX3d A(n, 3);
  Eigen::MatrixX3d b(n, 3);
  Eigen::Index row = 0;
  for (const int k : patch) {
    const Sample& s = samples_[at(k)];
    const double weight = std::sqrt(s.area);
    const Point from = (s.place - point) / solid_.blocks()[block_].radius;
    A.row(row) << weight, weight * from.x(), weight * from.y();
    b.row(row) = weight * s.stress.transpose();
    ++row;
  }
  return A.completeOrthogonalDecomposition().solve(b).row(0);
}

Eigen::Vector3d StressField::stress_at(const Point& point) const {
  if (triangles_.empty()) {
    const Vector6& d = solid_.states()[block_].displacement;
    return global_stress(solid_.blocks()[block_], d.tail<3>(), d[2]);
  }
  return fit({solid_.parts().anchor(static_cast<int>(block_), point).part - first_}, point);
}

std::vector<Eigen::Vector3d> StressField::at_nodes() const {
  std::vector<Eigen::Vector3d> stress;
  for (std::size_t node = 0; node < nodes_.size(); ++node) stress.push_back(fit(around_[node], nodes_[node]));
  return stress;
}

}  // namespace blockweir::solid
