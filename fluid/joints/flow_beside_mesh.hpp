// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through joints beside water that is computed in a mesh. OpenFOAM's plugin supplies the pressure on open faces
// and receives the panels of the joints. C++17, like the plugin; a scene (C++20) reaches it as bytes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "bridge/wire/message.hpp"

namespace blockweir::joints {

class FlowBesideMesh {
 public:
  using Outlines = std::vector<std::vector<Eigen::Vector2d>>;

  /// `scene`: packed by flow_scene.hpp. Gaps wider than `open_m` are not joints: the mesh contains their water. Tables
  /// are written to `folder`; empty: none.
  FlowBesideMesh(const std::string& scene, double open_m, const std::string& folder);
  ~FlowBesideMesh();

  /// Solves for time `to_s` and appends the joints' panels to those of `load`, which are open water.
  void advance(const Outlines& outlines, double to_s, wire::Load& load);
  /// Records the time of the last advance().
  void record(double time_s);
  /// Whether its pressures change by storage while nothing else does.
  [[nodiscard]] bool changes_by_itself() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace blockweir::joints
