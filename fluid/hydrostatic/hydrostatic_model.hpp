// SPDX-License-Identifier: GPL-3.0-or-later
// The reference fluid: still water in two pools and in the cracks that the scene fills, at the blocks' positions.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "bridge/schedule/sides.hpp"
#include "fluid/hydrostatic/cracks.hpp"
#include "fluid/hydrostatic/interface_mesh.hpp"
#include "fluid/hydrostatic/reservoir_mesh.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// Elements of the drawn reservoir, to its depth and on an edge that is wet all along: those of the load, or more.
inline int elements_drawn(const scene::Water& water) {
  return std::max(water.elements_per_face, 20);
}

/// A pool's section, with elements on the blocks.
struct PoolSection {
  Hydrostatics water;
  std::vector<Ring> region;
  std::vector<InterfaceElement> interface;
};

class HydrostaticModel final : public schedule::FluidSide {
 public:
  explicit HydrostaticModel(const scene::Scene& scene);

  /// Pressures at the levels of time `to_s` on blocks that are where `motion` says. Throws std::runtime_error when
  /// `motion` does not fit the scene.
  void advance(const wire::Motion& motion, double to_s, wire::Load& load) override;
  [[nodiscard]] bool remembers() const override { return false; }
  [[nodiscard]] std::string state() const override;
  void restore(const std::string& state) override;

  /// The pools as they were at the last advance().
  [[nodiscard]] const std::vector<PoolSection>& pools() const { return pools_; }
  [[nodiscard]] long updates() const { return updates_; }  ///< windows whose pressures were computed
  [[nodiscard]] schedule::FluidReport report() const override;

 private:
  /// What water at this level wets of the blocks where they are.
  struct Wetted {
    double level_m = 0;
    WetFaces faces;
  };
  void press(wire::Load& load);
  void place(const wire::Motion& motion);
  [[nodiscard]] const WetFaces& wet_part(Pool pool, double level_m);
  void add_pool(Pool pool, double level_m, wire::Load& load);
  void add_cracks(double upstream_m, double downstream_m, wire::Load& load);

  const scene::Scene& scene_;
  std::vector<Point> centroids_;
  std::vector<Crack> cracks_;
  std::vector<std::vector<Point>> outlines_;     ///< current
  std::array<std::optional<Wetted>, 2> wetted_;  ///< of the pools, while no block moves
  std::array<bool, 2> behind_{};                 ///< is water of the pools behind the crest?
  std::vector<PoolSection> pools_;
  wire::Motion last_motion_;
  double last_upstream_m_ = 0;
  double last_downstream_m_ = 0;
  bool fresh_ = true;
  long updates_ = 0;
  long unchanged_ = 0;  ///< windows in which neither level nor block moved
  long wettings_ = 0;   ///< searches for wet faces
  long kept_faces_ = 0;
  double mapping_s_ = 0;
  double update_s_ = 0;
};

}  // namespace blockweir::hydrostatic
