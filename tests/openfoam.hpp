// SPDX-License-Identifier: GPL-3.0-or-later
// Runs with interFoam as the fluid, coarse and short; what they print and which forces they leave.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "tests/processes.hpp"

namespace blockweir::test {

class OpenFoam : public Processes {
 protected:
  void SetUp() override {
    if (std::system("command -v interFoam >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "interFoam is not on the PATH: Debian's package openfoam has it";
    }
    if (!fs::exists(programs + "/libblockweirOpenFOAM.so")) {
      GTEST_SKIP() << "no libblockweirOpenFOAM.so beside the programs: built without OpenFOAM's headers";
    }
  }

  /// What the shells that the tests start need to know of Debian's OpenFOAM.
  static constexpr const char* environment =
      "WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam} WM_PROJECT=OpenFOAM "
      "WM_PROJECT_VERSION=${WM_PROJECT_VERSION:-v1912} ";

  [[nodiscard]] static std::string set(const std::string& key_and_value) { return " --set '" + key_and_value + "'"; }
  [[nodiscard]] static std::string cells(int in_depth) {
    return set("fluid.model=openfoam") + set("fluid.cells_in_depth=" + std::to_string(in_depth));
  }

  /// Exit status of `blockweir run SCENE --out OUT` with more words behind it; an earlier OUT is removed.
  [[nodiscard]] int run(const std::string& scene, const std::string& out, const std::string& more) const {
    fs::remove_all(folder / out);
    return shell(programs + "/blockweir run " + scene + " --quiet --out " + out + more);
  }

  /// What the run got for a quantity that its scene expects.
  [[nodiscard]] double got(const std::string& out, const std::string& quantity) const {
    const auto summary = nlohmann::json::parse(text(out + "/summary.json"), nullptr, false);
    for (const auto& check : summary.value("checks", nlohmann::json::array())) {
      if (check["name"].get<std::string>().rfind(quantity, 0) == 0) return check["got"].get<double>();
    }
    return std::nan("");
  }

  struct Force {
    Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< N/m
    double moment = 0;                                ///< N, about the given point
  };
  /// Of the last stored time's panels that lie within `reach_m` of `centre`.
  [[nodiscard]] Force water_force(const std::string& out, const Eigen::Vector2d& centre, double reach_m) const {
    std::istringstream lines(text(out + "/frames.jsonl"));
    std::string last;
    for (std::string line; std::getline(lines, line);) last = line;
    Force sum;
    const auto frame = nlohmann::json::parse(last);
    for (const auto& panel : frame["panels"]) {
      const auto at = [&](std::size_t i) { return panel[i].get<double>(); };
      const Eigen::Vector2d from(at(0), at(1));
      const Eigen::Vector2d to(at(2), at(3));
      if ((from - centre).norm() > reach_m || (to - centre).norm() > reach_m) continue;
      const Eigen::Vector2d t = to - from;
      const Eigen::Vector2d inwards(-t.y(), t.x());  // of the panel's length
      const auto add = [&](const Eigen::Vector2d& node, double pressure) {
        const Eigen::Vector2d f = pressure * inwards;
        const Eigen::Vector2d arm = node - centre;
        sum.force += f;
        sum.moment += arm.x() * f.y() - arm.y() * f.x();
      };
      add(from, (2 * at(4) + at(5)) / 6);
      add(to, (at(4) + 2 * at(5)) / 6);
    }
    return sum;
  }

  /// Largest water velocity at the run's end [m/s], from interFoam's last Courant number: cells of cell_m, steps of
  /// dt_s.
  [[nodiscard]] double velocity(const std::string& out, double cell_m, double dt_s) const {
    const std::string log = text(out + "/openfoam/log.interFoam");
    const std::string key = "Courant Number mean: ";
    double largest = std::nan("");
    for (std::size_t at = log.find(key); at != std::string::npos; at = log.find(key, at + 1)) {
      if (at >= 10 && log.compare(at - 10, 10, "Interface ") == 0) continue;
      const std::size_t max = log.find("max: ", at);
      largest = std::stod(log.substr(max + 5));
    }
    return largest * cell_m / dt_s;
  }

  /// Seconds that interFoam's log says it took; NaN where it says nothing.
  [[nodiscard]] double execution_s(const std::string& log) const {
    const std::string all = text(log);
    const std::size_t at = all.rfind("ExecutionTime = ");
    return at == std::string::npos ? std::nan("") : std::stod(all.substr(at + 16));
  }
};

}  // namespace blockweir::test
