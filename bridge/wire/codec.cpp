// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/wire/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bridge/wire/checksum.hpp"
#include "bridge/wire/column_codec.hpp"
#include "bridge/wire/coupled_pairs.hpp"
#include "bridge/wire/face_points.hpp"
#include "bridge/wire/messages_generated.h"

namespace blockweir::wire {
namespace {

using Builder = flatbuffers::FlatBufferBuilder;

/// Last in a frame.
struct Trailer {
  std::uint64_t columns = 0;  ///< bytes of columns before it, whose checksums the table tells
  std::uint64_t sum = 0;      ///< of the bytes before these, and of their number
};

/// A buffer is filled from its end: what comes first stands last.
void begin(Builder& builder) {
  builder.Clear();
  builder.PushElement(std::uint64_t{0});
  builder.PushElement(std::uint64_t{0});
}

template <class Offset>
void finish(Builder& builder, buffer::Body kind, Offset body, std::size_t columns = 0) {
  buffer::FinishEnvelopeBuffer(builder, buffer::CreateEnvelope(builder, kind, body.Union()));
  std::uint8_t* end = builder.GetBufferPointer() + builder.GetSize() - sizeof(Trailer);
  const std::size_t table = builder.GetSize() - sizeof(Trailer) - columns;
  const Trailer trailer{columns, checksum(builder.GetBufferPointer(), table, columns)};
  std::memcpy(end, &trailer, sizeof trailer);
}

Trailer trailer_of(const Part& frame) {
  Trailer trailer;
  std::memcpy(&trailer, static_cast<const std::uint8_t*>(frame.data) + frame.size - sizeof trailer, sizeof trailer);
  return trailer;
}

template <class Message>
ColumnReader columns_of(const Message& message, const Part& frame, const NextPart& next) {
  return {message.columns(),
          static_cast<const std::uint8_t*>(frame.data) + frame.size - sizeof(Trailer),
          trailer_of(frame).columns,
          message.window(),
          frame.keeper,
          next};
}

template <class Body>
const Body& body(const Part& frame) {
  return *buffer::GetEnvelope(frame.data)->template body_as<Body>();
}

std::string text(const flatbuffers::String* from) {
  return from != nullptr ? from->str() : std::string();
}

void require_finite(double value, const char* name, std::uint64_t window) {
  if (!std::isfinite(value)) throw BadMessage(fmt::format("{} is {} in window {}", name, value, window));
}

/// Names the number that is none.
void refuse_rows(const Column<std::array<double, 6>>& rows, const char* name, std::uint64_t window) {
  for (std::size_t i = 0; i < 6 * rows.size(); ++i) {
    const double value = rows[i / 6][i % 6];
    if (!std::isfinite(value)) {
      throw BadMessage(fmt::format("{} {} of block {} is {} in window {}", name, i % 6, i / 6, value, window));
    }
  }
}

/// Names the panel whose pressures or ends cannot be.
void refuse_panels(const Load& m) {
  for (std::size_t i = 0; i < m.block.size(); ++i) {
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
    if (m.s_from[i] > m.s_to[i]) {
      throw BadMessage(fmt::format("{}, before its s_from of {}", panel("s_to", m.s_to[i]), m.s_from[i]));
    }
  }
}

/// Does no panel run backwards? Its water would pull.
bool forwards(const Column<double>& from, const Column<double>& to) {
  const double* s_from = from.data();
  const double* s_to = to.data();
  bool backwards = false;
  for (std::size_t i = 0; i < from.size(); ++i) backwards |= s_from[i] > s_to[i];
  return !backwards;
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

void encode(const Motion& m, Builder& builder, std::vector<Part>& parts) {
  begin(builder);
  ColumnWriter write(builder, parts);
  write(m.displacement);
  write(m.velocity);
  write_face_points(write, m);
  const std::size_t columns = builder.GetSize() - sizeof(Trailer);
  finish(builder, buffer::Body::Motion,
         buffer::CreateMotion(builder, m.window, m.time_s, static_cast<std::uint8_t>(m.order), write.told()), columns);
}

void encode(const Load& m, Builder& builder, std::vector<Part>& parts) {
  begin(builder);
  ColumnWriter write(builder, parts);
  write(m.s_from);
  write(m.s_to);
  write(m.pressure_from_pa);
  write(m.pressure_to_pa);
  write(m.added_mass);
  write(m.block);  // after those that are aligned to more
  write(m.edge);
  write_pairs(write, m);
  const std::size_t columns = builder.GetSize() - sizeof(Trailer);
  finish(builder, buffer::Body::Load,
         buffer::CreateLoad(builder, m.window, m.time_s, m.upstream_level_m, m.downstream_level_m, m.breached,
                            m.cracks_from, m.holds_until_s, write.told()),
         columns);
}

void encode(const Farewell& m, Builder& builder) {
  begin(builder);
  const auto reason = builder.CreateString(m.reason);
  finish(builder, buffer::Body::Farewell, buffer::CreateFarewell(builder, reason));
}

void encode(const Failure& m, Builder& builder) {
  begin(builder);
  const auto words = builder.CreateString(m.text);
  finish(builder, buffer::Body::Failure, buffer::CreateFailure(builder, words));
}

void encode(const Progress& m, Builder& builder) {
  begin(builder);
  const auto words = builder.CreateString(m.text);
  finish(builder, buffer::Body::Progress, buffer::CreateProgress(builder, words));
}

Kind verify(const Part& frame) {
  const Trailer trailer = frame.size > sizeof(Trailer) ? trailer_of(frame) : Trailer();
  const std::size_t length = frame.size - std::min(frame.size, sizeof trailer);
  const std::size_t table = length - std::min<std::uint64_t>(length, trailer.columns);
  if (table == 0 || trailer.sum != checksum(frame.data, table, trailer.columns)) {
    throw BadMessage(
        fmt::format("{} bytes that are damaged, or not of protocol {}: are both sides of one version of blockweir?",
                    frame.size, protocol_version));
  }
  flatbuffers::Verifier verifier(static_cast<const std::uint8_t*>(frame.data), table);
  if (!buffer::VerifyEnvelopeBuffer(verifier)) {
    throw BadMessage(fmt::format("{} bytes that are not a message of protocol {}", frame.size, protocol_version));
  }
  const buffer::Envelope* envelope = buffer::GetEnvelope(frame.data);
  if (envelope->body() != nullptr) {
    switch (envelope->body_type()) {
      case buffer::Body::Hello:
        return Kind::hello;
      case buffer::Body::Motion:
        return Kind::motion;
      case buffer::Body::Load:
        return Kind::load;
      case buffer::Body::Farewell:
        return Kind::end;
      case buffer::Body::Failure:
        return Kind::failure;
      case buffer::Body::Progress:
        return Kind::progress;
      default:
        break;
    }
  }
  throw BadMessage(fmt::format("a message of {} bytes without a known body", frame.size));
}

void decode(const Part& frame, Hello& m) {
  const auto& b = body<buffer::Hello>(frame);
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

void decode(const Part& frame, Motion& m, const NextPart& next) {
  const auto& b = body<buffer::Motion>(frame);
  m.window = b.window();
  m.time_s = b.time_s();
  require_finite(m.time_s, "time", m.window);
  if (b.order() > static_cast<std::uint8_t>(Order::save)) {
    throw BadMessage(fmt::format("order {} in window {}", b.order(), m.window));
  }
  m.order = static_cast<Order>(b.order());
  ColumnReader columns = columns_of(b, frame, next);
  const char* name = "displacement";
  if (!columns.read<Finite>(m.displacement, name)) refuse_rows(m.displacement, name, m.window);
  name = "velocity";
  if (!columns.read<Finite>(m.velocity, name)) refuse_rows(m.velocity, name, m.window);
  read_face_points(columns, m);
  columns.end();
  if (m.displacement.size() != m.velocity.size()) {
    throw BadMessage(fmt::format("{} displacements and {} velocities", m.displacement.size(), m.velocity.size()));
  }
}

void decode(const Part& frame, Load& m, const NextPart& next) {
  const auto& b = body<buffer::Load>(frame);
  m.window = b.window();
  m.time_s = b.time_s();
  m.upstream_level_m = b.upstream_level_m();
  m.downstream_level_m = b.downstream_level_m();
  require_finite(m.time_s, "time", m.window);
  m.holds_until_s = b.holds_until_s();
  if (std::isnan(m.holds_until_s)) require_finite(m.holds_until_s, "time that the pressures hold", m.window);
  if (std::isinf(m.upstream_level_m)) require_finite(m.upstream_level_m, "upstream level", m.window);
  if (std::isinf(m.downstream_level_m)) require_finite(m.downstream_level_m, "downstream level", m.window);
  m.breached = b.breached();
  m.cracks_from = b.cracks_from();
  ColumnReader columns = columns_of(b, frame, next);
  bool sound = true;
  sound &= columns.read<Fraction>(m.s_from, "s_from");
  sound &= columns.read<Fraction>(m.s_to, "s_to");
  sound &= columns.read<Finite>(m.pressure_from_pa, "pressure_from_pa");
  sound &= columns.read<Finite>(m.pressure_to_pa, "pressure_to_pa");
  if (!columns.read<Finite>(m.added_mass, "added mass")) {
    refuse_rows(m.added_mass, "added mass", m.window);
  }
  sound &= columns.read<Any>(m.block, "block");
  sound &= columns.read<Any>(m.edge, "edge");
  read_pairs(columns, m);
  columns.end();
  const std::size_t n = m.block.size();
  for (const std::size_t size :
       {m.edge.size(), m.s_from.size(), m.s_to.size(), m.pressure_from_pa.size(), m.pressure_to_pa.size()}) {
    if (size != n) throw BadMessage(fmt::format("columns of {} and {} panels in window {}", n, size, m.window));
  }
  if (m.cracks_from > n)
    throw BadMessage(fmt::format("cracks from panel {} of {} in window {}", m.cracks_from, n, m.window));
  if (!sound || !forwards(m.s_from, m.s_to)) refuse_panels(m);
}

void decode(const Part& frame, Farewell& m) {
  m.reason = text(body<buffer::Farewell>(frame).reason());
}

void decode(const Part& frame, Failure& m) {
  m.text = text(body<buffer::Failure>(frame).text());
}

void decode(const Part& frame, Progress& m) {
  m.text = text(body<buffer::Progress>(frame).text());
}

}  // namespace blockweir::wire
