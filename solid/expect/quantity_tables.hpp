// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the quantities of [[expect]].
#pragma once

#include <limits>
#include <map>
#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::expect {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< a quantity that the run does not have

/// By name. A quantity gets the finished run and the name of its subject, `of` in the scene.
using Quantities = std::map<std::string, double (*)(const Outcome&, const std::string&)>;
const Quantities& state_quantities();   ///< from the first and last frames, and from what was watched during the run
const Quantities& pile_quantities();    ///< from the final positions of blocks
const Quantities& series_quantities();  ///< from the time history of a block

double slip_over_balance(const Outcome& o, const std::string& subject);

/// The block of that name; a joint means the upper of its two blocks. Throws std::runtime_error.
std::size_t block_index(const Solid& solid, const std::string& name);

/// The failure that takes the subject with it, the first of all for an empty one; null if there is none. Throws as
/// block_index does.
const Failure* failure_of(const Outcome& o, const std::string& subject);

}  // namespace blockweir::solid::expect
