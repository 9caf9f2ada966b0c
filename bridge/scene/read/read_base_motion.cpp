// SPDX-License-Identifier: GPL-3.0-or-later
// [base_motion]: the ground's acceleration, and what is done to its records before they act.
#include <fmt/format.h>

#include "bridge/scene/read/check_sampling.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/read/record_correction.hpp"

namespace blockweir::scene {
namespace {

RecordCorrection read_correction(TableReader& table) {
  RecordCorrection correction;
  table.choice<int>("baseline", correction.baseline_terms,
                    {{"none", 0}, {"constant", 1}, {"linear", 2}, {"quadratic", 3}});
  table.number("highpass_hz", correction.highpass_hz, positive());
  table.number("lowpass_hz", correction.lowpass_hz, positive());
  return correction;
}

/// Reports what a correction cannot be made of, or with.
bool fits(TableReader& table, const char* key, const TimeTable& record, const RecordCorrection& correction,
          Problems& problems) {
  const auto refuse = [&](const char* at, const std::string& found, const std::string& expected, const char* remedy) {
    problems.error(table.place(at), found, expected, remedy);
    return false;
  };
  if (record.sine || record.stepwise || record.time_s.size() < 3 || record.time_s.front() != 0) {
    return refuse(key, fmt::format("{} in [base_motion] is no record that a baseline or filter can be taken from", key),
                  "a linear table or file of three rows or more, the first at time 0",
                  "state such rows, or leave baseline, highpass_hz and lowpass_hz out");
  }
  if (!correction.filters()) return true;
  if (!equal_steps(record)) {
    return refuse(key, fmt::format("the rows of {} in [base_motion] are not equally far apart", key),
                  "equal steps in time, to 1 %, where the record is filtered", "sample the record anew");
  }
  const double length_s = record.time_s.back();
  const double nyquist_hz = static_cast<double>(record.time_s.size() - 1) / (2 * length_s);
  if (correction.lowpass_hz && *correction.lowpass_hz > nyquist_hz * (1 + 1e-9)) {
    return refuse("lowpass_hz",
                  fmt::format("lowpass_hz in [base_motion] is {:g} Hz, and the rows of {} show nothing above {:.4g} Hz",
                              *correction.lowpass_hz, key, nyquist_hz),
                  "at most half the number of rows in a second", "lower lowpass_hz, or leave it out");
  }
  if (correction.highpass_hz && *correction.highpass_hz * length_s < 1) {
    return refuse("highpass_hz",
                  fmt::format("highpass_hz in [base_motion] is {:g} Hz, a period longer than the record of {:.4g} s",
                              *correction.highpass_hz, length_s),
                  fmt::format("at least {:.3g} Hz", 1 / length_s), "raise highpass_hz, or leave it out");
  }
  return true;
}

/// Rows that are lacking would be a straight line. `described`: the record in the scene.
void check_gap(Reading& reading, TableReader& table, const char* key, const TimeTable& record,
               const toml::node* described) {
  const std::optional<std::size_t> row = row_before_gap(record);
  if (!row) return;
  const auto source = reading.records.find(described);
  const std::string where = source == reading.records.end()
                                ? fmt::format("row {}", *row + 1)
                                : fmt::format("line {} of {}", source->second.lines[*row], source->second.file);
  reading.problems.error(table.place(key),
                         fmt::format("{} in [base_motion] has a gap after {}, from {:.6g} to {:.6g} s", key, where,
                                     record.time_s[*row], record.time_s[*row + 1]),
                         "rows as far apart as most of them are",
                         "fill in the rows that are lacking, or sample the record anew");
}

std::string change_of(const char* key, const GroundEnd& before, const GroundEnd& after) {
  return fmt::format(
      "{}: final velocity {:.4g} to {:.4g} m/s, final displacement {:.4g} to {:.4g} m, peak {:.4g} to {:.4g} m/s2", key,
      before.velocity, after.velocity, before.displacement, after.displacement, before.peak, after.peak);
}

}  // namespace

void read_base_motion(Reading& reading) {
  const toml::table* section = reading.section("base_motion");
  TableReader table(reading.problems, section, "[base_motion]");
  const Analysis& analysis = reading.scene.analysis;
  BaseMotion base;
  table.choice<BaseForm>("form", base.form, {{"inertia", BaseForm::inertia}, {"support", BaseForm::support}});
  const RecordCorrection correction = read_correction(table);
  if (correction.highpass_hz && correction.lowpass_hz && *correction.highpass_hz >= *correction.lowpass_hz) {
    reading.problems.error(table.place("highpass_hz"),
                           fmt::format("highpass_hz in [base_motion] is {:g} Hz and lowpass_hz {:g} Hz",
                                       *correction.highpass_hz, *correction.lowpass_hz),
                           "highpass_hz below lowpass_hz", "exchange them, or keep one");
  }
  const auto read_axis = [&](const char* key, TimeTable& into) {
    std::optional<TimeTable> stated;
    if (!table.time_table(key, stated, analysis.duration_s)) return;
    into = *stated;
    check_gap(reading, table, key, *stated, section->get(key));
    if (correction.any() && fits(table, key, *stated, correction, reading.problems)) {
      into = corrected(*stated, correction);
      const std::string begin = base.correction.empty() ? words_of(correction) : base.correction;
      base.correction = begin + "; " + change_of(key, ground_end(*stated), ground_end(into));
    }
    if (analysis.kind == AnalysisKind::at_rest) return;
    check_sampling(fmt::format("{} in [base_motion]", key), table.place(key), into,
                   {"[analysis] step_s", analysis.step_s, analysis.duration_s, analysis.kind == AnalysisKind::dynamic},
                   reading.problems);
  };
  read_axis("acceleration_x_m_per_s2", base.acceleration_x_m_per_s2);
  read_axis("acceleration_y_m_per_s2", base.acceleration_y_m_per_s2);
  if (!table.present()) return;
  if (!table.has("acceleration_x_m_per_s2") && !table.has("acceleration_y_m_per_s2")) {
    reading.problems.error(table.place(), "[base_motion] moves nothing",
                           "acceleration_x_m_per_s2, acceleration_y_m_per_s2 or both",
                           "state an acceleration, or leave [base_motion] out");
  }
  reading.scene.base_motion = std::move(base);
}

}  // namespace blockweir::scene
