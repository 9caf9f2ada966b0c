// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/crack_meetings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/place_text.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::hydrostatic {
namespace {

constexpr double much = 0.1;  // of the highest pressure along both

/// Distance from the crack's mouth at which it passes the point; none if it does not.
std::optional<double> station(const scene::Crack& crack, const Point& p, double near_m) {
  double station_m = 0;
  for (const scene::CrackPart& part : crack.parts) {
    for (const scene::TracePiece& piece : part.trace.pieces) {
      const Point along = piece.to_m - piece.from_m;
      if (geometry::distance_to_segment(p, piece.from_m, piece.to_m) <= near_m) {
        return station_m + std::clamp(along.dot(p - piece.from_m) / along.squaredNorm(), 0.0, 1.0) * along.norm();
      }
      station_m += along.norm();
    }
  }
  return std::nullopt;
}

double highest_pa(const joints::Profile& profile) {
  double highest = 0;
  for (const auto& knot : profile.knots()) highest = std::max(highest, knot.pressure_pa);
  return highest;
}

}  // namespace

CrackMeetings::CrackMeetings(const scene::Scene& scene, const std::vector<scene::Crack>& cracks) : scene_(scene) {
  constexpr std::size_t most = 1'000;  // more are a network, and take long to look at
  if (cracks.size() > most) return;
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    names_.push_back(scene::name_of(scene, cracks[k]));
    for (const bool mouth : {true, false}) add(cracks, k, mouth);
  }
}

void CrackMeetings::add(const std::vector<scene::Crack>& cracks, std::size_t k, bool mouth) {
  const Point& place = mouth ? cracks[k].mouth() : cracks[k].end();
  const double near_m = scene_.water.open_crack_width_m;
  for (std::size_t other = 0; other < cracks.size(); ++other) {
    if (other == k) continue;
    const auto on_other_m = station(cracks[other], place, near_m);
    if (!on_other_m) continue;
    const bool at_its_end = std::min(*on_other_m, cracks[other].length_m - *on_other_m) <= near_m;
    if (at_its_end && other < k) continue;  // it has met this one
    all_.push_back({.crack = k,
                    .end_m = mouth ? 0 : cracks[k].length_m,
                    .other = other,
                    .on_other_m = *on_other_m,
                    .place = place});
  }
}

double CrackMeetings::Meeting::share() const {
  return highest_pa > 0 ? std::abs(pressure_pa - pressure_of_other_pa) / highest_pa : 0;
}

void CrackMeetings::look(const std::vector<joints::Profile>& profiles) {
  for (Meeting& m : all_) {
    Meeting now = m;
    now.pressure_pa = profiles[m.crack].pressure(m.end_m);
    now.pressure_of_other_pa = profiles[m.other].pressure(m.on_other_m);
    now.highest_pa = std::max(highest_pa(profiles[m.crack]), highest_pa(profiles[m.other]));
    if (now.share() > m.share()) m = now;
  }
}

std::string CrackMeetings::warning() const {
  const auto jumps = [](const Meeting& m) { return m.share() > much; };
  const auto count = std::count_if(all_.begin(), all_.end(), jumps);
  if (count == 0) return {};
  const auto differ_pa = [](const Meeting& m) { return std::abs(m.pressure_pa - m.pressure_of_other_pa); };
  const Meeting& m = *std::max_element(all_.begin(), all_.end(), [&](const Meeting& a, const Meeting& b) {
    return std::pair(jumps(a), differ_pa(a)) < std::pair(jumps(b), differ_pa(b));
  });
  return fmt::format(
      "joint \"{}\" ends at {} m on joint \"{}\": its water has {:.4g} kPa there, that of the other {:.4g} kPa{}; "
      "expected one pressure where joints meet; uplift = \"flow\" of both finds it, and their uplift with it",
      names_[m.crack], geometry::place_text(m.place, scene::structure_size_m(scene_.blocks)), names_[m.other],
      m.pressure_pa / 1e3, m.pressure_of_other_pa / 1e3,
      count > 1 ? ", and so at " + results::counted(static_cast<std::size_t>(count - 1), "more end") : "");
}

}  // namespace blockweir::hydrostatic
