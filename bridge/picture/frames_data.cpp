// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/frames_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/picture/frames.hpp"
#include "bridge/picture/still_pools.hpp"

namespace blockweir::picture {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// To a fraction of the picture that nobody sees, which makes the file a third as large.
class Rounded {
 public:
  explicit Rounded(const View& view) {
    constexpr double finest = 2e-5;
    const double size = std::max(view.right - view.left, view.top - view.bottom);
    unit_ = std::pow(10.0, std::floor(std::log10(finest * size)));
  }
  [[nodiscard]] json operator()(double metres) const {
    const double steps = std::round(metres / unit_);
    return unit_ < 1 ? steps / std::round(1 / unit_) : steps * unit_;
  }
  [[nodiscard]] json point(double x, double y) const { return {(*this)(x), (*this)(y)}; }

 private:
  double unit_;
};

std::size_t numbers_in(const json& frame) {
  std::size_t count = 0;
  for (const json& block : frame["blocks"]) count += 2 * block["outline"].size();
  return count + 7 * frame["panels"].size() + 3 * frame["contacts"].size();
}

/// The last frame up to `failure_s`, or of all (null).
std::size_t pictured_frame(const std::vector<json>& frames, const json& failure_s) {
  if (failure_s.is_null()) return frames.size() - 1;
  const auto after = std::find_if(frames.begin(), frames.end(), [&](const json& frame) {
    return frame["time_s"].get<double>() > failure_s.get<double>();
  });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - frames.begin())) - 1;
}

/// Evenly in time, with the pictured one.
std::vector<json> thinned(std::vector<json> frames, std::size_t pictured) {
  constexpr std::size_t most_frames = 300;
  constexpr std::size_t most_numbers = 100'000;  // some 700 kB
  std::size_t all = 0;
  for (const json& frame : frames) all += numbers_in(frame);
  const std::size_t fewer = std::max(frames.size() / most_frames, all / most_numbers) + 1;
  if (fewer == 1) return frames;
  std::vector<json> kept;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i % fewer == 0 || i == pictured || i + 1 == frames.size()) kept.push_back(std::move(frames[i]));
  }
  return kept;
}

/// Whether the panel is on fixed ground, where it loads no block.
bool on_ground(const json& frame, const json& panel, double near_m) {
  const Eigen::Vector2d middle(panel[0].get<double>() / 2 + panel[2].get<double>() / 2,
                               panel[1].get<double>() / 2 + panel[3].get<double>() / 2);
  for (const json& block : frame["blocks"]) {
    if (!block["fixed"].get<bool>()) continue;
    const json& outline = block["outline"];
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const json& next = outline[(i + 1) % outline.size()];
      const Eigen::Vector2d from(outline[i][0], outline[i][1]);
      const Eigen::Vector2d span = Eigen::Vector2d(next[0], next[1]) - from;
      const double share = std::clamp(span.dot(middle - from) / span.squaredNorm(), 0.0, 1.0);
      if ((from + share * span - middle).norm() < near_m) return true;
    }
  }
  return false;
}

json pressure(double pa) {
  return std::round(pa / 10) * 10;
}

json page_frame(const json& frame, const View& view, const Rounded& rounded, bool has_pools) {
  json outlines = json::array();
  for (const json& block : frame["blocks"]) {
    json& outline = outlines.emplace_back(json::array());
    for (const json& p : block["outline"]) outline.push_back(rounded.point(p[0], p[1]));
  }
  json pools = json::array();
  if (has_pools) {
    for (const auto& pool : still_pools(frame, view)) {
      json& outline = pools.emplace_back(json::array());
      for (const Eigen::Vector2d& p : pool) outline.push_back(rounded.point(p.x(), p.y()));
    }
  }
  json panels = json::array();
  const double near_m = 1e-6 * (view.right - view.left);
  for (const json& p : frame["panels"]) {
    const bool in_crack = p[6] != 0;
    if (!in_crack && on_ground(frame, p, near_m)) continue;
    panels.push_back(
        {rounded(p[0]), rounded(p[1]), rounded(p[2]), rounded(p[3]), pressure(p[4]), pressure(p[5]), p[6]});
  }
  json contacts = json::array();
  for (const json& c : frame["contacts"]) {
    if (c[2].get<int>() > 0) contacts.push_back({rounded(c[0]), rounded(c[1]), c[2]});
  }
  return {{"t", frame["time_s"]},
          {"upstream", frame["upstream_level_m"]},
          {"downstream", frame["downstream_level_m"]},
          {"outlines", outlines},
          {"pools", pools},
          {"panels", panels},
          {"contacts", contacts},
          {"bolts", frame.value("bolts", json::array())}};
}

}  // namespace

json frames_data(const fs::path& run, const json& summary) {
  const json failure_s = summary.contains("failure") ? summary["failure"]["time_s"] : json();
  std::vector<json> all = read_frames(run);
  const std::size_t last_standing = pictured_frame(all, failure_s);
  const std::vector<json> frames = thinned(std::move(all), last_standing);
  const bool still = !fs::exists(run / "openfoam");  // moving water has no pools
  const View view = view_of(frames, std::numeric_limits<double>::infinity());
  const Rounded rounded(view);
  const double breached_s =
      summary.contains("breach") ? summary["breach"]["time_s"].get<double>() : std::numeric_limits<double>::infinity();
  json list = json::array();
  for (const json& frame : frames) {
    const double time_s = frame["time_s"];
    const bool breached = time_s >= breached_s;
    list.push_back(page_frame(frame, view, rounded, still && !breached));
    list.back()["breached"] = breached;
  }
  return {{"frames", list},
          {"view", {{"left", view.left}, {"right", view.right}, {"bottom", view.bottom}, {"top", view.top}}},
          {"pictured", pictured_frame(frames, failure_s)},
          {"failure_s", failure_s}};
}

}  // namespace blockweir::picture
