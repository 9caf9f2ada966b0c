// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/row_batches.hpp"

#include <algorithm>
#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/solve/colouring.hpp"
#include "solid/solve/visit_parts.hpp"

namespace blockweir::solid {
namespace {

std::pair<int, int> counts(const ForceRow& row) {
  return {row.ends[0].count, row.ends[1].count};
}

std::array<int, 4> ends_of(const ForceRow& row) {
  const auto& [a, b] = row.ends;
  return {a.first, a.count, b.first, b.count};
}

/// Do both ends move the same unknowns, as those of blocks that water joins? A batch adds to each end by itself.
bool ends_meet(const ForceRow& row) {
  const auto& [a, b] = row.ends;
  return std::max(a.first, b.first) < std::min(a.first + a.count, b.first + b.count);
}

/// Are the row's unknowns too many for a batch, or those of both ends the same?
bool stays_alone(const ForceRow& row) {
  return std::max(row.ends[0].count, row.ends[1].count) > most_unknowns || ends_meet(row);
}

/// Empty where all rows are one part: few, or of bodies that share a part of their unknowns, as where water joins them.
std::vector<int> parts_of(const std::vector<ForceRow>& rows, std::size_t unknowns) {
  if (rows.size() < many) return {};
  std::vector<std::array<int, 2>> bodies(rows.size(), {-1, -1});
  std::vector<int> owner(unknowns, -1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (stays_alone(rows[k])) continue;
    for (const std::size_t e : {0, 1}) {
      const ForceRow::End& end = rows[k].ends[e];
      if (end.count == 0) continue;
      bodies[k][e] = end.first;
      for (int i = 0; i < end.count; ++i) {
        int& owns = owner[at(end.first + i)];
        if (owns >= 0 && owns != end.first) return {};
        owns = end.first;
      }
    }
  }
  return parts_of_rows(bodies, unknowns);
}

/// Rows by colour. In each, ends of the same numbers of unknowns follow each other.
std::vector<std::vector<int>> by_colour(const std::vector<ForceRow>& rows, const std::vector<int>& numbers,
                                        std::size_t unknowns, std::vector<int>& left_alone) {
  Colouring colouring(unknowns);
  for (const int k : numbers) {
    const auto& ends = rows[at(k)].ends;
    const std::array<Colouring::End, 2> met = {{{ends[0].first, ends[0].count}, {ends[1].first, ends[1].count}}};
    if (!colouring.add(k, met)) left_alone.push_back(k);
  }
  for (std::vector<int>& colour : colouring.rows()) {
    std::stable_sort(colour.begin(), colour.end(),
                     [&](int a, int b) { return counts(rows[at(a)]) < counts(rows[at(b)]); });
  }
  return colouring.rows();
}

}  // namespace

void RowBatches::choose(const std::vector<ForceRow>& rows, const std::vector<double>& entries, Eigen::Index nowhere) {
  if (nowhere != nowhere_ || !are_coloured(rows)) colour(rows, nowhere);
  for_each_batch(batches_.size(), [&](std::size_t k) { fill(batches_[k], rows, entries); });
}

/// Do the rows meet the same unknowns as those that were coloured?
bool RowBatches::are_coloured(const std::vector<ForceRow>& rows) const {
  return std::equal(rows.begin(), rows.end(), coloured_.begin(), coloured_.end(),
                    [](const ForceRow& row, const Ends& ends) { return ends_of(row) == ends; });
}

void RowBatches::colour(const std::vector<ForceRow>& rows, Eigen::Index nowhere) {
  nowhere_ = nowhere;
  batches_.clear();
  entries_.clear();
  left_alone_.clear();
  coloured_.clear();
  for (const ForceRow& row : rows) coloured_.push_back(ends_of(row));
  const std::vector<int> part = parts_of(rows, at(nowhere));
  std::array<std::vector<int>, sweep_parts + 1> numbers;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<int>& of_part = numbers[part.empty() ? 0 : at(part[k])];
    (stays_alone(rows[k]) ? left_alone_ : of_part).push_back(static_cast<int>(k));
  }
  std::array<std::vector<std::vector<int>>, sweep_parts + 1> colours;
  std::array<std::vector<int>, sweep_parts + 1> uncoloured;
  const auto colour_part = [&](std::size_t p) { colours[p] = by_colour(rows, numbers[p], at(nowhere), uncoloured[p]); };
  part.empty() ? colour_part(0) : share_by_place(numbers.size(), colour_part);
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    for (const std::vector<int>& colour : colours[p]) add_batches(colour, rows);
    left_alone_.insert(left_alone_.end(), uncoloured[p].begin(), uncoloured[p].end());
    ends_of_parts_[p] = batches_.size();
  }
}

