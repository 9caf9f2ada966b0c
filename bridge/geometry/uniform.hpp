// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace blockweir::geometry {

/// Uniform on 0 to 1. The standard library's distributions differ between implementations; its engines do not.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace blockweir::geometry
