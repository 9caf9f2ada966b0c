// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of numbers as bytes and back: in the first frame of their message, or each a part of its own. C++17.
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

/// Writes the columns of one message.
class ColumnWriter {
 public:
  ColumnWriter(flatbuffers::FlatBufferBuilder& builder, std::vector<Part>* parts) : builder_(builder), parts_(parts) {}

  template <class T>
  auto operator()(const Column<T>& column) {
    using Number = typename Row<T>::Number;
    const std::size_t bytes = column.size() * sizeof(T);
    if (parts_ != nullptr && bytes >= smallest_part) {
      parts_->push_back({column.data(), bytes, column.keeper()});
      told_.emplace_back(bytes, checksum(column.data(), bytes));
      return flatbuffers::Offset<flatbuffers::Vector<Number>>();
    }
    told_.emplace_back();
    return builder_.CreateVector(reinterpret_cast<const Number*>(column.data()), bytes / sizeof(Number));
  }

  /// What the message says of its parts; nothing where there are none.
  [[nodiscard]] auto parts() const {
    return parts_ == nullptr || parts_->empty() ? flatbuffers::Offset<flatbuffers::Vector<const buffer::Part*>>()
                                                : builder_.CreateVectorOfStructs(told_);
  }

 private:
  flatbuffers::FlatBufferBuilder& builder_;
  std::vector<Part>* parts_;
  std::vector<buffer::Part> told_;
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
  ColumnReader(const flatbuffers::Vector<const buffer::Part*>* told, std::uint64_t window, Keeper keeper,
               const NextPart& next)
      : window_(window), keeper_(std::move(keeper)), next_(next) {
    told_.resize(told != nullptr ? told->size() : 0);
    if (!told_.empty()) std::memcpy(told_.data(), told->Data(), told_.size() * sizeof(buffer::Part));
  }

  /// Are all numbers as they should be?
  template <class Sound, class T>
  bool read(const flatbuffers::Vector<typename Row<T>::Number>* here, Column<T>& into, const char* name) {
    const std::size_t column = column_++;
    if (column < told_.size() && told_[column].bytes() > 0) return read_part<Sound>(told_[column], into, name);
    if (here == nullptr || here->size() == 0) {
      into.clear();
      return true;
    }
    using Number = typename Row<T>::Number;
    const std::size_t bytes = here->size() * sizeof(Number);
    take(here->Data(), bytes, keeper_, into, name);
    return faults_in<Sound, Number>(here->Data(), bytes) == 0;
  }

 private:
  template <class Sound, class T>
  bool read_part(const buffer::Part& told, Column<T>& into, const char* name) {
    const Part part = next_ ? next_() : Part();
    if (part.data == nullptr) throw BadMessage(fmt::format("no {} in window {}", name, window_));
    if (part.size != told.bytes()) {
      throw BadMessage(
          fmt::format("{} bytes of {} where {} were due, in window {}", part.size, name, told.bytes(), window_));
    }
    // Summed and looked at in pieces, the second time from the processor's first cache.
    constexpr std::size_t piece = 1U << 14U;
    const auto* bytes = static_cast<const std::uint8_t*>(part.data);
    Checksum sum;
    std::uint64_t faults = 0;
    for (std::size_t from = 0; from < part.size; from += piece) {
      const std::size_t size = std::min(piece, part.size - from);
      sum.add(bytes + from, size);
      faults |= faults_in<Sound, typename Row<T>::Number>(bytes + from, size);
    }
    if (sum.value() != told.sum()) {
      throw BadMessage(fmt::format("{} bytes that are damaged, or not the {} of window {}", part.size, name, window_));
    }
    take(bytes, part.size, part.keeper, into, name);
    return faults == 0;
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
  void take(const std::uint8_t* from, std::size_t bytes, const Keeper& keeper, Column<T>& into, const char* name) {
    if (bytes % sizeof(T) != 0) {
      using Number = typename Row<T>::Number;
      throw BadMessage(
          fmt::format("{} holds {} numbers, not {} a block", name, bytes / sizeof(Number), sizeof(T) / sizeof(Number)));
    }
    const std::size_t size = bytes / sizeof(T);
    if (keeper && reinterpret_cast<std::uintptr_t>(from) % alignof(T) == 0) {
      into.view(reinterpret_cast<const T*>(from), size, keeper);
    } else {
      into.assign(size, T());
      std::memcpy(into.own().data(), from, bytes);
    }
  }

  std::uint64_t window_;
  Keeper keeper_;
  const NextPart& next_;
  std::vector<buffer::Part> told_;
  std::size_t column_ = 0;
};

}  // namespace blockweir::wire
