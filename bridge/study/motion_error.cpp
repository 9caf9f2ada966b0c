// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/motion_error.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bridge/picture/history.hpp"

namespace blockweir::study {

Ways ways_of(const std::filesystem::path& run) {
  const picture::History history(run / "history.csv");
  const std::string x = ".displacement_x_m";
  Ways ways;
  for (const std::string& name : history.names()) {
    if (!name.ends_with(x)) continue;
    const std::string block = name.substr(0, name.size() - x.size());
    ways.push_back({history.column(name).back(), history.column(block + ".displacement_y_m").back()});
  }
  return ways;
}

double motion_error(const Ways& ways, const Ways& finer) {
  if (ways.size() != finer.size())
    throw std::runtime_error(
        "the run with finer steps has other blocks; expected those of the scene; leave blocks out of \"set\"");
  double apart = 0;
  double farthest = 0;
  for (std::size_t b = 0; b < ways.size(); ++b) {
    apart = std::max(apart, std::hypot(ways[b][0] - finer[b][0], ways[b][1] - finer[b][1]));
    farthest = std::max(farthest, std::hypot(finer[b][0], finer[b][1]));
  }
  if (farthest == 0)
    throw std::runtime_error(
        "nothing moves in the run with finer steps; expected a motion to compare with; choose a scene whose blocks "
        "move");
  return apart / farthest;
}

}  // namespace blockweir::study
