// SPDX-License-Identifier: GPL-3.0-or-later
// What the figures of [[expect]] have in common: tables of them.
#pragma once

#include <limits>
#include <map>
#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::expect {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< a figure that the run does not have

/// By name; each gets the finished run and what the expectation is `of`.
using Quantities = std::map<std::string, double (*)(const Outcome&, const std::string&)>;
const Quantities& state_quantities();   ///< from the first and last frames, and from watches over the run
const Quantities& pile_quantities();    ///< from where blocks lie in the end
const Quantities& series_quantities();  ///< from the course of a block's motion

double slip_over_balance(const Outcome& o, const std::string& of);

/// The block of that name; a joint stands for the upper of its two blocks. Throws std::runtime_error.
std::size_t block_index(const Solid& solid, const std::string& name);

}  // namespace blockweir::solid::expect
