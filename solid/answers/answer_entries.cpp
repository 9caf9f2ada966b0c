// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/answer_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

nlohmann::json mechanism_json(const limit::LimitAnalysis& structure, const limit::Twists& mechanism) {
  const limit::MechanismDescription words = limit::words_of(structure, mechanism);
  nlohmann::json moving = nlohmann::json::array();
  for (const std::size_t b : words.moving) {
    moving.push_back({{"name", structure.scene().blocks[b].name},
                      {"velocity_x", mechanism[b].x()},
                      {"velocity_y", mechanism[b].y()},
                      {"spin_per_m", mechanism[b].z()}});
  }
  nlohmann::json answer = {{"text", words.text}, {"mode", words.mode}, {"joints", words.joints}, {"blocks", moving}};
  if (words.dilates) answer["caption"] = "joints open by tan(phi) times their slip, which lifts what slides";
  return answer;
}

void announce_limit_analysis(const limit::LimitAnalysis& structure) {
  constexpr std::size_t many = 300;
  if (structure.faces().size() <= many) return;
  fmt::print(stderr, "limit analysis: {} blocks, {} faces between them; then the blocks' own search\n",
             structure.scene().blocks.size(), structure.faces().size());
  std::fflush(stderr);
}

void add_note(const char* note, nlohmann::json& answer) {
  const std::string others = answer.value("limit_analysis_note", "");
  answer["limit_analysis_note"] = others.empty() ? note : others + "; " + note;
}

void add_what_limit_analysis_takes(const limit::LimitAnalysis& structure, nlohmann::json& answer) {
  answer["upper_bound"] = !structure.is_exact();
  if (structure.holds_any_force()) {
    add_note(anchors_note, answer);
  } else if (yields_above_prestress(structure.scene())) {
    add_note(yields_note, answer);
  }
}

bool yields_above_prestress(const scene::Scene& scene) {
  return std::any_of(scene.bolts.begin(), scene.bolts.end(), [](const scene::Bolt& bolt) {
    constexpr double matters = 1.01;
    return bolt.yield_n_per_m && *bolt.yield_n_per_m > matters * bolt.prestress_n_per_m;
  });
}

void add_water_in_an_earthquake(const scene::Scene& scene, nlohmann::json& answer) {
  if (scene.water.is_shaken()) {
    answer["added_water_pressure"] = scene::name_of(scene.water.added_water);
  }
}

void add_motion_left_out(const scene::Scene& scene, nlohmann::json& answer) {
  const double end_s = scene.analysis.duration_s;
  if (scene.base_motion) {
    answer["warnings"].push_back(fmt::format(
        "[base_motion] is left out of this static answer, but for the acceleration at the run's end, {:.3g} "
        "and {:.3g} m/s2; \"blockweir run\" shakes the structure, [earthquake] states a pseudo-static case",
        scene.base_motion->acceleration_x_m_per_s2.at(end_s) + 0.0,
        scene.base_motion->acceleration_y_m_per_s2.at(end_s) + 0.0));
  }
  if (scene.fluid == scene::FluidModel::openfoam && scene.openfoam.wave) {
    const bool solitary = scene.openfoam.wave->kind == scene::WaveKind::solitary;
    answer["warnings"].push_back(fmt::format(
        "[fluid.wave] is left out of this static answer: {} of {:.3g} m in height {} not in the water, which is still "
        "at the levels of [water]; \"blockweir run\" lets {} come and has the lowest factors then",
        solitary ? "the solitary wave" : "the waves", scene.openfoam.wave->height_m, solitary ? "is" : "are",
        solitary ? "it" : "them"));
  }
}

void add_moved_supports(const scene::Scene& scene, nlohmann::json& answer) {
  const double end_s = scene.analysis.duration_s;
  const scene::Support* farthest = nullptr;
  double most_m = 0;
  for (const scene::Support& support : scene.supports) {
    const auto way = [end_s](const auto& course) { return course ? course->at(end_s) : 0; };
    const double m = std::hypot(way(support.displacement_x_m), way(support.displacement_y_m));
    if (m <= most_m) continue;
    most_m = m;
    farthest = &support;
  }
  if (farthest == nullptr) return;
  answer["warnings"].push_back(fmt::format(
      "the blocks' answer has each [[support]] where it stands at the run's end, {:.6g} s, led there slowly: that of "
      "block \"{}\" at ({:.6g}, {:.6g}) by {:.3g} m; limit analysis has the structure as drawn",
      end_s, scene.blocks[at(farthest->block)].name, farthest->point_m.x(), farthest->point_m.y(), most_m));
}

bool has_bonds(const scene::Scene& scene) {
  return scene.default_joint.weakens() ||
         std::any_of(scene.joints.begin(), scene.joints.end(), [](const auto& joint) { return joint.law.weakens(); });
}

bool strains(const scene::Scene& scene) {
  return scene.analysis.rigid != scene::Rigid::all &&
         std::any_of(scene.blocks.begin(), scene.blocks.end(),
                     [](const scene::Block& block) { return !block.fixed && !block.rigid; });
}

scene::Scene with_rigid_blocks(scene::Scene scene) {
  scene.analysis.rigid = scene::Rigid::all;
  for (scene::Block& block : scene.blocks) block.mesh_size_m = 0;
  return scene;
}

}  // namespace blockweir::solid
