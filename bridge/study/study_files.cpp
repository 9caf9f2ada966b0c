// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/study_files.hpp"

#include <fmt/format.h>

#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"

namespace blockweir::study {

void draw_study(const std::filesystem::path& file, const std::string& title, const std::string& figure) {
  picture::draw({{file, 800, 600, fmt::format("set title {}\n{}", picture::gnuplot_text(title), figure)}});
  fmt::print("{}\n", file.string());
}

}  // namespace blockweir::study
