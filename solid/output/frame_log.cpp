// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/frame_log.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace blockweir::solid::output {
namespace {

/// Of the two principal stresses the larger in size.
double larger_principal(const Eigen::Vector3d& stress) {
  const double mean = (stress[0] + stress[1]) / 2;
  return mean + std::copysign(std::hypot((stress[0] - stress[1]) / 2, stress[2]), mean);
}

}  // namespace

void FrameLog::write(const Frame& frame) {
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  const auto level = [](double value) {
    return std::isnan(value) ? std::string("null") : fmt::format("{:.9g}", value);
  };
  const auto separator = [](bool& first) { return std::exchange(first, false) ? "" : ","; };
  fmt::format_to(out, R"({{"time_s":{:.9g},"upstream_level_m":{},"downstream_level_m":{},"blocks":[)", frame.time_s,
                 level(frame.upstream_level_m), level(frame.downstream_level_m));
  bool first_block = true;
  for (const BlockRow& block : frame.blocks) {
    fmt::format_to(out, R"({}{{"fixed":{},"outline":[)", separator(first_block), block.fixed);
    bool first = true;
    for (const Point& p : block.vertices_m) fmt::format_to(out, "{}[{:.9g},{:.9g}]", separator(first), p.x(), p.y());
    fmt::format_to(out, "]}}");
  }
  fmt::format_to(out, R"(],"contacts":[)");
  bool first_contact = true;
  for (const ContactRow& c : frame.contacts) {
    fmt::format_to(out, "{}[{:.9g},{:.9g},{}]", separator(first_contact), c.point_m.x(), c.point_m.y(), c.state);
  }
  fmt::format_to(out, R"(],"panels":[)");
  bool first_panel = true;
  for (const PanelRow& p : frame.panels) {
    fmt::format_to(out, "{}[{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{}]", separator(first_panel), p.from_m.x(),
                   p.from_m.y(), p.to_m.x(), p.to_m.y(), p.pressure_from_pa, p.pressure_to_pa, p.in_crack ? 1 : 0);
  }
  fmt::format_to(out, R"(],"bolts":[)");
  bool first_bolt = true;
  for (const BoltRow& b : frame.bolts) {
    fmt::format_to(out, "{}[{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{}]", separator(first_bolt), b.from_m.x(), b.from_m.y(),
                   b.to_m.x(), b.to_m.y(), b.force_n_per_m, b.state);
  }
  if (!frame.meshes.empty()) {
    fmt::format_to(out, R"(],"triangles":[)");  // corners and principal stress
    bool first = true;
    for (const MeshRow& mesh : frame.meshes) {
      for (const auto& triangle : mesh.triangles) {
        Eigen::Vector3d stress = Eigen::Vector3d::Zero();
        fmt::format_to(out, "{}[", separator(first));
        for (const int corner : triangle) {
          const Point& p = mesh.nodes_m[static_cast<std::size_t>(corner)];
          stress += mesh.stress_pa[static_cast<std::size_t>(corner)] / 3;
          fmt::format_to(out, "{:.7g},{:.7g},", p.x(), p.y());
        }
        fmt::format_to(out, "{:.5g}]", larger_principal(stress));
      }
    }
  }
  fmt::format_to(out, "]}}");
  file_.line(fmt::to_string(text));
}

}  // namespace blockweir::solid::output
