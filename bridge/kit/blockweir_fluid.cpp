// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface on the line that blockweir's own fluids use. C++17.
#include "bridge/kit/blockweir_fluid.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>

#include "bridge/channel/channel.hpp"
#include "bridge/kit/fluid_report.hpp"
#include "bridge/kit/outlines.hpp"

namespace {

namespace channel = blockweir::channel;
namespace wire = blockweir::wire;
using blockweir::kit::Outlines;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

double timeout_s() {
  constexpr double usual_s = 60;
  const std::string text = environment("BLOCKWEIR_TIMEOUT_S");
  const double stated = std::strtod(text.c_str(), nullptr);
  return stated > 0 && std::isfinite(stated) ? stated : usual_s;
}

/// What cannot be in a load of such blocks; empty where all can.
std::string fault_of(const blockweir_load& load, const Outlines& blocks) {
  const auto number = [](std::size_t i, const char* what, double value) {
    return fmt::format("{} of panel {} is {}", what, i, value);
  };
  if (load.panels > 0 && (load.block == nullptr || load.edge == nullptr || load.s_from == nullptr ||
                          load.s_to == nullptr || load.pressure_from_pa == nullptr || load.pressure_to_pa == nullptr)) {
    return fmt::format("a load of {} panels with a column that is NULL", load.panels);
  }
  if (load.cracks_from > load.panels) return fmt::format("cracks from panel {} of {}", load.cracks_from, load.panels);
  if (std::isinf(load.upstream_level_m) || std::isinf(load.downstream_level_m)) return "a level that is infinite";
  for (std::size_t i = 0; load.added_mass != nullptr && i < 6 * blocks.size(); ++i) {
    if (!std::isfinite(load.added_mass[i]))
      return fmt::format("added mass {} of block {} is {}", i % 6, i / 6, load.added_mass[i]);
  }
  for (std::size_t i = 0; i < load.panels; ++i) {
    if (load.block[i] >= blocks.size()) {
      return fmt::format("panel {} is of block {}; the scene has {}", i, load.block[i], blocks.size());
    }
    if (const std::size_t edges = blocks.vertices(load.block[i]); load.edge[i] >= edges) {
      return fmt::format("panel {} is of edge {} of block {}, which has {}", i, load.edge[i], load.block[i], edges);
    }
    for (const auto& [what, value] : {std::pair{"s_from", load.s_from[i]}, {"s_to", load.s_to[i]}}) {
      if (!(value >= 0 && value <= 1)) return number(i, what, value) + ", not from 0 to 1";
    }
    if (load.s_from[i] > load.s_to[i]) return number(i, "s_to", load.s_to[i]) + ", before its s_from";
    for (const double pressure : {load.pressure_from_pa[i], load.pressure_to_pa[i]}) {
      if (!std::isfinite(pressure)) return number(i, "pressure", pressure);
    }
  }
  return "";
}

}  // namespace

struct blockweir_fluid {
  std::optional<channel::Channel> line;
  wire::Hello hello;
  Outlines blocks;
  wire::Motion motion;
  wire::Load load;
  blockweir::kit::FluidReport report;
  std::string error;
  std::string checkpoint;
  bool remembers = false;
  bool saved = false;  ///< the state before `motion`, which is still to be handed out
  bool due = false;    ///< a motion has been received and not answered
  bool ended = false;  ///< the run is complete
  std::uint64_t window = 0;

  /// Does `work` unless there was an error before; an exception becomes the error.
  template <class Work>
  int attempt(Work work) noexcept {
    if (!error.empty()) return BLOCKWEIR_ERROR;
    try {
      return work();
    } catch (const std::exception& failure) {
      error = failure.what();
      return BLOCKWEIR_ERROR;
    }
  }
  /// The caller's mistake, of which the solid is told.
  int refuse(const std::string& why) {
    if (line) line->send(wire::Failure{why});
    throw std::invalid_argument(why);
  }
};

extern "C" {

blockweir_load blockweir_dry(void) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  blockweir_load load{};
  load.upstream_level_m = load.downstream_level_m = load.holds_until_s = none;
  return load;
}

blockweir_fluid* blockweir_open(const char* role, const char* endpoint) {
  auto* fluid = new (std::nothrow) blockweir_fluid;
  if (fluid == nullptr) return nullptr;
  fluid->attempt([&] {
    const std::string where = endpoint != nullptr ? endpoint : environment("BLOCKWEIR_ENDPOINT");
    if (where.empty()) {
      throw std::invalid_argument("no endpoint: set BLOCKWEIR_ENDPOINT, or let \"blockweir run\" start this program");
    }
    channel::Options options{channel::Side::connects, where, "solid process", timeout_s(), timeout_s()};
    fluid->line.emplace(options);
    fluid->hello = fluid->line->agree(role != nullptr && *role != '\0' ? role : "external", BLOCKWEIR_VERSION);
    fluid->window = fluid->hello.first_window;
    fluid->blocks = Outlines(fluid->hello);
    return BLOCKWEIR_OK;
  });
  return fluid;
}

const char* blockweir_error(const blockweir_fluid* fluid) {
  return fluid != nullptr ? fluid->error.c_str() : "memory is short";
}

