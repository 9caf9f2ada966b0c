// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/kit/fluid_report.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "bridge/results/peak_memory.hpp"
#include "bridge/results/result_file.hpp"

namespace blockweir::kit {

void FluidReport::write(const channel::Channel& line) const {
  const char* const file = std::getenv("BLOCKWEIR_REPORT");
  if (file == nullptr || *file == '\0') return;
  results::replace_file(
      file, fmt::format("{{\"seconds\": {{\"step\": {}, \"wait\": {}, \"pack\": {}, \"wire\": {}}}, "
                        "\"counts\": {{\"answers\": {}}}, \"peak_memory_mb\": {}}}\n",
                        step_s_, line.waited_s(), line.packed_s(), line.wire_s(), answers_, results::peak_memory_mb()));
}

}  // namespace blockweir::kit
