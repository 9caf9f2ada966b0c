// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/picture/view_grid.hpp"

namespace blockweir::picture {

namespace {

bool begins_letter(char c) {  // of UTF-8
  return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
}

/// Where the letter with this number begins, or the end.
std::size_t place_of(const std::string& text, std::size_t letter) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (begins_letter(text[at]) && letter-- == 0) break;
  }
  return at;
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += '\'';
    const auto code = static_cast<unsigned char>(c);
    quoted += code < 0x20 || code == 0x7f ? ' ' : c;
  }
  return quoted + "'";
}

std::string gnuplot_tic(std::string text) {
  for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos; at += 2) text.insert(at, 1, '%');
  return gnuplot_text(text);
}

std::string shortened(const std::string& text, std::size_t letters) {
  if (place_of(text, letters) == text.size()) return text;
  return text.substr(0, place_of(text, letters - 1)) + "…";
}

std::string gnuplot_title(const std::string& text, double width) {
  constexpr int most_lines = 3;
  constexpr double pixels_per_letter = 9.5;
  const auto letters = static_cast<std::size_t>(width / pixels_per_letter);
  std::string rest = text;
  std::string title;
  for (int line = 1;; ++line) {
    const std::size_t end = place_of(rest, letters);
    if (end == rest.size()) return title + gnuplot_text(rest);
    if (line == most_lines) return title + gnuplot_text(shortened(rest, letters));
    const std::size_t space = rest.rfind(' ', end);
    const bool at_word = space != std::string::npos && space > 0;
    title += gnuplot_text(rest.substr(0, at_word ? space : end)) + ".\"\\n\".";
    rest.erase(0, at_word ? space + 1 : end);
  }
}

std::string gnuplot_polygon(int& number, const std::vector<Eigen::Vector2d>& outline, const View& view,
                            const std::string& style) {
  std::string text;
  for (const auto& piece : in_view(outline, view)) {
    text += fmt::format("set object {} polygon", ++number);
    for (std::size_t i = 0; i <= piece.size(); ++i) {
      const Eigen::Vector2d& p = piece[i % piece.size()];
      text += fmt::format(" {} {},{}", i == 0 ? "from" : "to", p.x(), p.y());
    }
    text += " " + style + "\n";
  }
  return text;
}

}  // namespace blockweir::picture
