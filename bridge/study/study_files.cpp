// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/study_files.hpp"

#include <fmt/format.h>

#include "bridge/picture/gnuplot.hpp"

namespace blockweir::study {

void draw_study(const std::filesystem::path& file, const std::string& title, const std::string& figure) {
  picture::gnuplot(fmt::format("set terminal pngcairo font 'sans,12' size 800,600\nset output {}\nset title {}\n{}",
                               picture::gnuplot_path(file), picture::gnuplot_text(title), figure));
  fmt::print("{}\n", file.string());
}

}  // namespace blockweir::study
