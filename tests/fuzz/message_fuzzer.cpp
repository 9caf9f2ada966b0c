// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a frame: read or refused. As they come, and with the checksum that makes a reader trust them.
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/codec.hpp"

namespace {

using namespace blockweir::wire;

template <class Message>
void decode_into_used(const void* frame) {
  static Message storage;  // as in a run, where it is reused
  decode(frame, storage);
}

/// Columns that are copied, and columns that are looked at where they stand.
template <class Message>
void decode_both_ways(const void* frame, std::size_t size) {
  decode_into_used<Message>(frame);
  Message viewing;
  const Keeper here(frame, [](const void*) {});
  decode(frame, viewing, here, [&] { return Part{frame, size, here}; });
  flatbuffers::FlatBufferBuilder again;
  encode(viewing, again);
}

void read(const void* frame, std::size_t size) {
  try {
    switch (verify(frame, size)) {
      case Kind::hello:
        return decode_into_used<Hello>(frame);
      case Kind::motion:
        return decode_both_ways<Motion>(frame, size);
      case Kind::load:
        return decode_both_ways<Load>(frame, size);
      case Kind::end:
        return decode_into_used<End>(frame);
      case Kind::failure:
        return decode_into_used<Failure>(frame);
    }
  } catch (const BadMessage&) {
    return;
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::uint64_t sum = checksum(data, size);
  std::vector<std::uint8_t> frame(size + sizeof sum);
  if (size > 0) std::memcpy(frame.data(), data, size);
  read(frame.data(), size);
  std::memcpy(frame.data() + size, &sum, sizeof sum);
  read(frame.data(), frame.size());
  return 0;
}
