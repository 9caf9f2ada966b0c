// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/linear_program.hpp"

#include <fmt/format.h>
#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blockweir::solid::limit {

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
  return row;
}

int LinearProgram::add_variable(double low, double high, Entries entries, double objective) {
  const int column = glp_add_cols(program_.get(), 1);
  const int kind = std::isinf(low)    ? (std::isinf(high) ? GLP_FR : GLP_UP)
                   : std::isinf(high) ? GLP_LO
                   : low == high      ? GLP_FX
                                      : GLP_DB;
  glp_set_col_bnds(program_.get(), column, kind, low, high);
  glp_set_obj_coef(program_.get(), column, objective);
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<int> rows = {0};  // GLPK counts from 1
  std::vector<double> values = {0};
  for (const auto& [row, value] : entries) {
    if (row == rows.back()) {
      values.back() += value;
    } else if (value != 0) {
      rows.push_back(row);
      values.push_back(value);
    }
  }
  glp_set_mat_col(program_.get(), column, static_cast<int>(rows.size()) - 1, rows.data(), values.data());
  return column;
}

ProgramStatus LinearProgram::maximize() {
  glp_smcp how;
  glp_init_smcp(&how);
  how.msg_lev = GLP_MSG_OFF;
  how.tol_bnd = how.tol_dj = 1e-10;
  how.it_lim = 100'000 + 100 * (glp_get_num_rows(program_.get()) + glp_get_num_cols(program_.get()));
  glp_scale_prob(program_.get(), GLP_SF_AUTO);
  glp_adv_basis(program_.get(), 0);
  const int failed = glp_simplex(program_.get(), &how);
  const int status = glp_get_status(program_.get());
  if (failed == 0 && status == GLP_OPT) return ProgramStatus::optimal;
  if (failed == 0 && status == GLP_NOFEAS) return ProgramStatus::infeasible;
  if (failed == 0 && status == GLP_UNBND) return ProgramStatus::unbounded;
  throw std::runtime_error(fmt::format(
      "limit analysis: the simplex method ended with code {}, status {} on a linear program of {} rows and {} "
      "variables; expected an optimum; is the scene's geometry very uneven (joints of very different lengths)?",
      failed, status, glp_get_num_rows(program_.get()), glp_get_num_cols(program_.get())));
}

double LinearProgram::value(int variable) const {
  return glp_get_col_prim(program_.get(), variable);
}

double LinearProgram::dual(int row) const {
  return glp_get_row_dual(program_.get(), row);
}

}  // namespace blockweir::solid::limit
