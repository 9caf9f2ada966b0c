// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/drawing_layers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <map>

#include "bridge/scene/read/nearest.hpp"

namespace blockweir::scene {
namespace {

bool one_in(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_used(const std::string& layer) {
  return layer == "section" || layer == "supports" || !cut_of_layer(layer).empty();
}
bool is_line(const std::string& kind) {
  return one_in(kind, {"LINE", "LWPOLYLINE", "POLYLINE"});
}
bool is_read(const DxfEntity& entity) {
  return entity.layer == "supports" ? entity.kind == "POINT" : is_line(entity.kind);
}
/// Words beside a drawing, no part of the section.
bool is_remark(const std::string& kind) {
  return one_in(kind, {"TEXT", "MTEXT", "RTEXT", "ARCALIGNEDTEXT", "ATTDEF", "ATTRIB", "DIMENSION", "ARC_DIMENSION",
                       "LARGE_RADIAL_DIMENSION", "LEADER", "MULTILEADER", "TOLERANCE", "VIEWPORT"});
}

/// The layers on which entities draw: also within the BLOCK that an INSERT places.
class Inserted {
 public:
  explicit Inserted(const std::vector<DxfEntity>& entities) : entities_(entities) {}

  /// The first layer that is used; empty if none is.
  std::string layer(const DxfEntity& entity) {
    if (is_used(entity.layer)) return is_remark(entity.kind) ? "" : entity.layer;
    if (entity.inserted.empty()) return "";
    const auto [known, is_new] = of_blocks_.try_emplace(entity.inserted);  // a spoiled one may place itself
    for (auto part = entities_.begin(); is_new && part != entities_.end() && known->second.empty(); ++part) {
      if (part->block == entity.inserted) known->second = layer(*part);
    }
    return known->second;
  }

 private:
  const std::vector<DxfEntity>& entities_;
  std::map<std::string, std::string> of_blocks_;
};

std::string remedy_for(const std::string& kind, bool takes_points) {
  if (kind == "INSERT") return "explode it";
  if (takes_points) return "draw a point, or move it to another layer";
  const bool is_curve = one_in(kind, {"ARC", "CIRCLE", "ELLIPSE", "SPLINE"}) || kind.ends_with("with arcs");
  return is_curve ? "approximate it by a polyline, or move it to another layer"
                  : "draw it by lines, or move it to another layer";
}

void refuse_unread(const std::vector<DxfEntity>& entities, const std::string& drawing, Problems& problems) {
  std::map<std::pair<std::string, std::string>, std::vector<int>> unread;  // lines, by kind and layer
  Inserted inserted(entities);
  for (const DxfEntity& entity : entities) {
    if (!entity.block.empty()) continue;
    const std::string layer = inserted.layer(entity);
    if (!layer.empty() && !is_read(entity)) unread[{entity.kind, layer}].push_back(entity.line);
  }
  for (const auto& [what, lines] : unread) {
    const auto& [kind, layer] = what;
    const std::string more = lines.size() > 1 ? fmt::format(", and {} more", lines.size() - 1) : "";
    const bool takes_points = layer == "supports";
    problems.error({drawing, lines.front()},
                   fmt::format("found {} {} the layer \"{}\"{}, which is not read", kind,
                               kind == "INSERT" ? "that draws on" : "on", layer, more),
                   takes_points ? "POINT" : "LINE, LWPOLYLINE or POLYLINE without arcs",
                   remedy_for(kind, takes_points));
  }
}

/// The layer that was probably meant; empty if none is near.
std::string meant(const std::string& layer) {
  for (const auto& [begin, whole] : {std::pair{"section", "section"}, {"joint", "joints"}, {"support", "supports"}}) {
    if (layer.starts_with(begin)) return whole;
  }
  return nearest(layer.substr(0, layer.find_first_of(" -_")), {"section", "joints", "supports"});
}

}  // namespace

std::string cut_of_layer(const std::string& layer) {
  const std::string word = "joints";
  if (layer == word) return "joint";
  const bool named = layer.size() > word.size() + 1 && layer.starts_with(word) &&
                     std::string(" -_").find(layer[word.size()]) != std::string::npos;
  return named ? layer.substr(word.size() + 1) : "";
}

std::string layer_of_cut(const std::string& name) {
  const std::string lower = boost::to_lower_copy(name);
  return lower == "joint" ? "joints" : "joints " + lower;
}

void check_layers(const std::vector<DxfEntity>& entities, const std::filesystem::path& drawing, Problems& problems) {
  refuse_unread(entities, drawing.string(), problems);
  std::map<std::string, int> unused;  // where each begins
  for (const DxfEntity& entity : entities) {
    const bool draws = is_line(entity.kind) || entity.kind == "POINT";
    if (draws && entity.block.empty() && !is_used(entity.layer)) unused.try_emplace(entity.layer, entity.line);
  }
  std::vector<std::string> others;
  for (const auto& [layer, line] : unused) {
    const std::string near = meant(layer);
    if (near.empty()) {
      others.push_back('"' + layer + '"');
      continue;
    }
    problems.warning(
        {drawing.string(), line}, fmt::format("the layer \"{}\" is not used", layer),
        "\"section\", \"joints\", \"joints NAME\" or \"supports\"",
        fmt::format("if you meant {}, rename the layer", near == "joints" ? "joints, or joints NAME" : near));
  }
  if (others.empty()) return;
  problems.note({drawing.string(), 0},
                fmt::format("{} not used: {}", others.size() > 1 ? "layers that are" : "a layer that is",
                            fmt::join(others, ", ")),
                "the section takes \"section\", \"joints\", \"joints NAME\" and \"supports\"");
}

}  // namespace blockweir::scene
