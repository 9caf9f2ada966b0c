// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir: the command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bridge/channel/keys.hpp"
#include "bridge/launch/bench.hpp"
#include "bridge/launch/compare.hpp"
#include "bridge/launch/cut.hpp"
#include "bridge/launch/plot.hpp"
#include "bridge/launch/profile.hpp"
#include "bridge/launch/run.hpp"
#include "bridge/launch/stress.hpp"
#include "bridge/launch/study.hpp"
#include "bridge/launch/supervisor.hpp"
#include "bridge/launch/validate.hpp"
#include "bridge/launch/write_case.hpp"
#include "bridge/scene/exit_status.hpp"
#include "bridge/scene/gathered.hpp"
#include "bridge/scene/nearest.hpp"
#include "bridge/scene/read.hpp"
#include "bridge/scene/structure_size.hpp"

namespace {

using namespace blockweir;

/// Adds what the variant is warned of beyond the scene itself.
void add_warnings(const scene::ReadScene& read, const scene::Variant& variant, std::vector<scene::Diagnostic> warnings,
                  std::vector<scene::Diagnostic>& all) {
  for (scene::Diagnostic& warning : warnings) {
    const auto same = [&](const scene::Diagnostic& other) { return other.message() == warning.message(); };
    if (std::any_of(read.warnings.begin(), read.warnings.end(), same)) continue;
    if (warning.line != variant.line) warning.found = fmt::format("variant \"{}\": {}", variant.name, warning.found);
    all.push_back(std::move(warning));
  }
}

int check_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides, bool strict) {
  const scene::ReadScene read = scene::read(path, overrides);
  std::vector<scene::Diagnostic> warnings = read.warnings;
  std::size_t studies = 0;
  scene::Gathered wrong;  // of variants and studies: each is a scene of its own
  for (const scene::Variant& variant : read.scene.variants) {
    wrong.from(
        [&] { add_warnings(read, variant, scene::read_variant(path, variant.name, overrides).warnings, warnings); });
  }
  wrong.from([&] { studies = launch::study_tasks(path, overrides).size(); });
  wrong.from([&] { launch::bench_settings(path, overrides); });
  wrong.report();
  if (strict) scene::refuse_warnings(warnings);
  for (const auto& note : read.notes) fmt::print(stderr, "{}\n", note.text());
  for (const auto& warning : warnings) fmt::print(stderr, "{}\n", warning.text());
  const scene::Scene& s = read.scene;
  fmt::print("{}: sound; {} blocks, {} joints, {} variants, {} studies, {} s in steps of {} s{}\n", s.file.string(),
             s.blocks.size(), s.joints.size(), s.variants.size(), studies, s.analysis.duration_s, s.analysis.step_s,
             warnings.empty() ? "" : fmt::format("; {} warning{}", warnings.size(), warnings.size() == 1 ? "" : "s"));
  fmt::print(
      "structure of {:.4g} m: failure_displacement_m = {:.3g}, rest_speed_m_per_s = {:.3g}, penetration_tolerance_m = "
      "{:.3g}{}\n",
      scene::structure_size_m(s.blocks), s.analysis.failure_displacement_m, s.analysis.rest_speed_m_per_s,
      s.contact.penetration_tolerance_m,
      s.fluid == scene::FluidModel::hydrostatic
          ? fmt::format(", open_crack_width_m = {:.3g}", s.water.open_crack_width_m)
          : "");
  return 0;
}

/// CLI11 would call an unknown command an extra argument; people want the word that they meant.
void refuse_unknown_command(int argc, char** argv, const CLI::App& app) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = scene::nearest(argv[1], names);
  throw std::invalid_argument(fmt::format("there is no command \"{}\"{}; blockweir --help lists them", argv[1],
                                          near.empty() ? "" : fmt::format(", did you mean \"{}\"?", near)));
}

