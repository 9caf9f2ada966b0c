// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// What coupling costs: example 1 of the paper (cases/cracked-dam-upper, 12 s) from start to exit with two processes,
// with one, and by the solid alone with the same pressures given as a table; by turns in one run. Until the dam fails
// both do the same; then water follows the block that slides, and the solid has more to solve. Arguments: the number of
// turns (5), and a folder for the results (the system's folder for temporary files).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text(const fs::path& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

constexpr double first_level_m = 21.702;
constexpr double last_level_m = 22.302;  // after 6 s

std::string pressure(double height_m) {
  const double last_pa = 9810 * (last_level_m - height_m);
  const double wet_from_s = 6 * (height_m - first_level_m) / (last_level_m - first_level_m);
  if (wet_from_s > 0) return fmt::format("{{ table = [[0, 0], [{}, 0], [6, {}]] }}", wet_from_s, last_pa);
  return fmt::format("{{ table = [[0, {}], [6, {}]] }}", 9810 * (first_level_m - height_m), last_pa);
}

std::string face(const char* block, double from_x, double from_y, double to_x, double to_y) {
  return fmt::format(
      "[[face_pressure]]\nblock = \"{}\"\nfrom_m = [{}, {}]\nto_m = [{}, {}]\npressure_from_pa = {}\npressure_to_pa = "
      "{}\n",
      block, from_x, from_y, to_x, to_y, pressure(from_y), pressure(to_y));
}

/// Example 1 without its water, with what the water of the rising level does to the faces that it wets.
std::string by_table(const std::string& scene) {
  return scene.substr(0, scene.find("[water]")) + face("base", 0, 0, 0, 15) + face("top", 0, 15, 0, first_level_m) +
         face("top", 0, first_level_m, 0, 22) + face("top", 0, 22, 4, 22);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Way {
  const char* name;
  std::string scene;
  const char* option;
  std::vector<double> seconds{};
  double failed_at_s = 0;
  long solutions = 0;  ///< of the solid's equations

  void run(const fs::path& folder) {
    const fs::path out = folder / "out";
    fs::remove_all(out);
    const std::string command = fmt::format(BLOCKWEIR_PROGRAMS "/blockweir run {} {} --out {} > {} 2>&1", scene, option,
                                            out.string(), (folder / "said").string());
    const auto start = std::chrono::steady_clock::now();
    const int status = std::system(command.c_str());
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (status != 0) throw std::runtime_error(command + "\n" + text(folder / "said"));
    const auto summary = nlohmann::json::parse(text(out / "summary.json"));
    failed_at_s = summary.at("failure").at("time_s");
    solutions = summary.at("counts").at("iterations");
  }
  [[nodiscard]] double median_s() const { return median(seconds); }
  /// Of each turn: what else the machine does falls on both.
  [[nodiscard]] double ratio_to(const Way& other) const {
    std::vector<double> ratios(seconds.size());
    std::transform(seconds.begin(), seconds.end(), other.seconds.begin(), ratios.begin(), std::divides<>());
    return median(ratios);
  }
};

}  // namespace

int main(int argc, char** argv) {
  const int turns = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  const fs::path folder = (argc > 2 ? fs::path(argv[2]) : fs::temp_directory_path()) / "blockweir-coupling-bench";
  fs::create_directories(folder);
  const std::string example = BLOCKWEIR_SOURCE "/cases/cracked-dam-upper/scene.toml";
  const fs::path table = folder / "table.toml";
  std::ofstream(table) << by_table(text(example));
  try {
    std::vector<Way> ways{{"solid alone, table", table.string(), ""},
                          {"one process", example, "--inproc"},
                          {"two processes", example, ""}};
    for (int turn = 0; turn < turns; ++turn) {
      for (Way& way : ways) way.run(folder);
    }
    fmt::print("{:<20} {:>12} {:>12} {:>16} {:>14} {:>12}\n", "", "median [s]", "least [s]", "to solid alone",
               "fails at [s]", "solutions");
    for (const Way& way : ways) {
      fmt::print("{:<20} {:>12.3f} {:>12.3f} {:>16.2f} {:>14.3f} {:>12}\n", way.name, way.median_s(),
                 *std::min_element(way.seconds.begin(), way.seconds.end()), way.ratio_to(ways.front()), way.failed_at_s,
                 way.solutions);
    }
    fs::remove_all(folder);
  } catch (const std::exception& error) {
    fmt::print(stderr, "coupling_bench: {}\n", error.what());
    return 1;
  }
}
