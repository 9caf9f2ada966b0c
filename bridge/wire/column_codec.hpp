// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of numbers as bytes and back: at the end of their message's frame, or each a part of its own. C++17.
#pragma once

#include <flatbuffers/flatbuffers.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/codec.hpp"
#include "bridge/wire/messages_generated.h"

namespace blockweir::wire {

/// A row of a column, as numbers.
template <class T>
struct Row {
  using Number = T;
};
template <class T, std::size_t size>
struct Row<std::array<T, size>> {
  using Number = T;
};

/// Byte by byte: the verifier does not look at how a vector's elements are aligned.
template <class T>
void copy(const flatbuffers::Vector<T>* from, std::vector<T>& into) {
  static_assert(FLATBUFFERS_LITTLEENDIAN, "messages are little-endian");
  into.resize(from != nullptr ? from->size() : 0);
  if (!into.empty()) std::memcpy(into.data(), from->Data(), into.size() * sizeof(T));
}

/// Writes the columns of one message, before its table: into its frame, or as parts that follow it.
class ColumnWriter {
 public:
  ColumnWriter(flatbuffers::FlatBufferBuilder& builder, std::vector<Part>& parts) : builder_(builder), parts_(parts) {
    parts_.clear();
  }

  template <class T>
  void operator()(const Column<T>& column) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(column.data());
    const std::size_t size = column.size() * sizeof(T);
    told_.emplace_back(size, checksum(bytes, size));
    if (size >= smallest_part) {
      parts_.push_back({bytes, size, column.keeper()});
    } else if (size > 0) {
      builder_.PushBytes(bytes, size);
    }
  }

  /// What the table says of them.
  [[nodiscard]] auto told() const { return builder_.CreateVectorOfStructs(told_); }

 private:
  flatbuffers::FlatBufferBuilder& builder_;
  std::vector<Part>& parts_;
  std::vector<buffer::ColumnSum> told_;
};

/// What is left of a value that is no number, and nothing of one that is: no branch, so that a processor looks at
/// several at once. Who is wrong is looked for when one is.
struct Finite {
  std::uint64_t operator()(double value) const { return bits(value - value); }
  static std::uint64_t bits(double value) {
    std::uint64_t same = 0;
    std::memcpy(&same, &value, sizeof same);
    return same;
  }
};
struct Fraction {
  std::uint64_t operator()(double value) const {
    return (Finite::bits(value) | Finite::bits(1 - value)) >> 63U | Finite::bits(value - value);
  }
};
/// Nothing to look for.
struct Any {
  std::uint64_t operator()(std::uint32_t) const { return 0; }
};

/// Reads the columns of one message, in the order in which they were written.
class ColumnReader {
 public:
  /// `in_frame` bytes of columns end at `end`; the first of them stands last.
  ColumnReader(const flatbuffers::Vector<const buffer::ColumnSum*>* told, const std::uint8_t* end, std::size_t in_frame,
               std::uint64_t window, Keeper keeper, const NextPart& next)
      : told_(told), end_(end), in_frame_(in_frame), window_(window), keeper_(std::move(keeper)), next_(next) {}

  /// Are all numbers as they should be?
  template <class Sound, class T>
  bool read(Column<T>& into, const char* name) {
    using Number = typename Row<T>::Number;
    if (told_ == nullptr || column_ == told_->size()) throw missing(name);
    buffer::ColumnSum told;
    std::memcpy(&told, told_->Data() + column_++ * sizeof told, sizeof told);
    const Part part = told.bytes() >= smallest_part ? next_part(name) : from_frame(told.bytes(), name);
    if (part.size != told.bytes()) {
      throw BadMessage(
          fmt::format("{} bytes of {} where {} were due, in window {}", part.size, name, told.bytes(), window_));
    }
    if (part.size % sizeof(T) != 0) {
      throw BadMessage(fmt::format("{} holds {} numbers, not {} a block", name, part.size / sizeof(Number),
                                   sizeof(T) / sizeof(Number)));
    }
    const auto [sum, faults] = looked_at<Sound, Number>(part);
    if (sum != told.sum()) {
      throw BadMessage(fmt::format("{} bytes that are damaged, or not the {} of window {}", part.size, name, window_));
    }
    take(part, into);
    return faults == 0;
  }

  /// Is there another column?
  [[nodiscard]] bool more() const { return told_ != nullptr && column_ < told_->size(); }

  void end() const {
    if (in_frame_ > 0)
      throw BadMessage(fmt::format("{} bytes more than its header states in window {}", in_frame_, window_));
  }

 private:
  [[nodiscard]] BadMessage missing(const char* name) const {
    return BadMessage(fmt::format("no {} in window {}", name, window_));
  }

  Part next_part(const char* name) {
    Part part = next_ ? next_() : Part();
    if (part.data == nullptr) throw missing(name);
    return part;
  }

  Part from_frame(std::size_t size, const char* name) {
    if (size > in_frame_) throw missing(name);
    in_frame_ -= size;
    end_ -= size;
    return {end_, size, keeper_};
  }

  /// Checksum, and whether a number is not as it should be: piece by piece, the second time from the processor's first
  /// cache.
  template <class Sound, class Number>
  static std::pair<std::uint64_t, std::uint64_t> looked_at(const Part& part) {
    constexpr std::size_t piece = 1U << 14U;
    const auto* bytes = static_cast<const std::uint8_t*>(part.data);
    if (part.size <= piece) return {checksum(bytes, part.size), faults_in<Sound, Number>(bytes, part.size)};
    Checksum sum;
    std::uint64_t faults = 0;
    for (std::size_t from = 0; from < part.size; from += piece) {
      const std::size_t size = std::min(piece, part.size - from);
      sum.add(bytes + from, size);
      faults |= faults_in<Sound, Number>(bytes + from, size);
    }
    return {sum.value(), faults};
  }

  template <class Sound, class Number>
  static std::uint64_t faults_in(const std::uint8_t* bytes, std::size_t size) {
    std::uint64_t faults = 0;
    for (std::size_t i = 0; i < size / sizeof(Number); ++i) {
      Number number;
      std::memcpy(&number, bytes + i * sizeof number, sizeof number);
      faults |= Sound()(number);
    }
    return faults;
  }

  /// Viewed where it can be.
  template <class T>
  static void take(const Part& from, Column<T>& into) {
    const std::size_t size = from.size / sizeof(T);
    if (size == 0) {
      into.clear();
    } else if (from.keeper && reinterpret_cast<std::uintptr_t>(from.data) % alignof(T) == 0) {
      into.view(static_cast<const T*>(from.data), size, from.keeper);
    } else {
      into.assign(size, T());
      std::memcpy(into.own().data(), from.data, from.size);
    }
  }

  const flatbuffers::Vector<const buffer::ColumnSum*>* told_;
  const std::uint8_t* end_;
  std::size_t in_frame_;
  std::uint64_t window_;
  Keeper keeper_;
  const NextPart& next_;
  std::size_t column_ = 0;
};

}  // namespace blockweir::wire
