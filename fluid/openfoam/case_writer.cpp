// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/case_writer.hpp"

#include <nlohmann/json.hpp>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "fluid/openfoam/dictionary.hpp"
#include "fluid/openfoam/inflow_limits.hpp"
#include "fluid/openfoam/initial_water.hpp"
#include "fluid/openfoam/interface_dictionary.hpp"

namespace blockweir::openfoam {
namespace {

std::string block_mesh(const Grid& g) {
  std::string parts;
  for (const Stretch& s : g.stretches) {
    parts += fmt::format(" ({} {} {})", exact(s.length_m), s.cells, exact(s.expansion));
  }
  const auto corner = [](double x, double y, int z) { return fmt::format("    ({} {} {})\n", exact(x), exact(y), z); };
  std::string corners;
  for (const int z : {0, 1}) {
    corners += corner(g.x.front(), g.y.front(), z) + corner(g.x.back(), g.y.front(), z) +
               corner(g.x.back(), g.y.back(), z) + corner(g.x.front(), g.y.back(), z);
  }
  return file_header("dictionary", "blockMeshDict") +
         fmt::format(
             "// Metres; one cell of 1 m across.\n"
             "vertices\n(\n{});\n\n"
             "blocks\n(\n    hex (0 1 2 3 4 5 6 7) ({} {} 1) simpleGrading (({} ) 1 1)\n);\n\n"
             "boundary\n(\n"
             "    upstream {{ type wall; faces ((0 4 7 3)); }}\n"
             "    downstream {{ type wall; faces ((1 2 6 5)); }}\n"
             "    floor {{ type wall; faces ((0 1 5 4)); }}\n"
             "    atmosphere {{ type patch; faces ((3 7 6 2)); }}\n"
             "    sides {{ type empty; faces ((0 3 2 1) (4 5 6 7)); }}\n"
             ");\n",
             corners, g.columns(), g.rows(), parts);
}

std::string control(const scene::Scene& scene, const CaseOptions& options) {
  return file_header("dictionary", "controlDict") +
         fmt::format(
             "application       interFoam;\n"
             "libs              ({});\n\n"
             "startFrom         latestTime;\n"
             "startTime         0;\n"
             "stopAt            endTime;\n"
             "endTime           {};  // the solid process ends the run\n"
             "deltaT            {};\n"
             "adjustTimeStep    no;  // the coupling sets it, window by window\n"
             "maxCo             1;   // not heeded then\n"
             "maxAlphaCo        1;\n\n"
             "writeControl      runTime;\n"
             "writeInterval     {};\n"
             "writeFormat       binary;\n"
             "timePrecision     10;\n"
             "runTimeModifiable no;\n\n"
             "functions\n{{\n    blockweir {{ type blockweirSchedule; libs ({}); }}\n}}\n",
             quoted(options.plugin.string()), exact(end_time_s(scene)), exact(first_step_s(scene)),
             exact(scene.output.frame_every_s), quoted(options.plugin.string()));
}

/// Of the settings measured at equal error the fastest ones.
std::string schemes() {
  return file_header("dictionary", "fvSchemes") +
         "ddtSchemes { default Euler; }\n"
         "gradSchemes { default Gauss linear; }\n"
         "divSchemes\n{\n"
         "    div(rhoPhi,U)  Gauss linearUpwind grad(U);\n"
         "    div(phi,alpha) Gauss vanLeer;\n"
         "    div(phirb,alpha) Gauss linear;\n"
         "    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;\n"
         "}\n"
         "laplacianSchemes { default Gauss linear uncorrected; }  // the mesh is orthogonal\n"
         "interpolationSchemes { default linear; }\n"
         "snGradSchemes { default uncorrected; }\n";
}

std::string solution() {
  return file_header("dictionary", "fvSolution") +
         "solvers\n{\n"
         "    \"alpha.water.*\"\n    {\n"
         "        nAlphaCorr 1;\n        nAlphaSubCycles 1;\n        cAlpha 1;\n        MULESCorr yes;\n"
         "        nLimiterIter 3;\n        solver smoothSolver;\n        smoother symGaussSeidel;\n"
         "        tolerance 1e-8;\n        relTol 0;\n    }\n"
         "    \"pcorr.*\"\n    {\n        solver PCG;\n        preconditioner DIC;\n        tolerance 1e-5;\n"
         "        relTol 0;\n    }\n"
         "    p_rgh\n    {\n        solver GAMG;\n        smoother DIC;\n        tolerance 1e-7;\n        relTol "
         "0.05;\n"
         "        maxIter 50;\n    }\n"
         "    p_rghFinal { $p_rgh; relTol 0; }\n"
         "    \"U.*\"\n    {\n        solver smoothSolver;\n        smoother symGaussSeidel;\n        tolerance 1e-6;\n"
         "        relTol 0;\n    }\n"
         "}\n\n"
         "PIMPLE\n{\n"
         "    momentumPredictor no;\n    nOuterCorrectors 1;\n    nCorrectors 2;\n    nNonOrthogonalCorrectors 0;\n"
         "}\n";
}

std::string transport(const scene::Scene& scene) {
  return file_header("dictionary", "transportProperties") +
         fmt::format(
             "phases (water air);\n\n"
             "water {{ transportModel Newtonian; nu 1e-06; rho {}; }}\n"
             "air {{ transportModel Newtonian; nu 1.48e-05; rho {}; }}\n\n"
             "sigma 0;\n",
             exact(scene.water.density_kg_per_m3), exact(scene.openfoam.air_density_kg_per_m3));
}

std::string field(const std::string& name, const std::string& dimensions, const std::vector<double>& values,
                  const std::string& boundary) {
  std::string text =
      file_header("volScalarField", name) +
      fmt::format("dimensions {};\n\ninternalField nonuniform List<scalar>\n{}\n(\n", dimensions, values.size());
  for (const double value : values) text += fmt::format("{:.17g}\n", value);
  return text + ");\n\nboundaryField\n{\n" + boundary + "    sides { type empty; }\n}\n";
}

/// A closed end is a wall without friction; the plugin sets the velocity at an open one.
std::string end_of_pool(const char* patch, bool open) {
  return fmt::format("    {} {{ type {}; }}\n", patch, open ? "fixedValue; value uniform (0 0 0)" : "slip");
}

std::string velocity(const scene::Scene& scene, const InitialWater& water) {
  std::string inside = "uniform (0 0 0)";
  if (!water.velocity.empty()) {
    inside = fmt::format("nonuniform List<vector>\n{}\n(\n", water.velocity.size());
    for (const scene::Point& u : water.velocity) inside += fmt::format("({:.9g} {:.9g} 0)\n", u.x(), u.y());
    inside += ")";
  }
  const bool open = scene.openfoam.level_control == scene::LevelControl::inflow;
  return file_header("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0];\n\ninternalField " + inside +
         ";\n\nboundaryField\n{\n" + end_of_pool("upstream", open && scene.water.upstream_level_m) +
         end_of_pool("downstream", open && scene.water.downstream_level_m) + "    floor { type noSlip; }\n" +
         "    atmosphere { type pressureInletOutletVelocity; value uniform (0 0 0); }\n    sides { type empty; }\n}\n";
}

/// Removes the folders of times after `time_s`.
void forget_times_after(const std::filesystem::path& folder, double time_s) {
  std::vector<std::filesystem::path> later;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool time = name.find_first_not_of("0123456789.e-+") == std::string::npos;
    if (entry.is_directory() && time && std::stod(name) > time_s) later.push_back(entry.path());
  }
  for (const auto& path : later) std::filesystem::remove_all(path);
}

std::vector<std::filesystem::path> folders_of_ranks(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> ranks;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const bool rank = entry.path().filename().string().rfind("processor", 0) == 0;
    if (entry.is_directory() && rank) ranks.push_back(entry.path());
  }
  return ranks;
}

/// interFoam would go on from the times of a former run.
void forget_previous_run(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "constant/blockweir")) return;
  forget_times_after(folder, 0);
  for (const auto& rank : folders_of_ranks(folder)) std::filesystem::remove_all(rank);
  checkpoint::forget(folder);
}

}  // namespace

