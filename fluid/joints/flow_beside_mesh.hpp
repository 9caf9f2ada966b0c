// SPDX-License-Identifier: GPL-3.0-or-later
// The flow through joints beside water that a mesh carries: OpenFOAM's plugin gives what presses on open faces and
// takes the panels of the joints. C++17, which the plugin is, though what it holds is not: a scene reaches it as bytes.
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

  /// `scene`: what flow_scene.hpp has packed. Gaps of more than `open_m` are no joints: the mesh carries their water.
  /// Tables go to `folder`; empty: nowhere.
  FlowBesideMesh(const std::string& scene, double open_m, const std::string& folder);
  ~FlowBesideMesh();

  /// Solves for time `to_s` and adds the joints' panels behind those of `load`, which are open water.
  void advance(const Outlines& outlines, double to_s, wire::Load& load);
  /// Of the time that it was advanced to last.
  void record(double time_s);
  /// What it stores changes its pressures even while nothing else does.
  [[nodiscard]] bool changes_by_itself() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace blockweir::joints
