// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/refused_draws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/reliability/distribution_quantile.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/overrides.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {
namespace {

using scene::Diagnostic;
using scene::Randomness;
using scene::RandomVariable;

constexpr const char* other_distribution =
    "cut its distribution off with least or most, or take one without such values, as \"lognormal\" of what is above 0";

/// The scene with one variable at some probability of its distribution.
class OneVariable {
 public:
  OneVariable(const std::filesystem::path& scene, const Randomness& randomness, std::size_t v,
              const Settings& overrides)
      : scene_(scene), randomness_(randomness), v_(v), overrides_(overrides) {
    for (const RandomVariable& variable : randomness.variables) {
      point_.push_back(quantile_of(variable.distribution, 0.5));
    }
  }

  void read_at(double probability) {
    const RandomVariable& variable = randomness_.variables[v_];
    point_[v_] = quantile_of(variable.distribution, probability);
    const Settings settings = settings_of_one(randomness_, v_, point_);
    scene::read_entry(scene_, {fmt::format("[[random]] \"{}\"", variable.name), variable.line, settings},
                      joined(overrides_, settings));
  }

  /// The error of the scene with this quantile; none if it is valid.
  std::optional<Diagnostic> wrong_at(double probability) {
    try {
      read_at(probability);
      return std::nullopt;
    } catch (const scene::SceneError& error) {
      for (const Diagnostic& d : error.diagnostics()) {
        if (d.severity == Diagnostic::Severity::error) return d;
      }
      return error.diagnostics().front();
    }
  }

 private:
  const std::filesystem::path& scene_;
  const Randomness& randomness_;
  std::size_t v_;
  const Settings& overrides_;
  RandomPoint point_;
};

constexpr double rare_draw = 1e-4;

/// Of the values below the middle, or above it: the share that is refused, by bisection; `wrong` at the outermost.
std::optional<Diagnostic> refused_side(OneVariable& variable, bool below) {
  const auto at = [below](double share) { return below ? share : 1 - share; };
  std::optional<Diagnostic> wrong = variable.wrong_at(at(rare_draw));
  if (!wrong) return std::nullopt;
  double refused = rare_draw;
  double sound = 0.5;
  constexpr double near = 1.01;
  while (sound / refused > near) {
    const double middle = std::sqrt(refused * sound);
    (variable.wrong_at(at(middle)) ? refused : sound) = middle;
  }
  wrong->severity = Diagnostic::Severity::warning;
  wrong->found = fmt::format("{:.2g} % of the values that are drawn are refused, as {}", 100 * refused, wrong->found);
  wrong->remedy = other_distribution;
  return wrong;
}

}  // namespace

std::vector<Diagnostic> refused_draws(const std::filesystem::path& scene, const scene::ReadScene& read,
                                      const Settings& overrides) {
  std::vector<Diagnostic> warnings;
  scene::CollectedErrors wrong;
  for (std::size_t v = 0; v < read.randomness.variables.size(); ++v) {
    OneVariable variable(scene, read.randomness, v, overrides);
    wrong.from([&] {
      variable.read_at(0.5);
      for (const bool below : {true, false}) {
        if (auto warning = refused_side(variable, below)) warnings.push_back(std::move(*warning));
      }
    });
  }
  wrong.report();
  return warnings;
}

std::string why_no_answer(const Randomness& randomness, const Outcome& row) {
  const Settings settings = row["settings"];
  const std::string trouble = row.value("trouble", "no level is found");
  for (std::size_t v = 0; v < randomness.variables.size(); ++v) {
    const RandomVariable& variable = randomness.variables[v];
    for (const std::string& setting : settings) {
      const std::string place = scene::override_place(setting) + ": error: ";
      const std::string key = setting.substr(0, setting.find('='));
      const auto at = trouble.find(place);
      if (key != variable.key || at == std::string::npos) continue;
      const std::string reason = trouble.substr(at + place.size());
      return fmt::format("[[random]] \"{}\" draws {:.6g}, which is refused: {}; {}", variable.name,
                         std::strtod(setting.c_str() + key.size() + 1, nullptr), reason.substr(0, reason.rfind(';')),
                         other_distribution);
    }
  }
  return fmt::format("{}: {}", fmt::join(settings, ", "), trouble);
}

void refuse_unsound(const std::filesystem::path& scene, const Randomness& randomness,
                    const std::vector<RandomPoint>& points, const Settings& overrides) {
  scene::CollectedErrors wrong;
  for (std::size_t v = 0; v < randomness.variables.size(); ++v) {
    const RandomVariable& variable = randomness.variables[v];
    const auto [least, most] = std::minmax_element(
        points.begin(), points.end(), [v](const RandomPoint& a, const RandomPoint& b) { return a[v] < b[v]; });
    for (const auto& extreme : {least, most}) {
      const Settings settings = settings_of(randomness, *extreme);
      wrong.from([&] {
        scene::read_entry(scene, {fmt::format("[[random]] \"{}\"", variable.name), variable.line, settings},
                          joined(overrides, settings));
      });
    }
  }
  wrong.report();
}

void refuse_overridden_draws(const scene::ReadScene& read, const Settings& overrides) {
  scene::CollectedErrors wrong;
  const auto& variables = read.randomness.variables;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    Settings keys = variables[v].set;
    if (!variables[v].key.empty()) keys.push_back(variables[v].key);
    for (const std::string& override_ : scene::overrides_of(read.scene, overrides, keys)) {
      wrong.add({Diagnostic::Severity::error, scene::override_place(override_), 0,
                 fmt::format("[[random]] \"{}\" draws this key, so that it would have no effect", variables[v].name),
                 "keys that no [[random]] draws",
                 fmt::format("leave it out, or change the distribution, as --set random.{}.KEY=VALUE does", v)});
    }
  }
  wrong.report();
}

}  // namespace blockweir::study
