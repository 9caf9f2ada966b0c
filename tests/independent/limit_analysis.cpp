// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/limit_analysis.hpp"

#include <glpk.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace blockweir::independent {
namespace {

/// A linear program that is written down row by row and column by column.
class Program {
 public:
  Program() : lp_(glp_create_prob(), glp_delete_prob) {
    glp_term_out(GLP_OFF);
    glp_set_obj_dir(lp_.get(), GLP_MAX);
  }

  int add_row(int kind, double low, double high) {
    const int row = glp_add_rows(lp_.get(), 1);
    glp_set_row_bnds(lp_.get(), row, kind, low, high);
    return row;
  }
  int add_column(int kind, double low, double high, const std::vector<std::pair<int, double>>& entries) {
    const int column = glp_add_cols(lp_.get(), 1);
    glp_set_col_bnds(lp_.get(), column, kind, low, high);
    std::vector<int> rows = {0};
    std::vector<double> values = {0};
    for (const auto& [row, value] : entries) {
      if (value != 0) rows.push_back(row), values.push_back(value);
    }
    glp_set_mat_col(lp_.get(), column, static_cast<int>(rows.size()) - 1, rows.data(), values.data());
    return column;
  }
  bool maximize(int column) {
    glp_set_obj_coef(lp_.get(), column, 1);
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.tol_bnd = how.tol_dj = 1e-9;
    glp_scale_prob(lp_.get(), GLP_SF_AUTO);
    return glp_simplex(lp_.get(), &how) == 0 && glp_get_status(lp_.get()) == GLP_OPT;
  }
  [[nodiscard]] double value(int column) const { return glp_get_col_prim(lp_.get(), column); }
  [[nodiscard]] double dual(int row) const { return glp_get_row_dual(lp_.get(), row); }

 private:
  std::unique_ptr<glp_prob, void (*)(glp_prob*)> lp_;
};

struct Solution {
  double factor = 0;
  std::vector<Eigen::Vector3d> velocities;
};

/// Forces in units of the weight of all bodies, moments about each body's centroid in units of that times its size.
class Balance {
 public:
  explicit Balance(const Structure& structure) : structure_(structure) {
    for (const Body& body : structure.bodies) {
      if (body.fixed) continue;
      weight_ += structure.density_kg_per_m3 * gravity * area_of(body.outline_m);
      for (const Vec& p : body.outline_m) size_ = std::max(size_, (p - body.outline_m[0]).norm());
    }
    const std::vector<Face> faces = faces_of(structure);
    std::vector<Wrench> dead = weights_of(structure);
    const std::vector<Wrench> tail = tailwater_on(structure, faces);
    rows_.resize(dead.size(), 0);
    for (std::size_t b = 0; b < dead.size(); ++b) {
      if (structure.bodies[b].fixed) continue;
      const Eigen::Vector3d load = -reduced(b, dead[b] + tail[b]);
      rows_[b] = program_.add_row(GLP_FX, load[0], load[0]);
      program_.add_row(GLP_FX, load[1], load[1]);
      program_.add_row(GLP_FX, load[2], load[2]);
    }
    for (const Face& face : faces) add(face);
    for (const Bolt& bolt : structure.bolts) {
      const std::size_t body = body_of(structure, bolt.body);
      program_.add_column(GLP_DB, 0, bolt.yield_n_per_m / weight_,
                          entries(body, (bolt.to_m - bolt.from_m).normalized(), bolt.from_m));
    }
  }

  std::optional<Solution> solve(const std::vector<Wrench>& live) {
    constexpr double enough = 1e4;
    std::vector<std::pair<int, double>> column;
    for (std::size_t b = 0; b < live.size(); ++b) append(column, b, reduced(b, live[b]));
    const int factor = program_.add_column(GLP_DB, 0, enough, column);
    if (!program_.maximize(factor)) return std::nullopt;
    Solution solution{program_.value(factor), {}};
    for (const int row : rows_) {
      solution.velocities.emplace_back(Eigen::Vector3d::Zero());
      for (int k = 0; row > 0 && k < 3; ++k) solution.velocities.back()[k] = -program_.dual(row + k);
    }
    return solution;
  }

