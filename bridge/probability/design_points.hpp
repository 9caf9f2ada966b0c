// SPDX-License-Identifier: GPL-3.0-or-later
// The design points of a function of random variables: what governs at the means need not be what is likeliest to fail.
#pragma once

#include <openturns/Point.hxx>
#include <vector>

#include "bridge/probability/standard_state.hpp"

namespace blockweir::probability {

struct DesignPoint {
  OT::Point standard;
  double index = 0;     ///< beta with P = Phi(-beta), below 0 where the means fail
  double residual = 0;  ///< its value less the threshold
  unsigned iterations = 0;
};

struct DesignPoints {
  std::vector<DesignPoint> all;  ///< the likeliest first, without those less than a thousandth as likely; one at least
  bool means_fail = false;
};

/// Searches from the means, then from points about them that fail and that no design point so far explains. Throws
/// OT::Exception, std::runtime_error, or Unanswered where the search from the means ends if nothing is found.
DesignPoints design_points(const StandardState& state);

}  // namespace blockweir::probability