Surroundings surroundings(const scene::Scene& scene, const Grid& grid) {
  Surroundings around{grid.site, outlines_in(grid, scene), grid.site.highest_m - grid.ground_m, grid.cell_m};
  if (scene::comes_in(scene.openfoam)) around.wave = stokes_wave(scene, grid);
  return around;
}

void prepare_resumption(const scene::Scene& scene, const Surroundings& around, const CaseOptions& options,
                        std::uint64_t first_window, double time_s) {
  const double next = time_s + scene.coupling.window_s / 2;
  forget_times_after(options.folder, next);
  for (const auto& rank : folders_of_ranks(options.folder)) forget_times_after(rank, next);
  write_interface(options.folder, scene, around, options.endpoint, first_window);
}

std::string decompose_dictionary(const scene::Scene& scene) {
  return file_header("dictionary", "decomposeParDict") +
         fmt::format(
             "numberOfSubdomains {0};\nmethod simple;  // in columns: the pressure on blocks is looked up within one\n"
             "simpleCoeffs {{ n ({0} 1 1); delta 0.001; }}\n",
             scene.openfoam.processes);
}

double end_time_s(const scene::Scene& scene) {
  return 1e6 + 10 * scene.analysis.duration_s;
}

double first_step_s(const scene::Scene& scene) {
  return scene.coupling.window_s / scene.openfoam.steps_per_window;
}