 private:
  [[nodiscard]] Eigen::Vector3d reduced(std::size_t b, const Wrench& wrench) const {
    const Vec centre = centroid_of(structure_.bodies[b].outline_m);
    const double moment = wrench[2] - (centre.x() * wrench[1] - centre.y() * wrench[0]);
    return Eigen::Vector3d(wrench[0], wrench[1], moment / size_) / weight_;
  }
  void append(std::vector<std::pair<int, double>>& column, std::size_t b, const Eigen::Vector3d& load) const {
    for (int k = 0; rows_[b] > 0 && k < 3; ++k) column.emplace_back(rows_[b] + k, load[k]);
  }
  [[nodiscard]] std::vector<std::pair<int, double>> entries(std::size_t b, const Vec& direction, const Vec& at) const {
    std::vector<std::pair<int, double>> column;
    append(column, b, reduced(b, weight_ * wrench_of(direction, at)));
    return column;
  }
  void add(const Face& face) {
    const double tension = borne_tension_pa(face.law) * face.length_m() / 2 / weight_;
    const double cohesion = face.law.cohesion_pa * face.length_m() / weight_;
    const double friction = std::tan(face.law.friction_deg * std::numbers::pi / 180);
    const int forth = program_.add_row(GLP_UP, 0, cohesion);
    const int back = program_.add_row(GLP_UP, 0, cohesion);
    const auto on_both = [&](const Vec& on_a, const Vec& at) {
      auto column = entries(face.a, on_a, at);
      const auto other = entries(face.b, -on_a, at);
      column.insert(column.end(), other.begin(), other.end());
      return column;
    };
    for (const Vec& end : {face.from_m, face.to_m}) {
      auto normal = on_both(-face.normal, end);
      normal.emplace_back(forth, -friction);
      normal.emplace_back(back, -friction);
      program_.add_column(GLP_LO, -tension, 0, normal);
    }
    auto shear = on_both(face.along(), face.from_m);
    shear.emplace_back(forth, 1);
    shear.emplace_back(back, -1);
    program_.add_column(GLP_FR, 0, 0, shear);
  }

  const Structure& structure_;
  double weight_ = 0;
  double size_ = 0;
  std::vector<int> rows_;  ///< first of the three of each body; 0: it is fixed
  Program program_;
};

std::optional<Solution> solve(const Structure& structure, double level_m) {
  return Balance(structure).solve(reservoir_on(structure, faces_of(structure), level_m));
}

}  // namespace

std::optional<double> reservoir_factor(const Structure& structure, double level_m) {
  const auto solution = solve(structure, level_m);
  return solution ? std::optional(solution->factor) : std::nullopt;
}

/// Regula falsi (Illinois) on the factor's logarithm over that of the depth, which is all but straight.
std::optional<Limit> limit_level(const Structure& structure, double low_m, double high_m) {
  const double bottom = low_m - (high_m - low_m);
  struct Point {
    double depth;
    double excess;
  };
  const auto look = [&](double depth) -> std::optional<Point> {
    const auto factor = reservoir_factor(structure, bottom + depth);
    return factor && *factor > 0 ? std::optional(Point{depth, std::log(*factor)}) : std::nullopt;
  };
  auto safe = look(low_m - bottom);
  auto fails = look(high_m - bottom);
  if (!safe || !fails || safe->excess <= 0 || fails->excess >= 0) return std::nullopt;
  int side = 0;
  while (fails->depth - safe->depth > 1e-12 * fails->depth) {
    const double share = safe->excess / (safe->excess - fails->excess);
    const auto next = look(safe->depth + share * (fails->depth - safe->depth));
    if (!next) return std::nullopt;
    if (std::abs(next->excess) < 1e-10) {
      const auto last = solve(structure, bottom + next->depth);
      return Limit{bottom + next->depth, last ? last->velocities : std::vector<Eigen::Vector3d>{}};
    }
    if (next->excess > 0) {
      safe = next;
      if (std::exchange(side, 1) == 1) fails->excess /= 2;
    } else {
      fails = next;
      if (std::exchange(side, -1) == -1) safe->excess /= 2;
    }
  }
  return Limit{bottom + (safe->depth + fails->depth) / 2, {}};
}

}  // namespace blockweir::independent
