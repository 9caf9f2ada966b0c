// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/scene_text.hpp"

#include <fmt/format.h>

#include <array>

namespace blockweir::independent {
namespace {

std::string point(const Vec& p) {
  return fmt::format("[{:.17g}, {:.17g}]", p.x(), p.y());
}

std::string keys(const Law& law) {
  constexpr std::array names = {"none", "triangular", "full", "drained", "cracked"};
  const std::string drain =
      law.uplift != Uplift::drained
          ? ""
          : fmt::format("drain_m = {:.17g}\ndrain_efficiency = {:.17g}\n", law.drain_m, law.drain_efficiency);
  return fmt::format(
             "friction_angle_deg = {:.17g}\ncohesion_pa = {:.17g}\ntension_strength_pa = {:.17g}\nuplift = \"{}\"\n",
             law.friction_deg, law.cohesion_pa, law.tension_pa, names[static_cast<std::size_t>(law.uplift)]) +
         drain;
}

std::string text(const Body& body) {
  std::string outline;
  for (const Vec& p : body.outline_m) outline += (outline.empty() ? "" : ", ") + point(p);
  return fmt::format("\n[[block]]\nname = \"{}\"\nmaterial = \"concrete\"\nfixed = {}\nvertices_m = [{}]\n", body.name,
                     body.fixed, outline);
}

std::string text(const Joint& joint) {
  return fmt::format("\n[[joints]]\nname = \"{}\"\nbetween = [\"{}\", \"{}\"]\n{}", joint.name, joint.below,
                     joint.above, keys(joint.law));
}

std::string text(const Bolt& bolt) {
  return fmt::format(
      "\n[[bolt]]\nname = \"{}\"\nfrom_block = \"{}\"\nfrom_m = {}\nto_m = {}\nstiffness_n_per_m2 = {:.17g}\n"
      "prestress_n_per_m = {:.17g}\nyield_n_per_m = {:.17g}\n",
      bolt.name, bolt.body, point(bolt.from_m), point(bolt.to_m), bolt.stiffness_n_per_m2, bolt.prestress_n_per_m,
      bolt.yield_n_per_m);
}

}  // namespace

std::string scene_text(const Structure& structure, const Filling& filling) {
  std::string scene = fmt::format(
      "[analysis]\nkind = \"{}\"\nintegrator = \"{}\"\nrigid = \"{}\"\nduration_s = {:.17g}\nstep_s = {:.17g}\n"
      "stop_at_failure = true\n\n[contact]\nformulation = \"{}\"\n\n[material.concrete]\nyoungs_modulus_pa = {:.17g}\n"
      "poissons_ratio = 0.2\ndensity_kg_per_m3 = {:.17g}\n\n[joint]\n{}",
      filling.kind, filling.integrator, filling.rigid, filling.duration_s, filling.step_s, filling.formulation,
      filling.youngs_modulus_pa, structure.density_kg_per_m3, keys(structure.others));
  for (const Body& body : structure.bodies) scene += text(body);
  for (const Joint& joint : structure.joints) scene += text(joint);
  for (const Bolt& bolt : structure.bolts) scene += text(bolt);
  const char* reservoir = structure.reservoir_right ? "downstream_level_m" : "upstream_level_m";
  const char* tail = structure.reservoir_right ? "upstream_level_m" : "downstream_level_m";
  std::string table;
  for (const auto& [time, level] : filling.levels) {
    table += fmt::format("{}[{:.17g}, {:.17g}]", table.empty() ? "" : ", ", time, level);
  }
  scene += fmt::format("\n[water]\nmay_overtop = true\n{} = {{ table = [{}] }}\n", reservoir, table);
  if (structure.tail_level_m > none_m) scene += fmt::format("{} = {:.17g}\n", tail, structure.tail_level_m);
  return scene + fmt::format("\n[output]\nframe_every_s = {0:.17g}\nhistory_every_s = {0:.17g}\n", filling.duration_s);
}

}  // namespace blockweir::independent
