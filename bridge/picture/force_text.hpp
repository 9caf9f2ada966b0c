// SPDX-License-Identifier: GPL-3.0-or-later
// Forces as text in engineering units.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace blockweir::picture {

/// "412.5 kN/m"; from 10,000 kN/m on "12.73 MN/m".
inline std::string force_text(double n_per_m) {
  constexpr double large = 1e7;
  return std::abs(n_per_m) < large ? fmt::format("{:.4g} kN/m", n_per_m / 1e3)
                                   : fmt::format("{:.4g} MN/m", n_per_m / 1e6);
}

}  // namespace blockweir::picture