size_t blockweir_blocks(const blockweir_fluid* fluid) {
  return fluid->blocks.size();
}
const char* blockweir_block_name(const blockweir_fluid* fluid, size_t block) {
  return block < fluid->blocks.size() ? fluid->hello.block_names[block].c_str() : "";
}
size_t blockweir_vertices(const blockweir_fluid* fluid, size_t block) {
  return block < fluid->blocks.size() ? fluid->blocks.vertices(block) : 0;
}
const double* blockweir_outline(const blockweir_fluid* fluid, size_t block) {
  return block < fluid->blocks.size() ? fluid->blocks.outline(block) : nullptr;
}
double blockweir_window_s(const blockweir_fluid* fluid) {
  return fluid->hello.window_s;
}
double blockweir_duration_s(const blockweir_fluid* fluid) {
  return fluid->hello.duration_s;
}
uint64_t blockweir_first_window(const blockweir_fluid* fluid) {
  return fluid->hello.first_window;
}

const char* blockweir_checkpoint(blockweir_fluid* fluid, uint64_t window) {
  fluid->attempt([&] {
    const std::filesystem::path folder = std::filesystem::path(environment("BLOCKWEIR_FOLDER")) / "checkpoint";
    std::filesystem::create_directories(folder);
    fluid->checkpoint = (folder / fmt::format("external-{}", window)).string();
    return BLOCKWEIR_OK;
  });
  return fluid->checkpoint.c_str();
}

int blockweir_remembers(blockweir_fluid* fluid) {
  return fluid->attempt([&] { return fluid->remembers = true, BLOCKWEIR_OK; });
}

int blockweir_receive(blockweir_fluid* fluid, blockweir_motion* into) {
  return fluid->attempt([&] {
    if (into == nullptr) return fluid->refuse("blockweir_receive: motion is NULL");
    if (fluid->due && !fluid->saved) return fluid->refuse("blockweir_receive before the last motion was answered");
    wire::Motion& motion = fluid->motion;
    const bool again = std::exchange(fluid->saved, false);
    try {
      do {
        if (again) break;
        fluid->line->receive(motion);
        if (motion.window != fluid->window) {
          return fluid->refuse(
              fmt::format("the solid sent window {} where window {} was due", motion.window, fluid->window));
        }
        ++fluid->window;
      } while (motion.order == wire::Order::save && !fluid->remembers);
    } catch (const channel::PeerEnded&) {
      fluid->ended = true;
      fluid->report.write(*fluid->line);
      return static_cast<int>(BLOCKWEIR_END);
    }
    *into = {motion.window, motion.time_s, motion.displacement.data()->data(), motion.velocity.data()->data()};
    fluid->due = motion.order != wire::Order::save;
    fluid->saved = !again && fluid->due && fluid->remembers && motion.order == wire::Order::save_and_compute;
    if (fluid->saved || !fluid->due) return static_cast<int>(BLOCKWEIR_SAVE);
    fluid->report.begin_step();
    return static_cast<int>(BLOCKWEIR_MOTION);
  });
}

int blockweir_place(const blockweir_fluid* fluid, size_t block, double* xy) {
  if (block >= fluid->motion.displacement.size() || xy == nullptr) return BLOCKWEIR_ERROR;
  fluid->blocks.place(block, fluid->motion.displacement[block], xy);
  return BLOCKWEIR_OK;
}

int blockweir_send(blockweir_fluid* fluid, const blockweir_load* load) {
  return fluid->attempt([&] {
    if (load == nullptr) return fluid->refuse("blockweir_send: load is NULL");
    if (!fluid->due || fluid->saved) return fluid->refuse("blockweir_send without a motion to answer");
    if (const std::string fault = fault_of(*load, fluid->blocks); !fault.empty()) {
      return fluid->refuse(fmt::format("{}, in window {}", fault, fluid->motion.window));
    }
    wire::Load& out = fluid->load;
    const auto copy = [n = load->panels](auto& column, const auto* from) { column.own().assign(from, from + n); };
    copy(out.block, load->block);
    copy(out.edge, load->edge);
    copy(out.s_from, load->s_from);
    copy(out.s_to, load->s_to);
    copy(out.pressure_from_pa, load->pressure_from_pa);
    copy(out.pressure_to_pa, load->pressure_to_pa);
    out.added_mass.clear();
    for (std::size_t b = 0; load->added_mass != nullptr && b < fluid->blocks.size(); ++b) {
      std::array<double, 6> row{};
      std::copy_n(load->added_mass + 6 * b, row.size(), row.begin());
      out.added_mass.push_back(row);
    }
    out.window = fluid->motion.window;
    out.time_s = fluid->motion.time_s;
    out.upstream_level_m = load->upstream_level_m;
    out.downstream_level_m = load->downstream_level_m;
    out.holds_until_s = std::isnan(load->holds_until_s) ? out.time_s : load->holds_until_s;
    out.cracks_from = static_cast<std::uint32_t>(load->cracks_from);
    out.breached = load->breached != 0;
    fluid->report.end_step();
    fluid->line->send(out);
    fluid->due = false;
    return static_cast<int>(BLOCKWEIR_OK);
  });
}

int blockweir_progress(blockweir_fluid* fluid, const char* text) {
  return fluid->attempt([&] {
    fluid->line->send(wire::Progress{text != nullptr ? text : ""});
    return static_cast<int>(BLOCKWEIR_OK);
  });
}

int blockweir_fail(blockweir_fluid* fluid, const char* text) {
  return fluid->attempt([&] { return fluid->refuse(text != nullptr ? text : "the fluid cannot go on"); });
}

int blockweir_close(blockweir_fluid* fluid) {
  if (fluid == nullptr) return 1;
  const bool well = fluid->ended && fluid->error.empty();
  delete fluid;
  return well ? 0 : 1;
}

}  // extern "C"
