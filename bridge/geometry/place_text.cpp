// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockweir::geometry {

std::string place_text(const Point& place, double size_m) {
  constexpr double round_off = 1e-5;
  const auto told = [&](double x) { return std::abs(x) < round_off * size_m ? 0 : x; };
  const double beyond = size_m > 0 ? place.cwiseAbs().maxCoeff() / size_m : 1;  // in national coordinates many sizes
  const int digits = 4 + static_cast<int>(std::ceil(std::log10(std::clamp(beyond, 1.0, 1e11))));
  return fmt::format("({:.{}g}, {:.{}g})", told(place.x()), digits, told(place.y()), digits);
}

std::string without_signed_zero(std::string number) {
  const bool zero =
      number.starts_with('-') && number.size() > 1 && number.find_first_not_of("-0.") == std::string::npos;
  return zero ? number.substr(1) : number;
}

}  // namespace blockweir::geometry
