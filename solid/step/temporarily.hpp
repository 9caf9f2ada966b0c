// SPDX-License-Identifier: GPL-3.0-or-later
// Values changed for the lifetime of a scope.
#pragma once

#include <utility>

namespace blockweir::solid {

/// A temporary value; the old one returns at the end of the scope.
template <class T>
class Temporarily {
 public:
  Temporarily(T& value, T other) : value_(value), before_(std::exchange(value, std::move(other))) {}
  ~Temporarily() { value_ = std::move(before_); }
  Temporarily(const Temporarily&) = delete;
  Temporarily& operator=(const Temporarily&) = delete;

 private:
  T& value_;
  T before_;
};

/// Exchanges two values for the lifetime of a scope; both may change meanwhile.
template <class T>
class TradePlaces {
 public:
  TradePlaces(T& one, T& other) : one_(one), other_(other) { std::swap(one_, other_); }
  ~TradePlaces() { std::swap(one_, other_); }
  TradePlaces(const TradePlaces&) = delete;
  TradePlaces& operator=(const TradePlaces&) = delete;

 private:
  T& one_;
  T& other_;
};

}  // namespace blockweir::solid
