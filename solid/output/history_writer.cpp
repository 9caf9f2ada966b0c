// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/history_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "bridge/results/csv.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"
#include "bridge/scene/unnamed_joint.hpp"

namespace blockweir::solid::output {
namespace {

using Pair = std::pair<int, int>;

/// Touching pairs of blocks without a joint of their own in the scene; empty if they are too many.
std::vector<Pair> unnamed_joints(const scene::Scene& scene) {
  constexpr std::size_t most = 12;
  std::set<Pair> touching = scene::touching_pairs(scene, scene::rounding_ratio * scene::structure_size_m(scene.blocks));
  for (const scene::Joint& joint : scene.joints) touching.erase(std::minmax(joint.between[0], joint.between[1]));
  return touching.size() > most ? std::vector<Pair>() : std::vector<Pair>(touching.begin(), touching.end());
}

std::string header(const scene::Scene& scene, const std::vector<Pair>& unnamed) {
  std::string text =
      "time_s,upstream_level_m,downstream_level_m,largest_displacement_m,kinetic_energy_j_per_m,strain_energy_j_per_m,"
      "potential_energy_j_per_m";
  if (scene.base_motion) {
    // Without a dot, which every column of a block, joint or bolt has: none of them shares the name.
    for (const char* quantity :
         {"displacement_x_m", "displacement_y_m", "acceleration_x_m_per_s2", "acceleration_y_m_per_s2"})
      text += std::string(",base_motion_") + quantity;
  }
  for (const auto& block : scene.blocks) {
    if (block.fixed) continue;
    for (const char* quantity : {"displacement_x_m", "displacement_y_m", "rotation_rad", "velocity_x_m_per_s",
                                 "velocity_y_m_per_s", "rotation_rate_rad_per_s", "stress_xx_pa", "stress_yy_pa",
                                 "stress_xy_pa", "water_force_x_n_per_m", "water_force_y_n_per_m", "water_moment_n"}) {
      text += "," + results::csv_cell(block.name + "." + quantity);
    }
  }
  const auto add_joint = [&](const std::string& name) {
    for (const char* quantity :
         {"normal_force_n_per_m", "shear_force_n_per_m", "slip_m", "opening_m", "bonded_length_m"}) {
      text += "," + results::csv_cell(name + "." + quantity);
    }
  };
  for (const auto& joint : scene.joints) add_joint(joint.name);
  for (const auto& [a, b] : unnamed) add_joint(scene::unnamed_joint(scene, a, b));
  for (const auto& bolt : scene.bolts) {
    for (const char* quantity : {"force_n_per_m", "elongation_m", "plastic_elongation_m", "state"}) {
      text += "," + results::csv_cell(bolt.name + "." + quantity);
    }
  }
  return text;
}

/// Of a joint's contacts.
struct JointSums {
  double normal = 0;
  double shear = 0;
  double slip = 0;
  double opening = 0;
  double bonded = 0;

  void add(const ContactRow& c) {
    normal += c.normal_force_n_per_m;
    shear += c.shear_force_n_per_m;
    slip = std::abs(c.slip_m) > std::abs(slip) ? c.slip_m : slip;
    opening = std::max(opening, c.gap_m);
    bonded += c.bonded_length_m;
  }
};

/// Without the round-off of its sum of windows: 13.2, not 13.200000000000001.
void add_time(double time_s, std::string& row) {
  constexpr int digits = 15;
  std::array<char, 32> text{};
  row.append(text.data(), std::to_chars(text.begin(), text.end(), time_s, std::chars_format::general, digits).ptr);
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& folder, const scene::Scene& scene, results::Begin begin)
    : file_(folder / "history.csv", begin) {
  const std::vector<Pair> unnamed = unnamed_joints(scene);
  if (begin == results::Begin::anew) file_.line(header(scene, unnamed));
  named_joints_ = scene.joints.size();
  for (const Pair& pair : unnamed) unnamed_joints_.emplace(pair, named_joints_ + unnamed_joints_.size());
  shaken_ = scene.base_motion.has_value();
}

void HistoryWriter::write(const Frame& frame) {
  std::string row;
  const auto add = [&](double value) {
    if (!row.empty()) row += ',';
    std::array<char, 32> text{};  // of a double there are 24 characters at most
    row.append(text.data(), std::to_chars(text.begin(), text.end(), value).ptr);
  };
  add_time(frame.time_s, row);
  for (const double v : {frame.upstream_level_m, frame.downstream_level_m, frame.largest_displacement_m,
                         frame.kinetic_energy_j_per_m, frame.strain_energy_j_per_m, frame.potential_energy_j_per_m}) {
    add(v);
  }
  if (shaken_) {
    for (const Point& p : {frame.base_displacement_m, frame.base_acceleration_m_per_s2}) add(p.x()), add(p.y());
  }
  for (const BlockRow& b : frame.blocks) {
    if (b.fixed) continue;
    for (const double v :
         {b.centroid_displacement_m.x(), b.centroid_displacement_m.y(), b.rotation_rad, b.centroid_velocity_m_per_s.x(),
          b.centroid_velocity_m_per_s.y(), b.rotation_rate_rad_per_s, b.stress_xx_pa, b.stress_yy_pa, b.stress_xy_pa,
          b.water_force_n_per_m.x(), b.water_force_n_per_m.y(), b.water_moment_n}) {
      add(v);
    }
  }
  std::vector<JointSums> joints(named_joints_ + unnamed_joints_.size());
  for (const ContactRow& c : frame.contacts) {
    if (c.joint >= 0) {
      joints[at(c.joint)].add(c);
    } else if (const auto own = unnamed_joints_.find(std::minmax(c.vertex_block, c.edge_block));
               own != unnamed_joints_.end()) {
      joints[own->second].add(c);
    }
  }
  for (const JointSums& j : joints) {
    for (const double v : {j.normal, j.shear, j.slip, j.opening, j.bonded}) add(v);
  }
  for (const BoltRow& b : frame.bolts) {
    for (const double v : {b.force_n_per_m, b.elongation_m, b.plastic_elongation_m, static_cast<double>(b.state)}) {
      add(v);
    }
  }
  file_.line(row);
}

}  // namespace blockweir::solid::output
