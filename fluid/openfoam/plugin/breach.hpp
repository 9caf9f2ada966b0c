// SPDX-License-Identifier: GPL-3.0-or-later
// Detects a breach: open water has found a way past the structure that did not exist at the start.
#pragma once

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// A way is a chain of neighbouring cells from one side of the structure to the other, below its highest point at the
/// start: overtopping does not count, and water does that flows where the structure stood. Each cell is more than half
/// open, and its open part more than half full of water.
class Breach {
 public:
  /// Uses entries upstreamTo and downstreamFrom of constant/blockweir: the structure's extent.
  Breach(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks);

  /// Collective call: all ranks get the same result. Stays true once there is a way; always false if there was one at
  /// the first call. Costs nothing until a block has moved by a cell.
  bool look();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(looked_, open_from_start_, found_);
  }

 private:
  [[nodiscard]] bool moved() const;
  [[nodiscard]] bool is_open() const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  double upstream_to_ = 0;
  double downstream_from_ = 0;
  bool looked_ = false;
  bool open_from_start_ = false;
  bool found_ = false;
};

}  // namespace blockweir::openfoam
