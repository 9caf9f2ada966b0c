// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/report/histories_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "bridge/picture/history.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;

constexpr std::size_t most_rows = 700;

/// Six digits: more cannot be seen, and a figure is read from summary.json.
json brief(double value) {
  return std::isfinite(value) ? json(std::stod(fmt::format("{:.6g}", value))) : json();
}

/// Joints with the largest slip first, then those with forces only.
std::vector<std::string> joints_of(const History& history) {
  std::vector<std::string> joints = history.largest_first("slip_m", "opening_m");
  for (const std::string& name : history.largest_first("normal_force_n_per_m", "shear_force_n_per_m")) {
    if (std::find(joints.begin(), joints.end(), name) == joints.end()) joints.push_back(name);
  }
  return joints;
}

class Pages {
 public:
  explicit Pages(const History& history) : history_(history) {
    const std::size_t count = history.rows();
    const std::size_t every = count / most_rows + 1;
    for (std::size_t i = 0; i < count; i += every) rows_.push_back(i);
    if (count > 0 && rows_.back() != count - 1) rows_.push_back(count - 1);
  }

  [[nodiscard]] json values(const std::string& column, double scale) const {
    json list = json::array();
    for (const std::size_t row : rows_) list.push_back(brief(scale * history_.column(column)[row]));
    return list;
  }

  /// Adds a group of the curves that the run has; nothing if it has none.
  void add(json& groups, const char* title, double rest, const std::vector<std::string>& names,
           const std::string& quantity, double scale = 1) const {
    json curves = json::array();
    for (const std::string& name : names) {
      const std::string column = name.empty() ? quantity : name + "." + quantity;
      if (history_.has_values(column)) curves.push_back({{"name", name}, {"values", values(column, scale)}});
    }
    if (!curves.empty()) groups.push_back({{"title", title}, {"rest", rest}, {"curves", curves}});
  }

 private:
  const History& history_;
  std::vector<std::size_t> rows_;
};

}  // namespace

json histories_data(const std::filesystem::path& run) {
  const History history(run / "history.csv");
  const Pages pages(history);
  const std::size_t most = 8;
  const auto blocks = history.largest_first("displacement_x_m", "displacement_y_m");
  const auto joints = joints_of(history);
  const auto first = [most](std::vector<std::string> names) {
    names.resize(std::min(names.size(), most));
    return names;
  };
  json groups = json::array();
  constexpr double rest_m = 1e-9;  // round-off is no motion
  constexpr double rest_deg = 1e-7;
  constexpr double rest_kn = 1e-3;
  pages.add(groups, "level upstream (m)", rest_m, {""}, "upstream_level_m");
  pages.add(groups, "level downstream (m)", rest_m, {""}, "downstream_level_m");
  pages.add(groups, "horizontal displacement, downstream positive (m)", rest_m, first(blocks), "displacement_x_m");
  pages.add(groups, "vertical displacement, upwards positive (m)", rest_m, first(blocks), "displacement_y_m");
  pages.add(groups, "rotation, counter-clockwise (deg)", rest_deg, first(blocks), "rotation_rad",
            180 / std::numbers::pi);
  pages.add(groups, "normal force of joints (kN/m)", rest_kn, first(joints), "normal_force_n_per_m", 1e-3);
  pages.add(groups, "shear force of joints (kN/m)", rest_kn, first(joints), "shear_force_n_per_m", 1e-3);
  json data = {{"time", pages.values("time_s", 1)}, {"groups", groups}, {"left_out", ""}};
  if (blocks.size() > most || joints.size() > most) {
    data["left_out"] = fmt::format(
        "Shown are the {} blocks and joints that move most; history.csv has all {} blocks that move and all {} joints.",
        most, blocks.size(), joints.size());
  }
  return data;
}

}  // namespace blockweir::picture