void RowBatches::add_batches(const std::vector<int>& colour, const std::vector<ForceRow>& rows) {
  for (std::size_t from = 0; from < colour.size();) {
    RowBatch& batch = batches_.emplace_back();
    const auto like = counts(rows[at(colour[from])]);
    for (const std::size_t e : {0, 1}) {
      BatchEnd& end = batch.ends[e];
      end.first.fill(static_cast<int>(nowhere_));
      end.first_entry = entries_.size();
      end.count = rows[at(colour[from])].ends[e].count;
      entries_.resize(entries_.size() + at(4 * end.count));
    }
    for (std::size_t lane = 0; lane < batch.row.size() && from < colour.size(); ++lane, ++from) {
      const ForceRow& row = rows[at(colour[from])];
      if (counts(row) != like) break;
      batch.row[lane] = colour[from];
      for (const std::size_t e : {0, 1}) {
        if (row.ends[e].count > 0) batch.ends[e].first[lane] = row.ends[e].first;
      }
    }
  }
}

void RowBatches::fill(const RowBatch& batch, const std::vector<ForceRow>& rows, const std::vector<double>& entries) {
  for (const std::size_t e : {0, 1}) {
    const int count = 4 * batch.ends[e].count;
    BatchEntry* const to = entries_.data() + batch.ends[e].first_entry;
    for (int lane = 0; lane < lanes; ++lane) {
      if (batch.row[at(lane)] < 0) continue;
      const double* const from = entries.data() + rows[at(batch.row[at(lane)])].ends[e].first_entry;
      for (int i = 0; i < count; ++i) to[i].of[lane] = from[i];
    }
  }
}

void RowBatches::begin(const std::vector<ForceRow>& rows) {
  for_each_batch(batches_.size(), [&](std::size_t k) { begin(batches_[k], rows); });
}

void RowBatches::begin(RowBatch& batch, const std::vector<ForceRow>& rows) {
  PointForces<Four>::Law law;
  law.gap_by_normal += 1.0;  // of lanes without a row, which are open
  law.slip_by_shear += 1.0;
  law.opens += 1.0;
  batch.dry = true;
  for (int lane = 0; lane < lanes; ++lane) {
    if (batch.row[at(lane)] < 0) continue;
    const ForceRow& row = rows[at(batch.row[at(lane)])];
    batch.dry = batch.dry && row.rule.is_dry();
    const PointForces<double>::Law rule = law_of(row.rule, row.flexibility);
    law.friction[lane] = rule.friction;
    law.cohesion[lane] = rule.cohesion;
    law.least_normal[lane] = rule.least_normal;
    law.most_normal[lane] = rule.most_normal;
    law.opens[lane] = rule.opens;
    law.opening[0][lane] = rule.opening[0];
    law.opening[1][lane] = rule.opening[1];
    law.gap_by_normal[lane] = rule.gap_by_normal;
    law.gap_by_shear[lane] = rule.gap_by_shear;
    law.slip_by_shear[lane] = rule.slip_by_shear;
    batch.gap[lane] = row.apart[0];
    batch.slip[lane] = row.apart[1];
    batch.normal[lane] = row.force[0];
    batch.shear[lane] = row.force[1];
    batch.gap_by_normal[lane] = row.flexibility(0, 0);
    batch.gap_by_shear[lane] = row.flexibility(0, 1);
    batch.slip_by_shear[lane] = row.flexibility(1, 1);
  }
  batch.forces = PointForces<Four>(law);
  batch.normal_before = batch.normal;
  batch.shear_before = batch.shear;
}

void RowBatches::sweep(double by, double part, double* displacement, SweepProgress& progress) {
  BatchProgress four;
  const auto visit = [&](std::size_t first, std::size_t end, BatchProgress& so_far) {
    sweep_batches(std::span(batches_).subspan(first, end - first), entries_, by, part, displacement, so_far);
  };
  visit_parts(ends_of_parts_, visit, four);
  for (int lane = 0; lane < lanes; ++lane) {
    progress.largest_m = std::max(progress.largest_m, four.largest[lane]);
    progress.ahead += four.ahead[lane];
  }
}

void RowBatches::keep() {
  for (RowBatch& batch : batches_) {
    batch.normal_before = batch.normal;
    batch.shear_before = batch.shear;
  }
}

void RowBatches::take_kept() {
  for (RowBatch& batch : batches_) {
    batch.normal = batch.normal_before;
    batch.shear = batch.shear_before;
  }
}

void RowBatches::give_back(std::vector<ForceRow>& rows) const {
  for_each_batch(batches_.size(), [&](std::size_t k) {
    const RowBatch& batch = batches_[k];
    for (int lane = 0; lane < lanes; ++lane) {
      if (batch.row[at(lane)] < 0) continue;
      ForceRow& row = rows[at(batch.row[at(lane)])];
      row.force = {batch.normal[lane], batch.shear[lane]};
      row.slips = batch.slips[lane] != 0;
    }
  });
}

}  // namespace blockweir::solid
