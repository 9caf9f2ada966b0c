// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-limit: at which level, and by which factor on strength, the blocks of a scene fail, and in which modes they
// swing, without a run.
#include <CLI/CLI.hpp>

#include <optional>

#include "bridge/process/answers.hpp"
#include "bridge/process/exit_status.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/read.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  std::string question;
  std::string scene;
  std::string answer;
  std::optional<double> moment_s;
  CLI::App app{"blockweir-limit: at which level, and by which factor on strength, a scene fails"};
  app.add_option("question", question,
                 "level: at which it fails; safety: factor of safety; margin: factor at the end of a run; modes: "
                 "natural frequencies; water: pressures")
      ->required()
      ->check(CLI::IsMember({"level", "safety", "margin", "modes", "water"}));
  app.add_option("scene", scene, "scene file or case folder")->required();
  app.add_option("--answer", answer, "file for the answer (JSON)")->required();
  app.add_option("--moment", moment_s, "time whose loads and levels count, s (default: the run's end)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return process::exit_status("blockweir-limit", [&] {
    scene::Scene asked = scene::read(scene).scene;
    if (moment_s) asked.analysis.duration_s = *moment_s;
    const auto still = [](const scene::Scene& of, const std::filesystem::path& folder) {
      return of.fluid == scene::FluidModel::reservoir ? reservoir::make(of, folder) : hydrostatic::make(of, folder);
    };
    const auto answered = [&]() -> nlohmann::json {
      if (question == "level") return process::level_answer(asked, still);
      if (question == "safety") return process::safety_answer(asked, still);
      if (question == "margin") return process::margin_answer(asked, still);
      if (question == "water") return process::water_answer(asked, still);
      return process::modes_answer(asked, still, reservoir::mass_on_faces);
    };
    results::replace_file(answer, answered().dump(2) + "\n");
    return 0;
  });
}
