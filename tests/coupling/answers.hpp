// SPDX-License-Identifier: GPL-3.0-or-later
// Asks blockweir for answers without a run, as a user does.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/same_results.hpp"

namespace blockweir::test {

using nlohmann::json;

class Answers : public SameResults {
 protected:
  [[nodiscard]] int ask(const std::string& words) const { return shell(programs + "/blockweir " + words); }
  [[nodiscard]] json answer(const std::string& file) const { return json::parse(text(file)); }
  /// How often the last command said so.
  [[nodiscard]] long counted(const std::string& words) const {
    const std::string said = text("out");
    long count = 0;
    for (std::size_t at = 0; (at = said.find(words, at)) != std::string::npos; at += words.size()) ++count;
    return count;
  }
  void write(const std::string& name, const std::string& content) const { std::ofstream(folder / name) << content; }
};

/// A block b x 10 m on rock, which the scene gives in this order; its joint has a triangular uplift and this law.
inline std::string block_on_rock(double breadth_m, const std::string& law, bool rock_first = true) {
  const std::string rock =
      "[[block]]\nname = 'rock'\nmaterial = 'm'\nfixed = true\nvertices_m = [[-20, -6], [45, -6], [45, 0], [-20, 0]]\n";
  const std::string block = fmt::format(
      "[[block]]\nname = 'b'\nmaterial = 'm'\nvertices_m = [[0, 0], [{0}, 0], [{0}, 10], [0, 10]]\n", breadth_m);
  return "analysis = { duration_s = 40 }\nwater = { upstream_level_m = 6 }\n[joint]\nuplift = 'triangular'\n" + law +
         "[material.m]\nyoungs_modulus_pa = 2e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2400\n" +
         (rock_first ? rock + block : block + rock);
}

}  // namespace blockweir::test
