// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-limit: at which level, and by which factor on strength, the blocks of a scene fail, without a run.
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
  app.add_option(
         "question", question,
         "level: at which it fails; safety: factor of safety; margin: factor at the end of a run; water: pressures")
      ->required()
      ->check(CLI::IsMember({"level", "safety", "margin", "water"}));
  app.add_option("scene", scene, "scene file or case folder")->required();
  app.add_option("--answer", answer, "file for the answer (JSON)")->required();
  app.add_option("--moment", moment_s, "time whose loads and levels count, s (default: the run's end)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return process::exit_status("blockweir-limit", [&] {
    const auto answer_to = question == "level"    ? process::level_answer
                           : question == "safety" ? process::safety_answer
                           : question == "margin" ? process::margin_answer
                                                  : process::water_answer;
    scene::Scene asked = scene::read(scene).scene;
    if (moment_s) asked.analysis.duration_s = *moment_s;
    const nlohmann::json found = answer_to(asked, hydrostatic::make);
    results::replace_file(answer, found.dump(2) + "\n");
    return 0;
  });
}
