// SPDX-License-Identifier: GPL-3.0-or-later
// Has open water found a way past the structure that was not there at the start?
#pragma once

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// A way is a chain of neighbouring cells, each more than half open and the open part more than half full of water,
/// from one side of the structure to the other, below the structure's highest point: what flows over the crest is none.
class Breach {
 public:
  /// Entries upstreamTo and downstreamFrom of constant/blockweir: the structure's extent.
  Breach(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks);

  /// The same on all ranks, which all call it. True for good once there is a way; never where there was one at the
  /// first call. Costs nothing until a block has moved by a cell.
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
