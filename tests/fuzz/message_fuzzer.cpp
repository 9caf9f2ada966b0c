// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a frame: read or refused. As they come, and with checksums that make a reader trust them.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/codec.hpp"
#include "bridge/wire/messages_generated.h"

namespace {

using namespace blockweir::wire;

template <class Message>
void decode_into_used(const Part& frame) {
  static Message storage;  // as in a run, where it is reused
  decode(frame, storage);
}

/// Columns that are copied, and columns that are looked at where they stand.
template <class Message>
void decode_both_ways(const Part& frame) {
  decode_into_used<Message>(frame);
  Message viewing;
  const Keeper here(frame.data, [](const void*) {});
  decode({frame.data, frame.size, here}, viewing, [&] { return Part{frame.data, frame.size, here}; });
  flatbuffers::FlatBufferBuilder again;
  std::vector<Part> parts;
  encode(viewing, again, parts);
}

void read(const std::vector<std::uint8_t>& bytes) {
  const Part frame{bytes.data(), bytes.size()};
  try {
    switch (verify(frame)) {
      case Kind::hello:
        return decode_into_used<Hello>(frame);
      case Kind::motion:
        return decode_both_ways<Motion>(frame);
      case Kind::load:
        return decode_both_ways<Load>(frame);
      case Kind::end:
        return decode_into_used<Farewell>(frame);
      case Kind::failure:
        return decode_into_used<Failure>(frame);
      case Kind::progress:
        return decode_into_used<Progress>(frame);
    }
  } catch (const BadMessage&) {
    return;
  }
  std::abort();
}

/// Checksums that make a reader trust the bytes.
class Mender {
 public:
  explicit Mender(std::vector<std::uint8_t>& frame) : frame_(frame) {}

  /// Those of the columns, if there is a table that tells them, and then that of the table.
  void mend() {
    seal();
    try {
      const Kind kind = verify({frame_.data(), frame_.size()});
      const buffer::Envelope& envelope = *buffer::GetEnvelope(frame_.data());
      if (kind == Kind::motion) mend_columns(envelope.body_as_Motion()->columns());
      if (kind == Kind::load) mend_columns(envelope.body_as_Load()->columns());
    } catch (const BadMessage&) {
      return;
    }
    seal();
  }

 private:
  [[nodiscard]] std::size_t end() const { return frame_.size() - 2 * sizeof(std::uint64_t); }
  [[nodiscard]] std::uint64_t in_frame() const {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, frame_.data() + end(), sizeof bytes);
    return std::min<std::uint64_t>(bytes, end());
  }
  void seal() {
    const std::uint64_t bytes = in_frame();
    const std::uint64_t sum = checksum(frame_.data(), end() - bytes, bytes);
    std::memcpy(frame_.data() + end(), &bytes, sizeof bytes);
    std::memcpy(frame_.data() + end() + sizeof bytes, &sum, sizeof sum);
  }
  void mend_columns(const flatbuffers::Vector<const buffer::ColumnSum*>* told) {
    std::size_t column_end = end();
    std::size_t left = in_frame();
    for (std::size_t i = 0; told != nullptr && i < told->size(); ++i) {
      const std::size_t at = static_cast<std::size_t>(told->Data() - frame_.data()) + i * sizeof(buffer::ColumnSum);
      buffer::ColumnSum column;
      std::memcpy(&column, frame_.data() + at, sizeof column);
      if (column.bytes() > left) return;
      left -= column.bytes();
      column_end -= column.bytes();
      column = {column.bytes(), checksum(frame_.data() + column_end, column.bytes())};
      std::memcpy(frame_.data() + at, &column, sizeof column);
    }
  }

  std::vector<std::uint8_t>& frame_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> frame(data, data + size);
  read(frame);
  if (size < sizeof(std::uint64_t)) return 0;
  frame.resize(size + sizeof(std::uint64_t));
  Mender(frame).mend();
  read(frame);
  return 0;
}
