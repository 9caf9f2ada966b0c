// SPDX-License-Identifier: GPL-3.0-or-later
// Corrects acceleration records for use as a base motion: removes a baseline, and filters without phase shift.
#pragma once

#include <optional>
#include <string>

#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

struct RecordCorrection {
  int baseline_terms = 0;  ///< of the polynomial that is removed: 0 none, 1 constant, 2 linear, 3 quadratic
  std::optional<double> highpass_hz{};
  std::optional<double> lowpass_hz{};
  [[nodiscard]] bool any() const { return baseline_terms > 0 || highpass_hz || lowpass_hz; }
  [[nodiscard]] bool filters() const { return highpass_hz || lowpass_hz; }
};

/// Result of integrating a record from rest at its first row; exact for rows with linear interpolation.
struct GroundEnd {
  double velocity = 0;
  double displacement = 0;
  double peak = 0;  ///< largest absolute acceleration
};
[[nodiscard]] GroundEnd ground_end(const TimeTable& record);

/// Whether all time steps are equal to within 1 %; a filter needs that.
[[nodiscard]] bool equal_steps(const TimeTable& record);

/// The row before the first gap in an otherwise equally spaced record. A gap is a step 1.5 times the usual one, not the
/// last step, and not between zeros.
[[nodiscard]] std::optional<std::size_t> row_before_gap(const TimeTable& record);

/// The corrected record. A row of 0 is added one step after its end, so that the ground does not move afterwards.
/// Each filter is a Butterworth filter of fourth order, forward and backward: it multiplies an amplitude of
/// frequency f by 1/(1 + (f/f_low)^8) or 1/(1 + (f_high/f)^8). The polynomial is removed before the filter and
/// again after it. It makes the final velocity zero; its remaining freedom minimizes the integral of the squared
/// velocity (after Berg and Housner). `record`: linear, three rows or more, from time 0; equally spaced if it is
/// filtered.
[[nodiscard]] TimeTable corrected(const TimeTable& record, const RecordCorrection& correction);

/// "baseline linear, high-pass 0.1 Hz, low-pass 25 Hz".
[[nodiscard]] std::string words_of(const RecordCorrection& correction);

}  // namespace blockweir::scene
