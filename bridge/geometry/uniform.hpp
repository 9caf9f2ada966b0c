// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same everywhere.
#pragma once

#include <cstdint>
#include <random>

namespace blockweir::geometry {

/// 0 to 1. Distributions of the standard library differ between libraries, its engines do not.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace blockweir::geometry
