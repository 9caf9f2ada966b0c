// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/limit_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "bridge/scene/at.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/determinacy.hpp"
#include "solid/limit/linear_program.hpp"

namespace blockweir::solid::limit {
namespace {

constexpr double largest_factor_told = 1e6;  // a factor beyond is none
/// Over the weight, of all normal forces together where a shortage is asked for. Blocks that jam bear whatever presses
/// them once friction is just large enough, by forces that grow without limit there: no program has an optimum near it.
constexpr double largest_normal = 1e5;

bool any_moves(const scene::Scene& scene) {
  return std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const auto& block) { return !block.fixed; });
}

std::vector<Face> held_by(const scene::Scene& scene, Kinks kinks) {
  std::vector<Face> faces = faces_of(scene);
  if (kinks == Kinks::give_way) std::erase_if(faces, [](const Face& face) { return face.in_kink; });
  return faces;
}

}  // namespace

/// Balance and strength, forces in units of the weight and moments in that times the size.
class LimitAnalysis::Program {
 public:
  Program(const LimitAnalysis& structure, const Wrenches& dead, double reduction, double most_normal = infinite)
      : structure_(structure), rows_(dead.size(), 0) {
    if (std::isfinite(most_normal)) all_normal_ = lp_.add_upper_bound(most_normal);
    for (std::size_t b = 0; b < dead.size(); ++b) {
      if (structure.scene_.blocks[b].fixed) continue;
      const Wrench load = scaled(dead[b]);
      rows_[b] = lp_.add_equation(-load[0]);
      lp_.add_equation(-load[1]);
      lp_.add_equation(-load[2]);
    }
    for (const Face& face : structure.faces_) add(face, reduction);
    for (const Tie& tie : structure.ties_) add(tie);
  }

  int add_factor(const Wrenches& live) {
    LinearProgram::Entries entries;
    for (std::size_t b = 0; b < live.size(); ++b) append(static_cast<int>(b), scaled(live[b]), entries);
    return lp_.add_variable(0, largest_factor_told, entries, /*objective=*/1);
  }
  int add_shortage(double price) {
    LinearProgram::Entries entries;
    for (const Strength& s : strengths_) entries.insert(entries.end(), {{s.forth, -1}, {s.back, -1}});
    shortage_ = lp_.add_variable(0, infinite, entries, -price);
    return *shortage_;
  }
  /// Lets each equation of balance miss by as much as the worst does, which is to be least.
  void add_imbalance() {
    LinearProgram::Entries worst;
    for (const int first : rows_) {
      for (int row = first; first != 0 && row < first + 3; ++row) {
        const int size = lp_.add_upper_bound(0);
        worst.emplace_back(size, -1);
        for (const double sign : {1.0, -1.0}) lp_.add_variable(0, infinite, {{row, sign}, {size, 1}});
      }
    }
    lp_.add_variable(0, infinite, worst, /*objective=*/-1);
  }
  /// False if no forces balance the loads. All objectives are bounded: the factor by the largest one reported, shortage
  /// and imbalance by nature.
  bool solve() { return lp_.maximize() == ProgramStatus::optimal; }

