// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of blockweir: one file each, and one line each in the table below.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace blockweir::launch {

/// Executes a command after its options are read; returns the exit status.
using Work = std::function<int()>;

// Each adds its options to `app`.
Work bench_command(CLI::App& app);
Work case_command(CLI::App& app);
Work check_command(CLI::App& app);
Work compare_command(CLI::App& app);
Work completion_command(CLI::App& app);
Work cut_command(CLI::App& app);
Work keys_command(CLI::App& app);
Work level_command(CLI::App& app);
Work man_command(CLI::App& app);
Work modes_command(CLI::App& app);
Work plot_command(CLI::App& app);
Work profile_command(CLI::App& app);
Work reliability_command(CLI::App& app);
Work report_command(CLI::App& app);
Work resume_command(CLI::App& app);
Work run_command(CLI::App& app);
Work safety_command(CLI::App& app);
Work stress_command(CLI::App& app);
Work study_command(CLI::App& app);
Work test_command(CLI::App& app);
Work trace_command(CLI::App& app);
Work validate_command(CLI::App& app);
Work work_command(CLI::App& app);

struct Command {
  const char* name;
  const char* about;
  Work (*make)(CLI::App& app);
};

/// In the order of --help.
inline constexpr std::array commands = {
    Command{"run", "run a scene and report whether it stands or fails", run_command},
    Command{"resume", "continue a run that was stopped, from its last checkpoint", resume_command},
    Command{"level", "find the water level at which a structure fails, by statics and by limit analysis",
            level_command},
    Command{"safety", "find the factor of safety for each load case; exit status 1 where one is too low",
            safety_command},
    Command{"reliability", "find the probability of failure where numbers are uncertain, and which of them matter",
            reliability_command},
    Command{"modes", "find natural frequencies and shapes at rest, without water and with it", modes_command},
    Command{"check", "list all errors and warnings of a scene, without running it", check_command},
    Command{"cut", "draw the blocks of a scene, without running it", cut_command},
    Command{"case", "write OpenFOAM's case of a scene, without running it", case_command},
    Command{"plot", "draw the figures of a run", plot_command},
    Command{"report", "write one page to hand in: verdict, load cases, joints, level, histories", report_command},
    Command{"profile", "show where a run spent its time, as a table and a figure", profile_command},
    Command{"trace", "put both sides of a run on one time axis, for Perfetto", trace_command},
    Command{"study", "run the studies of a scene: critical values, maps, samples, orders", study_command},
    Command{"validate", "run the cases and compare each result with its expected value", validate_command},
    Command{"compare", "run scenes with each contact formulation, or each of --fluids, and compare", compare_command},
    Command{"bench", "measure run time against error, over the settings that a case lists", bench_command},
    Command{"stress", "run maps of extreme settings: each run is right, refused or wrong", stress_command},
    Command{"keys", "make encryption keys for a run on two machines", keys_command},
    Command{"test", "set up, build and run every test (in a source tree: ./blockweir test)", test_command},
    Command{"work", "do one task of a study that is in a queue: what --engine slurm has its jobs call", work_command},
    Command{"completion", "print a script that lets a shell complete commands and options", completion_command},
    Command{"man", "print the manual page (blockweir man | man -l -)", man_command},
};

/// Adds each command as a subcommand of `app`; returns each with its Work.
std::vector<std::pair<const CLI::App*, Work>> add_commands(CLI::App& app);

/// The commands that add_commands() has added.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Options that start with --, and options identified by their position.
std::vector<const CLI::Option*> named_options(const CLI::App& app);
std::vector<const CLI::Option*> positional_options(const CLI::App& app);

/// False for a flag.
bool takes_value(const CLI::Option& option);

}  // namespace blockweir::launch
