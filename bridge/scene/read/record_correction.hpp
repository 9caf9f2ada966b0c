// SPDX-License-Identifier: GPL-3.0-or-later
// Records of accelerations made fit to shake a structure: a baseline taken out, and a filter without delay.
#pragma once

#include <optional>
#include <string>

#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

struct RecordCorrection {
  int baseline_terms = 0;  ///< of the polynomial that is taken out: 0 none, 1 constant, 2 linear, 3 quadratic
  std::optional<double> highpass_hz{};
  std::optional<double> lowpass_hz{};
  [[nodiscard]] bool any() const { return baseline_terms > 0 || highpass_hz || lowpass_hz; }
  [[nodiscard]] bool filters() const { return highpass_hz || lowpass_hz; }
};

/// What integrating a record gives, exactly for rows that are linear in between, from rest at its first row.
struct GroundEnd {
  double velocity = 0;
  double displacement = 0;
  double peak = 0;  ///< largest size of the acceleration
};
[[nodiscard]] GroundEnd ground_end(const TimeTable& record);

/// The rows between which times differ by more than 1 % are not equally far apart; a filter needs that they are.
[[nodiscard]] bool equal_steps(const TimeTable& record);

/// The row before the first gap in rows that are else equally far apart: a step half as long again as they are, not the
/// last one, and not between zeros.
[[nodiscard]] std::optional<std::size_t> row_before_gap(const TimeTable& record);

/// The record with a row of 0 a step after its last, so that the ground does not move afterwards. Each filter is a
/// Butterworth of fourth order, forward and backward: an amplitude of frequency f is multiplied by 1/(1 + (f/f_low)^8)
/// and 1/(1 + (f_high/f)^8); it acts on the record between zeros. The polynomial that is taken out, before the filter
/// and once more after it, makes the final velocity zero; what it has of freedom beyond that minimizes the integral of
/// the velocity's square (after Berg and Housner). `record`: linear, three rows or more, from time 0; where it is
/// filtered, of equal steps.
[[nodiscard]] TimeTable corrected(const TimeTable& record, const RecordCorrection& correction);

/// "baseline linear, high-pass 0.1 Hz, low-pass 25 Hz".
[[nodiscard]] std::string words_of(const RecordCorrection& correction);

}  // namespace blockweir::scene