  [[nodiscard]] double value(int variable) const { return lp_.value(variable); }
  /// The balance's duals: the motion on which live loads have power.
  [[nodiscard]] Twists mechanism() const {
    Twists twists(rows_.size(), Twist::Zero());
    for (std::size_t b = 0; b < rows_.size(); ++b) {
      if (rows_[b] == 0) continue;
      twists[b] = {lp_.dual(rows_[b]), lp_.dual(rows_[b] + 1), lp_.dual(rows_[b] + 2) / structure_.size_m_};
    }
    return twists;
  }
  /// What the shortage falls by for a unit more of all normal forces together.
  [[nodiscard]] double price_of_normal() const { return all_normal_ ? lp_.dual(*all_normal_) : 0; }
  /// Adds tangents to faces with curved friction whose forces exceed it; true if there were any.
  bool add_tangents(std::vector<Face>& faces, double reduction) const {
    const double weight = structure_.weight_n_per_m_;
    const double lacks = shortage_ ? lp_.value(*shortage_) : 0;
    bool added = false;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      double normal = 0;
      for (const int variable : forces_[i].normal) normal += lp_.value(variable);
      const double shear = (std::abs(lp_.value(forces_[i].shear)) - lacks) * reduction;
      added = faces[i].add_tangent(normal * weight, shear * weight) || added;
    }
    return added;
  }
  /// Sum over the faces of what each lacks per unit of strength times that strength.
  [[nodiscard]] double priced_strength() const {
    double sum = 0;
    for (const Strength& s : strengths_) {
      double normal = 0;
      for (const int variable : forces_[at(s.face)].normal) normal += lp_.value(variable);
      sum += (lp_.dual(s.forth) + lp_.dual(s.back)) * (s.cohesion + s.friction * normal);
    }
    return sum;
  }

 private:
  /// A bound of a face's shear.
  struct Strength {
    int forth;  ///< rows of shear along the face and against it
    int back;
    int face;
    double cohesion;
    double friction;
  };
  /// Variables of a face.
  struct Forces {
    std::vector<int> normal;
    int shear = 0;
  };

  /// Throws std::runtime_error if it is beyond what the simplex method can scale.
  [[nodiscard]] Wrench scaled(const Wrench& w) const {
    constexpr double most = 1e9;
    const Wrench scaled = Wrench(w[0], w[1], w[2] / structure_.size_m_) / structure_.weight_n_per_m_;
    if (scaled.allFinite() && scaled.cwiseAbs().maxCoeff() <= most) return scaled;
    throw std::runtime_error(fmt::format(
        "limit analysis: found loads of {:.3g} times the structure's weight; expected at most {:.3g} times; "
        "look for loads in wrong units",
        scaled.cwiseAbs().maxCoeff(), most));
  }
  /// Per unit of weight; what is far beyond all loads is as good as any.
  [[nodiscard]] double scaled(double strength_n_per_m) const {
    constexpr double most = 1e9;
    const double of_weight = strength_n_per_m / structure_.weight_n_per_m_;
    return std::isinf(of_weight) ? of_weight : std::clamp(of_weight, -most, most);
  }
  void append(int block, const Wrench& load, LinearProgram::Entries& entries) const {
    if (block < 0 || rows_[at(block)] == 0) return;
    for (int k = 0; k < 3; ++k) entries.emplace_back(rows_[at(block)] + k, load[k]);
  }
  /// A unit force on the block.
  void append(int block, const Point& direction, const Point& place, LinearProgram::Entries& entries) const {
    if (block < 0) return;
    Wrench load = wrench_of(direction, place, structure_.centroids_[at(block)]);
    load[2] /= structure_.size_m_;
    append(block, load, entries);
  }

  void add(const Face& face, double reduction) {
    const double tension = scaled(face.tension_n_per_m / 2);
    const std::size_t first = strengths_.size();
    for (const Face::Bound& bound : face.bounds()) {
      const double cohesion = scaled(bound.cohesion_n_per_m);
      strengths_.push_back({.forth = lp_.add_upper_bound(cohesion / reduction),
                            .back = lp_.add_upper_bound(cohesion / reduction),
                            .face = static_cast<int>(forces_.size()),
                            .cohesion = cohesion,
                            .friction = bound.friction});
    }
    const std::span<const Strength> strengths = std::span(strengths_).subspan(first);
    Forces forces;
    const auto on_both = [&](const Point& on_b, const Point& place) {
      LinearProgram::Entries entries;
      append(face.b, on_b, place, entries);
      append(face.a, -on_b, place, entries);
      return entries;
    };
    for (const Point& place : face.ends()) {
      LinearProgram::Entries entries = on_both(face.normal, place);
      for (const Strength& s : strengths) {
        entries.insert(entries.end(), {{s.forth, -s.friction / reduction}, {s.back, -s.friction / reduction}});
      }
      if (all_normal_) entries.emplace_back(*all_normal_, 1);
      forces.normal.push_back(lp_.add_variable(-tension, infinite, entries));
    }
    LinearProgram::Entries shear = on_both(face.along(), face.from_m);
    for (const Strength& s : strengths) shear.insert(shear.end(), {{s.forth, 1}, {s.back, -1}});
    forces.shear = lp_.add_variable(-infinite, infinite, shear);
    forces_.push_back(std::move(forces));
  }
  void add(const Tie& tie) {
    LinearProgram::Entries entries;
    append(tie.a, tie.direction, tie.at_a_m, entries);
    append(tie.b, -tie.direction, tie.at_b_m, entries);
    lp_.add_variable(scaled(tie.low_n_per_m), scaled(tie.high_n_per_m), entries);
  }

  const LimitAnalysis& structure_;
  std::vector<int> rows_;  ///< first of the three of each block; 0: it is fixed
  std::vector<Strength> strengths_;
  std::vector<Forces> forces_;     ///< by face
  std::optional<int> shortage_;    ///< variable
  std::optional<int> all_normal_;  ///< row
  LinearProgram lp_;
};