int run_command(int argc, char** argv) {
  CLI::App app{"blockweir: structures of blocks that stand in water"};
  app.set_version_flag("--version", BLOCKWEIR_VERSION);
  app.require_subcommand(1);
  launch::RunOptions run;
  launch::ResumeOptions resume;
  launch::ValidateOptions validate;
  launch::PlotOptions plot;
  launch::ProfileOptions profile;
  launch::CutOptions cut;
  launch::CompareOptions compare;
  launch::StudyOptions study;
  launch::BenchOptions bench;
  launch::StressOptions stress;
  launch::CaseOptions written;
  std::string checked;

  auto* run_cmd = app.add_subcommand("run", "run a scene and say how it ends");
  run_cmd->add_option("scene", run.scene, "scene file or case folder")->required();
  run_cmd->add_option("--out", run.out, "folder for the results (default: runs/CASE)");
  run_cmd->add_option("--variant", run.variant, "name of one of the scene's variants");
  run_cmd->add_option("--set", run.overrides, "key=value over the scene's own, e.g. analysis.step_s=0.001");
  run_cmd->add_flag("--inproc", run.inproc, "still water within the solid's process: the same results, sooner");
  run_cmd->add_flag("--strict", run.strict, "warnings are errors: such a scene is not run");
  run_cmd->add_flag("--quiet", run.quiet, "no progress");
  auto* resume_cmd = app.add_subcommand("resume", "go on with a run that was stopped, from its last checkpoint");
  resume_cmd->add_option("run", resume.folder, "folder of the run")->required();
  resume_cmd->add_flag("--inproc", resume.inproc, "still water within the solid's process");
  resume_cmd->add_flag("--quiet", resume.quiet, "no progress");
  auto* check_cmd = app.add_subcommand("check", "say all that is wrong with a scene, without running it");
  check_cmd->add_option("scene", checked, "scene file or case folder")->required();
  check_cmd->add_option("--set", run.overrides, "key=value over the scene's own");
  check_cmd->add_flag("--strict", run.strict, "warnings are errors");
  auto* cut_cmd = app.add_subcommand("cut", "draw the blocks of a scene, without running it");
  cut_cmd->add_option("scene", cut.scene, "scene file or case folder")->required();
  cut_cmd->add_option("--out", cut.out, "picture, .png or .svg (default: cut.png)");
  cut_cmd->add_option("--set", cut.overrides, "key=value over the scene's own");
  auto* case_cmd = app.add_subcommand("case", "write OpenFOAM's case of a scene, without running it");
  case_cmd->add_option("scene", written.scene, "scene file or case folder")->required();
  case_cmd->add_option("--out", written.out, "folder for the case (default: case)");
  case_cmd->add_option("--set", written.overrides, "key=value over the scene's own");
  auto* plot_cmd = app.add_subcommand("plot", "draw the figures of a run");
  plot_cmd->add_option("run", plot.run, "folder of a run")->required();
  plot_cmd->add_flag("--svg", plot.svg, "SVG instead of PNG");
  plot_cmd->add_flag("--animate", plot.animated, "all frames as animation.gif too");
  auto* profile_cmd = app.add_subcommand("profile", "say and draw where the time of a run went");
  profile_cmd->add_option("run", profile.run, "folder of a run")->required();
  profile_cmd->add_flag("--svg", profile.svg, "SVG instead of PNG");
  auto* study_cmd = app.add_subcommand("study", "make the runs of a scene's studies and compare");
  study_cmd->add_option("scene", study.scene, "scene file or case folder")->required();
  study_cmd->add_option("--name", study.name, "one of the studies (default: all)");
  study_cmd->add_option("--out", study.out, "folder for their tables (JSON) and figures (PNG)");
  study_cmd->add_option("--set", study.overrides, "key=value over the scene's own");
  auto* validate_cmd = app.add_subcommand("validate", "run every case that has an answer and compare");
  validate_cmd->add_option("cases", validate.cases, "case folders (default: all)");
  validate_cmd->add_option("--json", validate.json, "file for the table as JSON");
  validate_cmd->add_option("--set", validate.overrides, "key=value over the scenes' own");
  validate_cmd->add_flag("--sweep", validate.sweep, "for penalties 5e6, 1e9, 1e12 and steps 1e-2, 1e-3 s");
  auto* compare_cmd = app.add_subcommand("compare", "the three contact formulations on the same scenes, side by side");
  compare_cmd->add_option("cases", compare.cases, "case folders (default: five of them)");
  compare_cmd->add_option("--json", compare.json, "file for the table as JSON");
  compare_cmd->add_option("--set", compare.overrides, "key=value over the scenes' own");
  auto* bench_cmd = app.add_subcommand("bench", "wall time against error, over the settings that cases name");
  bench_cmd->add_option("cases", bench.cases, "case folders (default: all that have a [[bench]])");
  bench_cmd->add_option("--out", bench.out, "folder for the table and the pictures (default: runs/bench)");
  bench_cmd->add_flag("--short", bench.brief, "two values a curve, each run once");
  bench_cmd->add_option("--set", bench.overrides, "key=value over the scenes' own");
  auto* stress_cmd = app.add_subcommand("stress", "maps of stability: each cell right, refused, or wrong");
  stress_cmd->add_option("names", stress.names, "of maps in cases/stress, or scene files (default: all maps)");
  stress_cmd->add_option("--out", stress.out, "folder for tables and pictures (default: runs/stress)");
  stress_cmd->add_flag("--short", stress.brief, "only the first, the middle and the last value of each key");
  std::string keys;
  auto* keys_cmd = app.add_subcommand("keys", "make keys for a line between two machines");
  keys_cmd->add_option("folder", keys, "where to put them: FOLDER/solid and FOLDER/fluid")->required();
  app.add_subcommand("test", "set up, build and run every test (in a source tree: ./blockweir test)");

  refuse_unknown_command(argc, argv, app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (run_cmd->parsed() || resume_cmd->parsed()) {
    static const launch::StopsLater until_it_is_reported;  // what has ended by itself was not stopped
    const launch::RunResult result = run_cmd->parsed() ? launch::run(run) : launch::resume(resume);
    if (!result.trouble.empty()) fmt::print(stderr, "blockweir: {}\n", launch::trouble_text(result));
    fmt::print("{}", launch::report(result));
    return result.exit_code;
  }
  if (check_cmd->parsed()) return check_scene(checked, run.overrides, run.strict);
  if (keys_cmd->parsed()) {
    channel::make_keys(keys);
    fmt::print("{0}/solid is for the solid's machine, {0}/fluid for the fluid's: --keys FOLDER for each program\n",
               keys);
    return 0;
  }
  if (cut_cmd->parsed()) return launch::cut(cut), 0;
  if (case_cmd->parsed()) launch::write_case(written);
  if (plot_cmd->parsed()) return launch::plot(plot), 0;
  if (profile_cmd->parsed()) return launch::profile(profile), 0;
  if (study_cmd->parsed()) return launch::study(study);
  if (bench_cmd->parsed()) return launch::bench(bench);
  if (stress_cmd->parsed()) return launch::stress(stress);
  if (validate_cmd->parsed()) return launch::validate(validate);
  if (compare_cmd->parsed()) return launch::compare(compare);
  throw std::invalid_argument("tests run in a source tree: ./blockweir test");
}

}  // namespace

int main(int argc, char** argv) {
  return scene::exit_status("blockweir", [&] { return run_command(argc, argv); });
}
