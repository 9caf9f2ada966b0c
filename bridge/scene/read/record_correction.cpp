// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/record_correction.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace blockweir::scene {
namespace {

constexpr std::array baseline_words = {"none", "constant", "linear", "quadratic"};
constexpr int order = 4;  // of the Butterworth filter, each way

double step_of(const TimeTable& record) {
  return (record.time_s.back() - record.time_s.front()) / static_cast<double>(record.time_s.size() - 1);
}

/// Velocities at three points within each step, each times the root of its weight in Gauss' rule, which integrates
/// their squares exactly: they are quadratic there.
Eigen::VectorXd weighted_velocities(const TimeTable& record) {
  const double root = std::sqrt(0.15);
  const std::array points = {0.5 - root, 0.5, 0.5 + root};
  const std::array weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  Eigen::VectorXd all(3 * static_cast<Eigen::Index>(record.time_s.size() - 1));
  double velocity = 0;
  for (std::size_t i = 0; i + 1 < record.time_s.size(); ++i) {
    const double step = record.time_s[i + 1] - record.time_s[i];
    const double rise = record.value[i + 1] - record.value[i];
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double s = points[k];
      all[static_cast<Eigen::Index>(3 * i + k)] =
          std::sqrt(weights[k] * step) * (velocity + step * s * (record.value[i] + s * rise / 2));
    }
    velocity += step * (record.value[i] + rise / 2);
  }
  return all;
}

/// t^power of the rows, of a record of length 1, and 0 in the last.
TimeTable power_of_time(const TimeTable& record, int power) {
  TimeTable term = record;
  for (std::size_t i = 0; i < term.value.size(); ++i)
    term.value[i] = std::pow(term.time_s[i] / term.time_s.back(), power);
  term.value.back() = 0;
  return term;
}

void take_out_baseline(TimeTable& record, int terms) {
  if (terms == 0) return;
  std::vector<TimeTable> powers;
  Eigen::MatrixXd velocities(3 * static_cast<Eigen::Index>(record.time_s.size() - 1), terms);
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(terms + 1, terms + 1);  // the last for the final velocity
  Eigen::VectorXd right(terms + 1);
  for (int k = 0; k < terms; ++k) {
    powers.push_back(power_of_time(record, k));
    velocities.col(k) = weighted_velocities(powers.back());
    equations(k, terms) = equations(terms, k) = ground_end(powers.back()).velocity;
  }
  equations.topLeftCorner(terms, terms) = velocities.transpose() * velocities;
  right.head(terms) = velocities.transpose() * weighted_velocities(record);
  right[terms] = ground_end(record).velocity;
  const Eigen::VectorXd factors = equations.fullPivLu().solve(right);
  for (int k = 0; k < terms; ++k) {
    for (std::size_t i = 0; i < record.value.size(); ++i)
      record.value[i] -= factors[k] * powers[static_cast<std::size_t>(k)].value[i];
  }
}

double gain(const RecordCorrection& correction, double frequency_hz) {
  double product = 1;
  if (correction.lowpass_hz) product /= 1 + std::pow(frequency_hz / *correction.lowpass_hz, 2 * order);
  if (correction.highpass_hz) {
    product *= frequency_hz > 0 ? 1 / (1 + std::pow(*correction.highpass_hz / frequency_hz, 2 * order)) : 0;
  }
  return product;
}

/// Zeros before and after it, as long as the filter rings, keep its end from ringing into its start.
void filter(TimeTable& record, const RecordCorrection& correction) {
  if (!correction.filters()) return;
  const double step = step_of(record);
  const double ringing_s = 3 * order / (correction.highpass_hz ? *correction.highpass_hz : *correction.lowpass_hz);
  std::size_t length = 1;
  while (length < record.value.size() + static_cast<std::size_t>(ringing_s / step)) length *= 2;
  std::vector<double> padded = record.value;
  padded.resize(length);
  Eigen::FFT<double> transform;
  std::vector<std::complex<double>> spectrum;
  transform.fwd(spectrum, padded);
  for (std::size_t k = 0; k < length; ++k) {
    spectrum[k] *=
        gain(correction, static_cast<double>(std::min(k, length - k)) / (static_cast<double>(length) * step));
  }
  transform.inv(padded, spectrum);
  std::copy_n(padded.begin(), record.value.size() - 1, record.value.begin());  // the closing row stays 0
}

}  // namespace

GroundEnd ground_end(const TimeTable& record) {
  GroundEnd end;
  for (std::size_t i = 0; i < record.time_s.size(); ++i) {
    end.peak = std::max(end.peak, std::abs(record.value[i]));
    if (i == 0) continue;
    const double step = record.time_s[i] - record.time_s[i - 1];
    end.displacement += step * (end.velocity + step * (2 * record.value[i - 1] + record.value[i]) / 6);
    end.velocity += step * (record.value[i - 1] + record.value[i]) / 2;
  }
  return end;
}

bool equal_steps(const TimeTable& record) {
  const double step = step_of(record);
  for (std::size_t i = 0; i + 1 < record.time_s.size(); ++i) {
    if (std::abs(record.time_s[i + 1] - record.time_s[i] - step) > 0.01 * step) return false;
  }
  return true;
}

std::optional<std::size_t> row_before_gap(const TimeTable& record) {
  constexpr std::size_t few_rows = 10;
  constexpr double most_alike = 0.9;
  if (record.stepwise || record.time_s.size() < few_rows) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < record.time_s.size(); ++i) steps.push_back(record.time_s[i + 1] - record.time_s[i]);
  std::vector<double> sorted = steps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const auto alike =
      std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) <= 0.01 * usual; });
  if (static_cast<double>(alike) < most_alike * static_cast<double>(steps.size())) return std::nullopt;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (steps[i] > 1.5 * usual && (record.value[i] != 0 || record.value[i + 1] != 0)) return i;
  }
  return std::nullopt;
}

TimeTable corrected(const TimeTable& record, const RecordCorrection& correction) {
  TimeTable result = record;
  const double last_step = record.time_s.back() - record.time_s[record.time_s.size() - 2];
  result.time_s.push_back(record.time_s.back() + last_step);
  result.value.push_back(0);
  take_out_baseline(result, correction.baseline_terms);
  filter(result, correction);
  if (correction.filters()) take_out_baseline(result, correction.baseline_terms);
  return result;
}

std::string words_of(const RecordCorrection& correction) {
  std::string words =
      fmt::format("baseline {}", baseline_words.at(static_cast<std::size_t>(correction.baseline_terms)));
  if (correction.highpass_hz) words += fmt::format(", high-pass {:g} Hz", *correction.highpass_hz);
  if (correction.lowpass_hz) words += fmt::format(", low-pass {:g} Hz", *correction.lowpass_hz);
  return words;
}

}  // namespace blockweir::scene
