// SPDX-License-Identifier: GPL-3.0-or-later
// What is otherwise until a scope ends, however it ends.
#pragma once

#include <utility>

namespace blockweir::solid {

/// A value that is another one for a while.
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

/// Two values that stand in for each other for a while; both may change meanwhile.
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