LimitAnalysis::LimitAnalysis(const scene::Scene& scene, Kinks kinks)
    : scene_(scene),
      centroids_(statics::centroids_of(scene)),
      faces_(held_by(scene, kinks)),
      ties_(ties_of(scene)),
      is_exact_(follow_from_equilibrium(scene, faces_, ties_)),
      size_m_(scene::structure_size_m(scene.blocks)) {
  if (!any_moves(scene)) {
    throw std::invalid_argument("limit analysis: all blocks are fixed; expected one that can move, set fixed = false");
  }
  const Wrenches weights = statics::weights_of(scene);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!scene.blocks[b].fixed) weight_n_per_m_ += weights[b].head<2>().norm();
  }
  if (weight_n_per_m_ == 0) weight_n_per_m_ = 1;
}

bool LimitAnalysis::holds_any_force() const {
  return std::any_of(scene_.bolts.begin(), scene_.bolts.end(), [](const auto& bolt) { return !bolt.yield_n_per_m; });
}

bool LimitAnalysis::has_shear_strength() const {
  return std::any_of(faces_.begin(), faces_.end(), [](const Face& face) {
    return face.friction > 0 || face.cohesion_n_per_m > 0 || !face.tangents.empty();
  });
}

LargestFactor LimitAnalysis::largest_factor(const Wrenches& dead, const Wrenches& live) const {
  Program program(*this, dead, /*reduction=*/1);
  const int factor = program.add_factor(live);
  if (!program.solve()) return {};
  if (program.add_tangents(faces_, /*reduction=*/1)) return largest_factor(dead, live);
  LargestFactor found{.bearing = Bearing::fails_at_a_factor, .factor = program.value(factor)};
  if (found.factor >= largest_factor_told) return {.bearing = Bearing::bears_any};
  found.mechanism = program.mechanism();
  normalize(found.mechanism);
  const double of_mechanism =
      (resistance(found.mechanism) - power(dead, found.mechanism)) / power(live, found.mechanism);
  found.gap = std::abs(of_mechanism - found.factor) / std::max(std::abs(of_mechanism), std::abs(found.factor));
  return found;
}

bool LimitAnalysis::bears(const Wrenches& loads) const {
  const Wrenches nothing(loads.size(), Wrench::Zero());
  return largest_factor(loads, nothing).bearing == Bearing::bears_any;
}

std::optional<Shortage> LimitAnalysis::shortage(const Wrenches& loads, double reduction) const {
  Program program(*this, loads, reduction, largest_normal);
  const int ratio = program.add_shortage(/*price=*/1);
  if (!program.solve()) return std::nullopt;
  if (program.add_tangents(faces_, reduction)) return shortage(loads, reduction);
  Shortage found{.ratio = program.value(ratio),
                 .per_reduction = program.priced_strength() / (reduction * reduction),
                 .mechanism = program.mechanism()};
  if (found.ratio <= 0) return found;
  found.jam_power = program.price_of_normal() * largest_normal * weight_n_per_m_ / normalize(found.mechanism);
  return found;
}

Twists LimitAnalysis::collapse(const Wrenches& loads, bool however_strong) const {
  Program program(*this, loads, /*reduction=*/1);
  if (however_strong) program.add_shortage(/*price=*/0);
  program.add_imbalance();
  program.solve();
  if (!however_strong && program.add_tangents(faces_, /*reduction=*/1)) return collapse(loads, however_strong);
  Twists mechanism = program.mechanism();
  normalize(mechanism);
  return mechanism;
}

}  // namespace blockweir::solid::limit
