// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/uplift_in_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/scene/cracks.hpp"

namespace blockweir::solid {
namespace {

using scene::Crack;
using scene::Uplift;

constexpr double seen = 1e-2;  // of a joint's length

struct Ends {
  Point upstream_m;
  Point downstream_m;
};

/// Blocks have strained a little where the ends are from.
bool are_of(const Ends& ends, const Crack& crack) {
  constexpr double strained = 1e-2;
  const double length_m = (ends.downstream_m - ends.upstream_m).norm();
  const double off_m = strained * length_m;
  return std::abs(crack.length_m - length_m) < off_m && (crack.end() - ends.downstream_m).norm() < off_m;
}

/// How such a law treats a crack; nullptr for those that follow it, or have the full pressure anyway.
const char* makes_of_a_crack(Uplift law) {
  switch (law) {
    case Uplift::drained:
    case Uplift::triangular:
      return "takes it to be closed";
    case Uplift::flow:
      return "lets water through it as if its faces touched";
    case Uplift::none:
      return "keeps water out of it";
    case Uplift::heads:
      return "keeps its heads where the crack has run past them";
    default:
      return nullptr;
  }
}

/// The scene's joints by the law of their water, looked for once.
class LawsOfJoints {
 public:
  explicit LawsOfJoints(const scene::Scene& scene)
      : cracks_(scene::find_cracks(scene)),
        flow_(scene::find_joints(scene, Uplift::flow)),
        dry_(scene::find_joints(scene, Uplift::none)) {}

  /// The law of the water between these ends, where all of the joint or that at its upstream end takes it to be closed.
  [[nodiscard]] std::optional<Uplift> closing(const Ends& ends) const {
    const auto law = between(ends);
    return law && makes_of_a_crack(*law) != nullptr ? law : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<Uplift> between(const Ends& ends) const {
    const auto crack = std::find_if(cracks_.begin(), cracks_.end(), [&](const Crack& c) { return are_of(ends, c); });
    if (crack != cracks_.end()) return crack->law;
    if (begins_at(flow_, ends)) return Uplift::flow;
    if (begins_at(dry_, ends)) return Uplift::none;
    return std::nullopt;
  }
  static bool begins_at(const std::vector<Crack>& joints, const Ends& ends) {
    constexpr double strained = 1e-2;
    const double near_m = strained * (ends.downstream_m - ends.upstream_m).norm();
    return std::any_of(joints.begin(), joints.end(), [&](const Crack& joint) {
      return (joint.mouth() - ends.upstream_m).norm() < near_m || (joint.end() - ends.upstream_m).norm() < near_m;
    });
  }

  std::vector<Crack> cracks_;
  std::vector<Crack> flow_;
  std::vector<Crack> dry_;
};

/// The level of the pool at the end that opens, the one farther from the resultant; none: there is air in the crack.
std::optional<double> level_at_the_mouth(const Levels& levels, const Ends& ends, double resultant_from_downstream) {
  const bool at_heel = resultant_from_downstream < 0.5;
  const double level_m = levels.of(!at_heel);
  if ((at_heel ? ends.upstream_m : ends.downstream_m).y() < level_m) return level_m;
  return std::nullopt;
}

std::string words(const std::string& joint, const std::string& when, double share, Uplift law) {
  return fmt::format(
      "joint \"{}\" is in tension{} over {:.3g} % of its length, by the gravity method, and uplift = \"{}\" {}; water "
      "in a crack has the full pressure of its mouth: state uplift = \"cracked\"",
      joint, when, 100 * share, scene::named(law).name, makes_of_a_crack(law));
}

}  // namespace

std::vector<std::string> uplift_warnings(const scene::Scene& scene, const Levels& levels,
                                         const std::vector<JointRow>& rows) {
  std::vector<std::string> warnings;
  const LawsOfJoints laws(scene);
  for (const JointRow& row : rows) {
    if (row.cracked_length_m <= seen * row.faces_length_m) continue;
    const Ends ends{row.upstream_end_m, row.downstream_end_m};
    const auto law = laws.closing(ends);
    if (!law) continue;
    if (!level_at_the_mouth(levels, ends, *row.resultant_from_downstream)) continue;
    warnings.push_back(words(row.name, "", row.cracked_length_m / row.faces_length_m, *law));
  }
  return warnings;
}

void OpenedJoints::look(const Surfaces& surfaces, const std::vector<SurfaceSum>& sums, const Levels& levels) {
  opened_.resize(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const SurfaceSum& sum = sums[i];
    if (!sum.bears(surfaces.weights()[i]) || !sum.is_pressed()) continue;
    const double share = std::min(1.0, 1 - 3 * sum.end_distance());
    Opened& opened = opened_[i];
    if (share <= std::max(seen, opened.share)) continue;
    const auto level_m =
        level_at_the_mouth(levels, {sum.upstream_end(), sum.downstream_end()}, sum.resultant_from_downstream());
    if (!level_m) continue;
    const double from_m = opened.share > 0 ? opened.from_level_m : *level_m;
    opened = {surfaces.names()[i], sum.upstream_end(), sum.downstream_end(), from_m, *level_m, share};
  }
}

std::string OpenedJoints::warning(const scene::Scene& scene) const {
  if (std::none_of(opened_.begin(), opened_.end(), [](const Opened& o) { return o.share > 0; })) return {};
  const LawsOfJoints laws(scene);
  const Opened* worst = nullptr;
  Uplift its_law{};
  int others = -1;
  for (const Opened& opened : opened_) {
    if (opened.share == 0) continue;
    const auto law = laws.closing({opened.upstream_end_m, opened.downstream_end_m});
    if (!law) continue;
    ++others;
    if (worst != nullptr && worst->share >= opened.share) continue;
    worst = &opened;
    its_law = *law;
  }
  if (worst == nullptr) return {};
  const std::string when =
      worst->from_level_m == worst->worst_level_m
          ? fmt::format(" at a level of {:.4g} m", worst->worst_level_m)
          : fmt::format(" from a level of {:.4g} m on, at {:.4g} m", worst->from_level_m, worst->worst_level_m);
  return words(worst->name, when, worst->share, its_law) +
         (others > 0 ? fmt::format("; so {} {} more", others == 1 ? "is" : "are", others) : "");
}

}  // namespace blockweir::solid
