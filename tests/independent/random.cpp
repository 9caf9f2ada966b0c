// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/random.hpp"

#include <cmath>

namespace blockweir::independent {

Random::Random(std::uint64_t seed, const std::string& purpose) : state_(seed) {
  for (const char letter : purpose) state_ = next() + static_cast<std::uint64_t>(letter);
}

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Random::between(double low, double high) {
  return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
}

double Random::between_orders(double low, double high) {
  return low * std::pow(high / low, between(0, 1));
}

std::size_t Random::below(std::size_t count) {
  return static_cast<std::size_t>(next() % count);
}

bool Random::chance(double probability) {
  return between(0, 1) < probability;
}

}  // namespace blockweir::independent
