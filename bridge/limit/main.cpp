// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-limit: at which level, and by which factor on strength, the blocks of a scene fail, and in which modes they
// swing, without a run.
#include <iostream>
#include <optional>

#include "bridge/process/answers.hpp"
#include "bridge/process/program.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/loose_blocks.hpp"
#include "bridge/scene/read/read.hpp"

namespace {

using namespace blockweir;
using nlohmann::json;

std::unique_ptr<schedule::FluidSide> still_water(const scene::Scene& scene, const std::filesystem::path& folder) {
  return scene.fluid == scene::FluidModel::reservoir ? reservoir::make(scene, folder)
                                                     : hydrostatic::make(scene, folder);
}

/// Of one line of settings, a list of "key=value".
json capacity_of(const std::string& scene, const std::string& line, process::Capacity by) {
  try {
    scene::Scene sample = scene::read(scene, json::parse(line).get<std::vector<std::string>>()).scene;
    scene::hold_loose_blocks(sample);
    return process::capacity_answer(sample, still_water, by);
  } catch (const scene::SceneError& error) {
    return {{"outcome", "refused"}, {"trouble", error.what()}};
  } catch (const std::invalid_argument& error) {
    return {{"outcome", "refused"}, {"trouble", error.what()}};
  } catch (const std::exception& error) {
    return {{"outcome", "stopped"}, {"trouble", error.what()}};
  }
}

/// Answers lines of settings on standard input by lines on standard output, until there are no more.
int answer_lines(const std::string& scene, process::Capacity by) {
  for (std::string line; std::getline(std::cin, line);) std::cout << capacity_of(scene, line, by).dump() << std::endl;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr auto required = process::ProgramOption::Use::required;
  std::string question;
  std::string scene;
  std::string answer;
  std::optional<double> moment_s;
  const process::Program program{
      "blockweir-limit",
      "at which level, and by which factor on strength, a scene fails",
      {{{"question",
         &question,
         "level: at which it fails; safety: factor of safety; margin: factor at the end of a run; modes: natural "
         "frequencies; water: pressures; capacity, static-capacity: the level of each line of settings on standard "
         "input, by limit analysis or by the blocks",
         required,
         {"level", "safety", "margin", "modes", "water", "capacity", "static-capacity"}},
        {"scene", &scene, "scene file or case folder", required},
        {"--answer", &answer, "file for the answer (JSON)"},
        {"--moment", &moment_s, "time whose loads and levels count, s (default: the run's end)"}}}};
  return process::run_program(argc, argv, program, [&] {
    if (question == "capacity") return answer_lines(scene, process::Capacity::limit);
    if (question == "static-capacity") return answer_lines(scene, process::Capacity::statics);
    if (answer.empty()) throw std::invalid_argument("--answer is required: the file for the answer (JSON)");
    scene::Scene asked = scene::read(scene).scene;
    if (moment_s) asked.analysis.duration_s = *moment_s;
    const std::string loose = scene::hold_loose_blocks(asked);
    const auto answered = [&]() -> json {
      if (question == "level") return process::level_answer(asked, still_water);
      if (question == "safety") return process::safety_answer(asked, still_water);
      if (question == "margin") return process::margin_answer(asked, still_water);
      if (question == "water") return process::water_answer(asked, still_water);
      return process::modes_answer(asked, still_water, reservoir::mass_on_faces);
    };
    json found = answered();
    if (!loose.empty() && question != "margin") found["warnings"].push_back(loose);  // a run names them itself
    results::replace_file(answer, found.dump(2) + "\n");
    return 0;
  });
}
