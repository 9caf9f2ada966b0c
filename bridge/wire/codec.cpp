// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/wire/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/messages_generated.h"

namespace blockweir::wire {
namespace {

using Builder = flatbuffers::FlatBufferBuilder;

/// A buffer is filled from its end: what comes first stands last. That is the checksum's place.
void begin(Builder& builder) {
  builder.Clear();
  builder.PushElement(std::uint64_t{0});
}

template <class Offset>
void finish(Builder& builder, buffer::Body kind, Offset body) {
  buffer::FinishEnvelopeBuffer(builder, buffer::CreateEnvelope(builder, kind, body.Union()));
  const std::size_t length = builder.GetSize() - sizeof(std::uint64_t);
  const std::uint64_t sum = checksum(builder.GetBufferPointer(), length);
  std::memcpy(builder.GetBufferPointer() + length, &sum, sizeof sum);
}

template <class Body>
const Body& body(const void* data) {
  return *buffer::GetEnvelope(data)->template body_as<Body>();
}

std::string text(const flatbuffers::String* from) {
  return from != nullptr ? from->str() : std::string();
}

/// Byte by byte: the verifier does not look at how a vector's elements are aligned.
template <class T>
void copy(const flatbuffers::Vector<T>* from, std::vector<T>& into) {
  static_assert(FLATBUFFERS_LITTLEENDIAN, "messages are little-endian");
  into.resize(from != nullptr ? from->size() : 0);
  if (!into.empty()) std::memcpy(into.data(), from->Data(), into.size() * sizeof(T));
}

std::uint64_t bits(double value) {
  std::uint64_t same = 0;
  std::memcpy(&same, &value, sizeof same);
  return same;
}

/// What is left of a value that is no number, and nothing of one that is: no branch, so that a processor looks at
/// several at once. Who is wrong is looked for when one is.
struct Finite {
  std::uint64_t operator()(double value) const { return bits(value - value); }
};
struct Fraction {
  std::uint64_t operator()(double value) const { return (bits(value) | bits(1 - value)) >> 63U | bits(value - value); }
};

/// Are all numbers as they should be?
template <class Fault>
bool all_sound(const flatbuffers::Vector<double>* numbers) {
  if (numbers == nullptr) return true;
  const std::uint8_t* bytes = numbers->Data();
  const std::size_t size = numbers->size();
  std::uint64_t faults = 0;
  for (std::size_t i = 0; i < size; ++i) {
    double value = 0;
    std::memcpy(&value, bytes + i * sizeof value, sizeof value);
    faults |= Fault()(value);
  }
  return faults == 0;
}

/// `size` values from `from` on, viewed where they can be.
template <class T>
void take(const std::uint8_t* from, std::size_t size, Column<T>& into, const Keeper& keeper) {
  if (keeper && reinterpret_cast<std::uintptr_t>(from) % alignof(T) == 0) {
    into.view(reinterpret_cast<const T*>(from), size, keeper);
    return;
  }
  into.assign(size, T());
  if (size > 0) std::memcpy(into.own().data(), from, size * sizeof(T));
}

template <class T>
void take(const flatbuffers::Vector<T>* from, Column<T>& into, const Keeper& keeper) {
  if (from == nullptr) {
    into.clear();
  } else {
    take(from->Data(), from->size(), into, keeper);
  }
}

template <class T>
auto vector(Builder& builder, const Column<T>& column) {
  return builder.CreateVector(column.data(), column.size());
}

auto flat(Builder& builder, const Column<std::array<double, 6>>& rows) {
  return builder.CreateVector(rows.empty() ? nullptr : rows.data()->data(), 6 * rows.size());
}

void require_finite(double value, const char* name, std::uint64_t window) {
  if (!std::isfinite(value)) throw BadMessage(fmt::format("{} is {} in window {}", name, value, window));
}

void read_rows(const flatbuffers::Vector<double>* from, Column<std::array<double, 6>>& into, const Keeper& keeper,
               const char* name, std::uint64_t window) {
  const std::size_t size = from != nullptr ? from->size() : 0;
  if (size % 6 != 0) throw BadMessage(fmt::format("{} holds {} numbers, not six a block", name, size));
  if (size == 0) {
    into.clear();
    return;
  }
  take(from->Data(), size / 6, into, keeper);
  if (all_sound<Finite>(from)) return;
  for (std::size_t i = 0; i < size; ++i) {
    const double value = into[i / 6][i % 6];
    if (!std::isfinite(value)) {
      throw BadMessage(fmt::format("{} {} of block {} is {} in window {}", name, i % 6, i / 6, value, window));
    }
  }
}

}  // namespace

void encode(const Hello& m, Builder& builder) {
  begin(builder);
  const auto role = builder.CreateString(m.role);
  const auto build = builder.CreateString(m.build);
  const auto digest = builder.CreateString(m.scene_digest);
  const auto schedule = builder.CreateString(m.schedule);
  const auto units = builder.CreateString(m.units);
  const auto names = builder.CreateVectorOfStrings(m.block_names);
  const auto counts = builder.CreateVector(m.vertex_counts);
  const auto vertices = builder.CreateVector(m.vertices_m);
  finish(builder, buffer::Body::Hello,
         buffer::CreateHello(builder, m.protocol, role, build, digest, schedule, units, m.window_s, m.duration_s, names,
                             counts, vertices, m.first_window));
}

void encode(const Motion& m, Builder& builder) {
  begin(builder);
  const auto displacement = flat(builder, m.displacement);
  const auto velocity = flat(builder, m.velocity);
  finish(builder, buffer::Body::Motion,
         buffer::CreateMotion(builder, m.window, m.time_s, displacement, velocity, static_cast<std::uint8_t>(m.order)));
}

void encode(const Load& m, Builder& builder) {
  begin(builder);
  const auto block = vector(builder, m.block);
  const auto edge = vector(builder, m.edge);
  const auto s_from = vector(builder, m.s_from);
  const auto s_to = vector(builder, m.s_to);
  const auto p_from = vector(builder, m.pressure_from_pa);
  const auto p_to = vector(builder, m.pressure_to_pa);
  const auto added_mass = flat(builder, m.added_mass);
  finish(builder, buffer::Body::Load,
         buffer::CreateLoad(builder, m.window, m.time_s, m.upstream_level_m, m.downstream_level_m, block, edge, s_from,
                            s_to, p_from, p_to, m.breached, m.cracks_from, added_mass, m.holds_until_s));
}

void encode(const End& m, Builder& builder) {
  begin(builder);
  const auto reason = builder.CreateString(m.reason);
  finish(builder, buffer::Body::End, buffer::CreateEnd(builder, reason));
}

void encode(const Failure& m, Builder& builder) {
  begin(builder);
  const auto words = builder.CreateString(m.text);
  finish(builder, buffer::Body::Failure, buffer::CreateFailure(builder, words));
}

Kind verify(const void* data, std::size_t size) {
  std::uint64_t sum = 0;
  const std::size_t length = size - std::min(size, sizeof sum);
  if (length > 0) std::memcpy(&sum, static_cast<const std::uint8_t*>(data) + length, sizeof sum);
  if (length == 0 || sum != checksum(data, length)) {
    throw BadMessage(
        fmt::format("{} bytes that are damaged, or not of protocol {}: are both sides of one version of blockweir?",
                    size, protocol_version));
  }
  flatbuffers::Verifier verifier(static_cast<const std::uint8_t*>(data), length);
  if (!buffer::VerifyEnvelopeBuffer(verifier)) {
    throw BadMessage(fmt::format("{} bytes that are not a message of protocol {}", size, protocol_version));
  }
  const buffer::Envelope* envelope = buffer::GetEnvelope(data);
  if (envelope->body() != nullptr) {
    switch (envelope->body_type()) {
      case buffer::Body::Hello:
        return Kind::hello;
      case buffer::Body::Motion:
        return Kind::motion;
      case buffer::Body::Load:
        return Kind::load;
      case buffer::Body::End:
        return Kind::end;
      case buffer::Body::Failure:
        return Kind::failure;
      default:
        break;
    }
  }
  throw BadMessage(fmt::format("a message of {} bytes without a known body", size));
}

void decode(const void* data, Hello& m) {
  const auto& b = body<buffer::Hello>(data);
  m.protocol = b.protocol();
  m.role = text(b.role());
  m.build = text(b.build());
  m.scene_digest = text(b.scene_digest());
  m.schedule = text(b.schedule());
  m.units = text(b.units());
  m.window_s = b.window_s();
  m.duration_s = b.duration_s();
  m.block_names.clear();
  if (b.block_names() != nullptr) {
    for (const auto* name : *b.block_names()) m.block_names.push_back(text(name));
  }
  copy(b.vertex_counts(), m.vertex_counts);
  copy(b.vertices_m(), m.vertices_m);
  m.first_window = b.first_window();
}

void decode(const void* data, Motion& m, const Keeper& keeper) {
  const auto& b = body<buffer::Motion>(data);
  m.window = b.window();
  m.time_s = b.time_s();
  require_finite(m.time_s, "time", m.window);
  if (b.order() > static_cast<std::uint8_t>(Order::save)) {
    throw BadMessage(fmt::format("order {} in window {}", b.order(), m.window));
  }
  m.order = static_cast<Order>(b.order());
  read_rows(b.displacement(), m.displacement, keeper, "displacement", m.window);
  read_rows(b.velocity(), m.velocity, keeper, "velocity", m.window);
  if (m.displacement.size() != m.velocity.size()) {
    throw BadMessage(fmt::format("{} displacements and {} velocities", m.displacement.size(), m.velocity.size()));
  }
}

void decode(const void* data, Load& m, const Keeper& keeper) {
  const auto& b = body<buffer::Load>(data);
  m.window = b.window();
  m.time_s = b.time_s();
  m.upstream_level_m = b.upstream_level_m();
  m.downstream_level_m = b.downstream_level_m();
  require_finite(m.time_s, "time", m.window);
  m.holds_until_s = b.holds_until_s();
  if (std::isnan(m.holds_until_s)) require_finite(m.holds_until_s, "time that the pressures hold", m.window);
  if (std::isinf(m.upstream_level_m)) require_finite(m.upstream_level_m, "upstream level", m.window);
  if (std::isinf(m.downstream_level_m)) require_finite(m.downstream_level_m, "downstream level", m.window);
  take(b.block(), m.block, keeper);
  take(b.edge(), m.edge, keeper);
  take(b.s_from(), m.s_from, keeper);
  take(b.s_to(), m.s_to, keeper);
  take(b.pressure_from_pa(), m.pressure_from_pa, keeper);
  take(b.pressure_to_pa(), m.pressure_to_pa, keeper);
  m.breached = b.breached();
  m.cracks_from = b.cracks_from();
  read_rows(b.added_mass(), m.added_mass, keeper, "added mass", m.window);
  const std::size_t n = m.block.size();
  for (const std::size_t size :
       {m.edge.size(), m.s_from.size(), m.s_to.size(), m.pressure_from_pa.size(), m.pressure_to_pa.size()}) {
    if (size != n) throw BadMessage(fmt::format("columns of {} and {} panels in window {}", n, size, m.window));
  }
  if (m.cracks_from > n)
    throw BadMessage(fmt::format("cracks from panel {} of {} in window {}", m.cracks_from, n, m.window));
  if (all_sound<Fraction>(b.s_from()) && all_sound<Fraction>(b.s_to()) && all_sound<Finite>(b.pressure_from_pa()) &&
      all_sound<Finite>(b.pressure_to_pa())) {
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto panel = [&](const char* what, double value) {
      return fmt::format("{} of panel {} (block {}, edge {}) is {} in window {}", what, i, m.block[i], m.edge[i], value,
                         m.window);
    };
    for (const double p : {m.pressure_from_pa[i], m.pressure_to_pa[i]}) {
      if (!std::isfinite(p)) throw BadMessage(panel("pressure", p));
    }
    for (const double s : {m.s_from[i], m.s_to[i]}) {
      if (!(s >= 0 && s <= 1)) throw BadMessage(panel("end", s));
    }
  }
}

void decode(const void* data, End& m) {
  m.reason = text(body<buffer::End>(data).reason());
}

void decode(const void* data, Failure& m) {
  m.text = text(body<buffer::Failure>(data).text());
}

}  // namespace blockweir::wire
