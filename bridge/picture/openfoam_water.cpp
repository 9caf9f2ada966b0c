// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/openfoam_water.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "bridge/process/programs.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;
constexpr double least_water = 0.01;

/// The internal field, `width` numbers a cell; empty where the file is not one of `cells` cells.
std::vector<double> read_field(const fs::path& file, std::size_t cells, std::size_t width) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream all;
  all << stream.rdbuf();
  const std::string text = all.str();
  const bool binary = text.find("format      binary") != std::string::npos;
  std::size_t at = text.find("internalField");
  if (at == std::string::npos) return {};
  const std::size_t line_end = text.find('\n', at);
  const std::string line = text.substr(at, line_end - at);
  std::vector<double> values;
  if (line.find("nonuniform") == std::string::npos) return std::vector<double>(cells * width, 0);  // only at rest
  at = text.find_first_of("0123456789", line_end);
  std::size_t count = 0;
  std::from_chars(text.data() + at, text.data() + text.size(), count);
  at = text.find('(', at) + 1;
  if (count != cells) return {};
  values.resize(cells * width);
  if (binary) {
    if (at + values.size() * sizeof(double) > text.size()) return {};
    std::memcpy(values.data(), text.data() + at, values.size() * sizeof(double));
    return values;
  }
  for (double& value : values) {
    at = text.find_first_not_of("() \n", at);
    if (at == std::string::npos) return {};
    at =
        static_cast<std::size_t>(std::from_chars(text.data() + at, text.data() + text.size(), value).ptr - text.data());
  }
  return values;
}

}  // namespace

OpenFoamWater::OpenFoamWater(const fs::path& run) {
  const fs::path folder = run / "openfoam";
  std::ifstream stream(folder / "grid.json");
  const auto grid = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  if (!grid.is_object()) return;
  x_ = grid.value("x_m", std::vector<double>());
  y_ = grid.value("y_m", std::vector<double>());
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    double time = 0;
    const auto end = std::from_chars(name.data(), name.data() + name.size(), time);
    if (end.ptr == name.data() + name.size() && entry.is_directory()) times_.push_back({time, entry.path()});
  }
}

std::vector<WaterBox> OpenFoamWater::boxes(double time_s) const {
  const auto nearest = std::min_element(times_.begin(), times_.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.time_s - time_s) < std::abs(b.time_s - time_s);
  });
  if (nearest == times_.end() || x_.size() < 2 || y_.size() < 2) return {};
  const std::size_t columns = x_.size() - 1;
  const std::size_t rows = y_.size() - 1;
  const std::vector<double> water = read_field(nearest->folder / "alpha.water", columns * rows, 1);
  const std::vector<double> velocity = read_field(nearest->folder / "U", columns * rows, 3);
  if (water.empty() || velocity.empty()) return {};
  const auto share_at = [&](std::size_t i, std::size_t j) { return j < rows ? water[j * columns + i] : 0; };
  std::vector<WaterBox> boxes;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t cell = j * columns + i;
      const double share = std::min(1.0, water[cell]);
      if (share < least_water) continue;
      WaterBox box{x_[i], x_[i + 1], y_[j], y_[j + 1], share, std::hypot(velocity[3 * cell], velocity[3 * cell + 1])};
      // A cell of water above a wet cell is drawn to its level; spray is drawn pale over the whole cell.
      const bool stands = j == 0 || share_at(i, j - 1) > 0.5;
      if (stands && share_at(i, j + 1) < least_water) {
        box.top = box.bottom + share * (box.top - box.bottom);
        box.share = 1;
      }
      boxes.push_back(box);
    }
  }
  return boxes;
}

std::vector<std::vector<geometry::Point>> all_drawn_water(const fs::path& run, const nlohmann::json& first_frame) {
  const bool pools = first_frame["upstream_level_m"].is_number() || first_frame["downstream_level_m"].is_number();
  if (pools) return {};
  return scene::read(process::scene_of(run)).scene.openfoam.initial_water_m;
}

View with_drawn_water(View view, const std::vector<std::vector<geometry::Point>>& outlines) {
  const double farthest = 5 * std::max(view.right - view.left, view.top - view.bottom);
  const View most{view.left - farthest, view.right + farthest, view.bottom - farthest, view.top + farthest};
  for (const auto& outline : outlines) {
    for (const geometry::Point& p : outline) {
      view.include(std::clamp(p.x(), most.left, most.right), std::clamp(p.y(), most.bottom, most.top));
    }
  }
  if (!outlines.empty()) view.top += 0.1 * (view.top - view.bottom);  // room for its splashes
  return view;
}

}  // namespace blockweir::picture
