// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/require_fluid.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "bridge/scene/fluid_models.hpp"

namespace blockweir::process {
namespace {

std::string other_program(scene::FluidModel model) {
  const char* const program = scene::fluid_entry(model).program;
  return program != nullptr ? fmt::format(", or start {} in its place", program) : "";
}

}  // namespace

void require_fluid(const scene::Scene& scene, scene::FluidModel model) {
  if (scene.fluid == model) return;
  throw std::invalid_argument(
      fmt::format("[fluid] model: found \"{}\"; expected \"{}\", which is what this program computes; set it{}",
                  scene::fluid_entry(scene.fluid).key, scene::fluid_entry(model).key, other_program(scene.fluid)));
}

}  // namespace blockweir::process
