// SPDX-License-Identifier: GPL-3.0-or-later
// Messages as bytes and back. Bytes are verified before anything in them is read. C++17.
#pragma once

#include <flatbuffers/flatbuffers.h>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bridge/wire/message.hpp"

namespace blockweir::wire {

/// The bytes are no message of this protocol, or one whose content cannot be: what() says what is wrong.
struct BadMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Kind { hello, motion, load, end, failure, progress };

/// What keeps memory.
using Keeper = std::shared_ptr<const void>;

/// Bytes of a message: its frame, or a large column that follows it, sent from where it stands.
struct Part {
  const void* data = nullptr;
  std::size_t size = 0;  ///< [bytes]
  Keeper keeper = nullptr;
};
/// Columns from this size on are parts of their own [bytes].
inline constexpr std::size_t smallest_part = 1U << 18U;

/// Encode into `builder`: the frame that goes over the line stands at GetBufferPointer(), GetSize(), and `parts` follow
/// it. First in it is the table, then the columns that are no parts, then how many bytes these are, and the checksum of
/// the table and of that number.
void encode(const Hello& message, flatbuffers::FlatBufferBuilder& builder);
void encode(const Motion& message, flatbuffers::FlatBufferBuilder& builder, std::vector<Part>& parts);
void encode(const Load& message, flatbuffers::FlatBufferBuilder& builder, std::vector<Part>& parts);
void encode(const Farewell& message, flatbuffers::FlatBufferBuilder& builder);
void encode(const Failure& message, flatbuffers::FlatBufferBuilder& builder);
void encode(const Progress& message, flatbuffers::FlatBufferBuilder& builder);

/// What frames must be aligned to, here and below [bytes].
inline constexpr std::size_t alignment = 8;

/// What kind of message a frame holds; throws BadMessage when it holds none, or another than was sent.
Kind verify(const Part& frame);

/// Answers the next part of the message at hand; one without data where there is none.
using NextPart = std::function<Part()>;

/// Decode verified frames of the right kind: columns are verified, and view what somebody keeps; else they are copied
/// into storage that is reused. Parts are asked of `next`. Throw BadMessage for columns of unequal length, for
/// fractions outside 0..1 and for values that are not finite (levels may be NaN: no pool).
void decode(const Part& frame, Hello& into);
void decode(const Part& frame, Motion& into, const NextPart& next = nullptr);
void decode(const Part& frame, Load& into, const NextPart& next = nullptr);
void decode(const Part& frame, Farewell& into);
void decode(const Part& frame, Failure& into);
void decode(const Part& frame, Progress& into);

}  // namespace blockweir::wire
