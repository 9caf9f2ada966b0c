// SPDX-License-Identifier: GPL-3.0-or-later
// The levels that the ways of `level` find for one scene, and why they differ.
#pragma once

#include <optional>
#include <string>

#include "solid/answers/answer_entries.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/limit/limit_level.hpp"

namespace blockweir::solid {

struct FoundLevels {
  const scene::Scene& scene;
  bool any_force = false;  ///< by anchors, in limit analysis
  double empty_m = 0;      ///< level of the empty reservoir
  Attempt<limit::LimitLevel> limit;
  Attempt<StaticLevel> blocks;
  Attempt<StaticLevel> rigid;  ///< of the same blocks without strain, where they strain

  /// Of a level to that of limit analysis, over the rise from the empty reservoir.
  [[nodiscard]] double off(const StaticLevel& found) const;
  /// Of rigid blocks, if they fail (m).
  [[nodiscard]] std::optional<double> rigid_level() const;
  /// Do the blocks and limit analysis agree, and no other analysis of the blocks fails at another level?
  [[nodiscard]] bool agree() const;
  /// Why the blocks' level differs from that of limit analysis and from that of rigid blocks.
  [[nodiscard]] std::string reason() const;

 private:
  [[nodiscard]] bool agrees(const StaticLevel& found) const;
  [[nodiscard]] bool rigid_fails_lower() const;
  [[nodiscard]] bool is_lower() const;
  [[nodiscard]] std::string of_friction_history() const;
  [[nodiscard]] std::string of_deformation() const;
  [[nodiscard]] std::string of_an_upper_bound() const;
};

}  // namespace blockweir::solid
