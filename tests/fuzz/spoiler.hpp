// SPDX-License-Identifier: GPL-3.0-or-later
// Spoils a scene as people and machines do: numbers, words and brackets where they do not belong, lines in another
// order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace blockweir::test {

/// What people and machines put where it does not belong.
inline const std::array<std::string, 30> scraps{
    "inf",    "nan",       "-1",     "0",   "1e308", "-1e-308",     "99999999999999999999",
    "1e400",  "true",      "\"\"",   "'x'", "[",     "]",           "{",
    "}",      "[[",        "]]",     "[]",  "{}",    "=",           "\n",
    ".",      "[block]\n", "\"\"\"", "#",   "\xff",  "[[block]]\n", ",",
    "[0, 0]", "a.b.c"};

class Spoiler {
 public:
  explicit Spoiler(std::uint32_t seed) : random_(seed) {}

  std::string spoil(std::string scene, std::size_t most_changes) {
    for (std::size_t changes = 1 + below(most_changes); changes > 0; --changes) change_once(scene);
    return scene;
  }
  const std::string& scrap() { return scraps[below(scraps.size())]; }
  std::size_t below(std::size_t end) { return random_() % end; }

 private:
  void change_once(std::string& scene) {
    if (scene.empty()) scene = "=";
    switch (below(7)) {
      case 0:
        scene[below(scene.size())] = static_cast<char>(below(256));
        break;
      case 1:
        scene.insert(below(scene.size()), scrap());
        break;
      case 2:
        scene.erase(below(scene.size()), 1 + below(12));
        break;
      case 3:
        replace_number(scene);
        break;
      case 4:
        swap_lines(scene);
        break;
      case 5: {
        const std::size_t from = below(scene.size());
        scene.insert(below(scene.size()), scene.substr(from, below(200)));
        break;
      }
      default:
        scene.resize(below(scene.size()) + 1);
        break;
    }
  }

  void replace_number(std::string& scene) {
    const auto at = scene.find_first_of("0123456789", below(scene.size()));
    if (at == std::string::npos) return;
    const auto end = std::min(scene.find_first_not_of("0123456789.e", at), scene.size());
    scene.replace(at, end - at, scrap());
  }

  void swap_lines(std::string& scene) {
    std::vector<std::string> lines;
    std::istringstream stream(scene);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    if (lines.empty()) return;
    std::swap(lines[below(lines.size())], lines[below(lines.size())]);
    scene.clear();
    for (const std::string& line : lines) scene += line + "\n";
  }

  std::mt19937 random_;
};

}  // namespace blockweir::test
