// SPDX-License-Identifier: GPL-3.0-or-later
// The network of joints of a scene at the present positions: stretches of joints divided into channels, coinciding ends
// merged into nodes, and the boundary condition of each node.
#pragma once

#include <optional>
#include <vector>

#include "fluid/joints/joint_stretches.hpp"
#include "fluid/joints/network.hpp"
#include "fluid/joints/open_water.hpp"

namespace blockweir::joints {

/// Ends of the model where the ground continues, as drawn: no water enters or leaves there.
struct GroundCut {
  std::optional<Point> left;  ///< corner of the bed
  std::optional<Point> right;
  double bottom_m = 0;
};

/// The cut of a scene; empty if no water flows in joints.
GroundCut ground_cut(const scene::Scene& scene);

/// The part of a stretch that a channel covers; shares 0..1 of the stretch.
struct Part {
  std::size_t stretch = 0;
  double from = 0;
  double to = 1;
  bool open = false;  ///< filled by open water
};

/// Properties of a node that the network itself does not need.
struct Place {
  Point at;
  std::vector<int> blocks{};
  double gap_m = 0;      ///< widest gap that ends there
  bool exposed = false;  ///< open space is beside it, of which a way leads out
  bool on_cut = false;   ///< at an end of the model where the ground continues
  bool in_open = false;  ///< in open water within a joint
  int drain = -1;        ///< drain of the scene; -1: none
};

class JointNetwork {
 public:
  /// Faces farther apart than `open_m` are not a joint.
  JointNetwork(const scene::Scene& scene, const GroundCut& ground, double open_m);

  [[nodiscard]] bool empty() const { return search_.empty(); }
  /// Updates the network for moved blocks; `ground_m`: displacement of their ground.
  void follow(const std::vector<std::vector<Point>>& outlines, const Point& ground_m);
  /// Updates it for open water: channels, and the pressure of held nodes. Drains hold their own head.
  void fill(const OpenWater& open);

  [[nodiscard]] Network& network() { return network_; }
  [[nodiscard]] const Network& network() const { return network_; }
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }  ///< by node
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }     ///< by channel
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  [[nodiscard]] std::string name(const Stretch& stretch) const { return search_.name(stretch); }

 private:
  void join_ends();
  void find_exposed(const std::vector<std::vector<Point>>& outlines, const Point& ground_m);
  [[nodiscard]] bool is_cut(const Place& place, const Point& ground_m) const;
  void add_channels(std::size_t stretch, const OpenWater& open);
  [[nodiscard]] std::vector<double> cuts(const Stretch& stretch, const OpenWater& open) const;
  [[nodiscard]] double closed_aperture(const Stretch& stretch, double share) const;
  [[nodiscard]] int drain_at(const Point& p) const;
  [[nodiscard]] Node node_at(Place& place, const OpenWater& open) const;

  const scene::Scene& scene_;
  GroundCut ground_;
  JointStretches search_;
  double touching_m_ = 0;
  std::vector<Stretch> stretches_;
  std::vector<std::array<int, 2>> ends_;  ///< nodes of each stretch
  std::vector<Place> joined_;             ///< nodes at ends of stretches
  std::vector<Place> places_;
  std::vector<Part> parts_;
  Network network_;
};

}  // namespace blockweir::joints
