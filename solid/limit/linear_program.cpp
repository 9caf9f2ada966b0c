// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/linear_program.hpp"

#include <fmt/format.h>
#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace blockweir::solid::limit {
namespace {

/// Over a column's largest entry: a moment whose arm is zero but for rounding. Kept, GLPK's scaling makes of it an
/// entry of the order of one, and then its basis is singular, or it finds no forces where there are some.
constexpr double round_off = 1e-10;

/// What GLPK's code and status mean where there is no optimum.
std::string why_not(int code, int status) {
  if (code == GLP_EITLIM || code == GLP_ETMLIM) return "came to no end";
  if (code != 0) return fmt::format("broke down (GLPK's code {})", code);
  if (status == GLP_UNBND) return "found nothing that bounds the objective, as where blocks jam,";
  return "found forces that do not balance within round-off, since loads and strengths are too many decades apart,";
}

}  // namespace

LinearProgram::LinearProgram() : program_(glp_create_prob(), glp_delete_prob) {
  glp_term_out(GLP_OFF);
  glp_set_obj_dir(program_.get(), GLP_MAX);
}

int LinearProgram::add_equation(double right_side) {
  const int row = glp_add_rows(program_.get(), 1);
  glp_set_row_bnds(program_.get(), row, GLP_FX, right_side, right_side);
  return row;
}

int LinearProgram::add_upper_bound(double right_side) {
  const int row = glp_add_rows(program_.get(), 1);
  glp_set_row_bnds(program_.get(), row, GLP_UP, 0, right_side);
  upper_.emplace_back(row, right_side);
  return row;
}

int LinearProgram::add_variable(double low, double high, Entries entries, double objective) {
  const int column = glp_add_cols(program_.get(), 1);
  const int kind = std::isinf(low)    ? (std::isinf(high) ? GLP_FR : GLP_UP)
                   : std::isinf(high) ? GLP_LO
                   : low == high      ? GLP_FX
                                      : GLP_DB;
  glp_set_col_bnds(program_.get(), column, kind, low, high);
  if (kind == GLP_LO) lower_.emplace_back(column, low);
  glp_set_obj_coef(program_.get(), column, objective);
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<int> rows = {0};  // GLPK counts from 1
  std::vector<double> values = {0};
  double largest = 0;
  for (const auto& [row, value] : entries) {
    if (row == rows.back()) {
      values.back() += value;
    } else {
      rows.push_back(row);
      values.push_back(value);
    }
    largest = std::max(largest, std::abs(values.back()));
  }
  std::size_t kept = 1;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (std::abs(values[i]) <= round_off * largest) continue;
    rows[kept] = rows[i];
    values[kept++] = values[i];
  }
  glp_set_mat_col(program_.get(), column, static_cast<int>(kept) - 1, rows.data(), values.data());
  return column;
}

/// Feasible, and the optimum of its duals, to what the answers are exact to.
bool LinearProgram::is_optimal() const {
  constexpr double exact = 1e-8;
  if (glp_get_status(program_.get()) != GLP_OPT) return false;
  for (const int condition : {GLP_KKT_PE, GLP_KKT_PB, GLP_KKT_DE, GLP_KKT_DB}) {
    double absolute = 0;
    double relative = 0;
    int where = 0;
    glp_check_kkt(program_.get(), GLP_SOL, condition, &absolute, &where, &relative, &where);
    if (!(relative <= exact)) return false;
  }
  return true;
}

/// From the present basis. Returns GLPK's code; 0: finished.
int LinearProgram::solve(int method) {
  constexpr int most_ms = 120'000;
  glp_smcp how;
  glp_init_smcp(&how);
  how.msg_lev = GLP_MSG_OFF;
  how.meth = method;
  how.tol_bnd = how.tol_dj = 1e-10;
  how.it_lim = 1000 + 10 * (glp_get_num_rows(program_.get()) + glp_get_num_cols(program_.get()));
  how.tm_lim = most_ms;
  return glp_simplex(program_.get(), &how);
}

/// Relaxes each bound by `size`, each slightly differently, so that bounds meeting in one point no longer make the
/// method cycle. If there is still no solution, there is none at all. 0 restores the bounds.
void LinearProgram::relax(double size, unsigned seed) {
  std::minstd_rand random(seed);
  const auto more = [&] { return size * (1 + static_cast<double>(random()) / std::minstd_rand::max()); };
  for (const auto& [row, bound] : upper_) glp_set_row_bnds(program_.get(), row, GLP_UP, 0, bound + more());
  for (const auto& [column, bound] : lower_) glp_set_col_bnds(program_.get(), column, GLP_LO, bound - more(), 0);
}

ProgramStatus LinearProgram::maximize() {
  glp_scale_prob(program_.get(), GLP_SF_AUTO);
  glp_adv_basis(program_.get(), 0);
  int failed = solve(GLP_PRIMAL);
  if (failed == 0 && is_optimal()) return ProgramStatus::optimal;
  constexpr unsigned most_tries = 5;
  for (unsigned seed = 1; seed <= most_tries; ++seed) {
    relax(1e-7, seed);
    glp_adv_basis(program_.get(), 0);
    failed = solve(GLP_PRIMAL);
    const int status = glp_get_status(program_.get());
    relax(0, seed);
    if (failed == 0 && status == GLP_NOFEAS) return ProgramStatus::infeasible;
    failed = solve(GLP_DUALP);  // its basis needs a few steps more
    if (failed == 0 && is_optimal()) return ProgramStatus::optimal;
    if (failed == 0 && glp_get_status(program_.get()) == GLP_NOFEAS) return ProgramStatus::infeasible;
  }
  const int status = glp_get_status(program_.get());
  throw std::runtime_error(fmt::format(
      "limit analysis: the simplex method {} on a linear program of {} rows and {} variables; expected an optimum; "
      "loads or strengths in wrong units may be the cause",
      why_not(failed, status), glp_get_num_rows(program_.get()), glp_get_num_cols(program_.get())));
}

double LinearProgram::value(int variable) const {
  return glp_get_col_prim(program_.get(), variable);
}

double LinearProgram::dual(int row) const {
  return glp_get_row_dual(program_.get(), row);
}

}  // namespace blockweir::solid::limit
