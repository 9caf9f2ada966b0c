// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of all islands, kept over steps.
#pragma once

#include <utility>
#include <vector>

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class StepIslands : StepPart {
 public:
  StepIslands(StepWorkspace& step, const WaterInertia& water)
      : StepPart(step), water_(water), numbers_(step.model.blocks.size()) {}

  /// Islands, and with them the symbolic factorizations, are kept while the contact graph stands.
  void prepare();
  void clear() { all_.clear(); }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] auto begin() { return all_.begin(); }
  [[nodiscard]] auto end() { return all_.end(); }
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }

  /// With what factors of the islands' matrices were made of.
  template <class Archive>
  void serialize(Archive& archive) {
    std::vector<KeptFactors> kept = kept_factors();
    archive(links_, kept);
    if (!Archive::is_loading::value) return;
    clear();
    kept_ = std::move(kept);
  }

 private:
  [[nodiscard]] std::vector<KeptFactors> kept_factors() const;
  [[nodiscard]] std::vector<std::pair<int, int>> links() const;
  [[nodiscard]] int part_of(int motion) const;
  void make();
  void give_bolts_to_islands();
  void find_incidences();

  const WaterInertia& water_;
  std::vector<IslandEquations> all_;
  std::vector<std::pair<int, int>> links_;
  std::vector<int> numbers_;       ///< index of a block within its island
  std::vector<KeptFactors> kept_;  ///< from a checkpoint: of the islands that its contacts make
};

}  // namespace blockweir::solid
