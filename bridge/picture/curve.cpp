// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace blockweir::picture {

std::string curve_rows(const std::vector<double>& x, const std::vector<double>& y, std::size_t spans, double factor) {
  if (x.empty()) return "";
  std::string rows;
  const auto add = [&](std::size_t i) {
    fmt::format_to(std::back_inserter(rows), "{:.6g} {:.6g}\n", x[i], factor * y[i]);
  };
  const double span = (x.back() - x.front()) / static_cast<double>(spans);
  std::size_t low = 0;
  std::size_t high = 0;
  std::size_t in_span = 0;  // values so far
  double ends = x.front();
  const auto close = [&] {
    if (in_span > 0) add(std::min(low, high));
    if (in_span > 0 && low != high) add(std::max(low, high));
    in_span = 0;
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(y[i])) {
      close();
      if (!rows.ends_with("\n\n")) rows += '\n';
      continue;
    }
    if (x[i] >= ends || i + 1 == x.size()) {
      close();
      ends = x[i] + span;
    }
    if (in_span == 0 || y[i] < y[low]) low = i;
    if (in_span == 0 || y[i] > y[high]) high = i;
    ++in_span;
  }
  close();
  return rows;
}

}  // namespace blockweir::picture
