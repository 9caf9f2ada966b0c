// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/reached.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace blockweir::process {

nlohmann::json reached(const std::filesystem::path& run) {
  std::ifstream history(run / "history.csv");
  std::string header;
  std::getline(history, header);
  if (!header.starts_with("time_s,upstream_level_m,")) return nullptr;
  std::string last;
  for (std::string row; std::getline(history, row) && !history.eof();) last = row;  // one without its end is cut short
  double time_s = 0;
  double level_m = 0;
  if (std::sscanf(last.c_str(), "%lf,%lf,", &time_s, &level_m) != 2) return nullptr;
  std::string text = fmt::format("it came to {:.6g} s", time_s);
  if (!std::isnan(level_m)) text += fmt::format(", at a level of {:.6g} m", level_m);
  return {{"time_s", time_s}, {"level_m", level_m}, {"text", text}};
}

}  // namespace blockweir::process