void write_case(const scene::Scene& scene, const Grid& grid, const CaseOptions& options) {
  check_inflow(scene, grid);
  forget_previous_run(options.folder);
  for (const char* part : {"0", "constant", "system"}) results::make_folder(options.folder / part);
  const auto write = [&](const char* file, const std::string& text) {
    results::replace_file(options.folder / file, text);
  };
  const InitialWater water = initial_water(grid, scene);
  // This marks the folder as ours.
  write_interface(options.folder, scene, surroundings(scene, grid), options.endpoint, 0);
  write("grid.json", nlohmann::json{{"x_m", grid.x}, {"y_m", grid.y}}.dump() + "\n");  // for pictures
  write("system/blockMeshDict", block_mesh(grid));
  write("system/controlDict", control(scene, options));
  write("system/fvSchemes", schemes());
  write("system/fvSolution", solution());
  write("system/fvOptions",
        file_header("dictionary", "fvOptions") + "blockweir { type blockweirBlocks; active true; }\n");
  write("system/decomposeParDict", decompose_dictionary(scene));
  write("constant/transportProperties", transport(scene));
  write("constant/turbulenceProperties",
        file_header("dictionary", "turbulenceProperties") + "simulationType laminar;\n");
  write("constant/g",
        file_header("uniformDimensionedVectorField", "g") +
            fmt::format("dimensions [0 1 -2 0 0 0 0];\nvalue (0 {} 0);\n", exact(-scene.analysis.gravity_m_per_s2)));
  write("constant/hRef", file_header("uniformDimensionedScalarField", "hRef") +
                             fmt::format("dimensions [0 1 0 0 0 0 0];\nvalue {};\n", exact(water.reference_level_m)));
  write("0/alpha.water", field("alpha.water", "[0 0 0 0 0 0 0]", water.fraction,
                               "    \"(upstream|downstream|floor)\" { type zeroGradient; }\n"
                               "    atmosphere { type inletOutlet; inletValue uniform 0; value uniform 0; }\n"));
  write("0/p_rgh", field("p_rgh", "[1 -1 -2 0 0 0 0]", water.p_rgh_pa,
                         "    \"(upstream|downstream|floor)\" { type fixedFluxPressure; value uniform 0; }\n"
                         "    atmosphere { type totalPressure; p0 uniform 0; }\n"));
  write("0/U", velocity(scene, water));
}

}  // namespace blockweir::openfoam
