// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/mechanism_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bridge/scene/at.hpp"
#include "bridge/scene/unnamed_joint.hpp"

namespace blockweir::solid::limit {
namespace {

constexpr double seen = 1e-4;  // of the fastest vertex: what rounded outlines turn by is less

std::string joint_name(const scene::Scene& scene, const Face& face) {
  if (face.joint < 0) return scene::unnamed_joint(scene, face.a, face.b);
  const scene::Joint& joint = scene.joints[at(face.joint)];
  return joint.set.empty() ? joint.name : joint.set;
}

/// The end of a face on the upstream side: smaller x, of equal ones the higher.
const Point& upstream_end(const Face& face) {
  const bool first =
      face.from_m.x() != face.to_m.x() ? face.from_m.x() < face.to_m.x() : face.from_m.y() > face.to_m.y();
  return first ? face.from_m : face.to_m;
}

/// `"a"`, `"a" and "b"`, `"a", "b", "c" and 5 more`
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  const std::size_t shown = names.size() > most ? most - 1 : names.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == names.size();
    text += fmt::format("{}\"{}\"", i == 0 ? "" : last ? " and " : ", ", names[i]);
  }
  return shown == names.size() ? text : fmt::format("{} and {} more", text, names.size() - shown);
}

/// Faces at which bodies part, and how.
struct Parting {
  std::vector<const Face*> faces;
  bool slips = false;
  bool turns = false;
  bool dilates = false;
};

Parting parting_of(const LimitAnalysis& structure, const Twists& mechanism) {
  Parting parting;
  for (const Face& face : structure.faces()) {
    const Point at_from = structure.jump(face, mechanism, face.from_m);
    const Point at_to = structure.jump(face, mechanism, face.to_m);
    if (std::max(at_from.norm(), at_to.norm()) < seen) continue;
    parting.faces.push_back(&face);
    const bool turned = (at_to - at_from).norm() > seen;
    parting.turns = parting.turns || turned;
    const bool slips = std::abs(face.along().dot(at_from)) > seen;
    parting.slips = parting.slips || slips;
    const double opening = std::min(face.normal.dot(at_from), face.normal.dot(at_to));
    parting.dilates = parting.dilates || (slips && face.friction > 0 && opening > seen);
  }
  return parting;
}

/// Do the faces part all along, by more than a slide rises? By the associated rule it rises by tan(phi) over the
/// strength's reduction, which is 1/2 at least in what is of interest.
bool opens(const LimitAnalysis& structure, const Twists& mechanism, const Face& face) {
  constexpr double least_reduction = 0.5;
  const auto ends = face.ends();
  return std::all_of(ends.begin(), ends.end(), [&](const Point& end) {
    const Point jump = structure.jump(face, mechanism, end);
    return face.normal.dot(jump) > face.friction / least_reduction * std::abs(face.along().dot(jump)) + seen;
  });
}

struct Motion {
  const char* mode;
  const char* of_one;
  const char* of_more;
};

Motion motion_of(const Parting& parting) {
  if (parting.faces.empty()) return {"falling", "falls", "fall"};
  if (parting.turns && parting.slips)
    return {"sliding and overturning", "slides and turns over", "slide and turn over"};
  if (parting.turns) return {"overturning", "turns over", "turn over"};
  if (parting.slips) return {"sliding", "slides", "slide"};
  return {"lifting", "lifts off", "lift off"};
}

}  // namespace

MechanismDescription words_of(const LimitAnalysis& structure, const Twists& mechanism) {
  const scene::Scene& scene = structure.scene();
  MechanismDescription words;
  std::vector<std::string> names;
  for (std::size_t b = 0; b < mechanism.size(); ++b) {
    const bool moves = std::any_of(
        scene.blocks[b].vertices.begin(), scene.blocks[b].vertices.end(),
        [&](const Point& p) { return velocity_at(mechanism[b], p, structure.centroids()[b]).norm() > seen; });
    if (!moves) continue;
    words.moving.push_back(b);
    names.push_back(scene.blocks[b].name);
  }
  Parting parting = parting_of(structure, mechanism);
  std::set<std::string> closed;  // joints on which something slides or turns
  std::sort(parting.faces.begin(), parting.faces.end(),
            [](const Face* f, const Face* g) { return upstream_end(*f).x() < upstream_end(*g).x(); });
  for (const Face* face : parting.faces) {
    const std::string name = joint_name(scene, *face);
    if (std::find(words.joints.begin(), words.joints.end(), name) == words.joints.end()) words.joints.push_back(name);
    if (!opens(structure, mechanism, *face)) closed.insert(name);
  }
  if (!parting.faces.empty()) words.mouth_m = upstream_end(*parting.faces.front());
  const Motion motion = motion_of(parting);
  words.mode = motion.mode;
  words.dilates = parting.dilates;
  const bool one = names.size() == 1;
  words.text = fmt::format("{} {} {}", one ? "block" : "blocks", listed(names), one ? motion.of_one : motion.of_more);
  if (words.joints.empty()) return words;
  const auto joints = [](const std::vector<std::string>& all) {
    return fmt::format("{} {}", all.size() == 1 ? "joint" : "joints", listed(all));
  };
  std::vector<std::string> on;
  std::vector<std::string> open;
  for (const std::string& name : words.joints) (closed.contains(name) ? on : open).push_back(name);
  if (on.empty()) std::swap(on, open);
  words.text += " on " + joints(on);
  if (!open.empty()) words.text += fmt::format("; {} {}", joints(open), open.size() == 1 ? "opens" : "open");
  return words;
}

}  // namespace blockweir::solid::limit
