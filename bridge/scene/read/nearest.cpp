// SPDX-License-Identifier: GPL-3.0-or-later
// The right word that a wrong one was probably meant to be: optimal string alignment distance.
#include "bridge/scene/read/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace blockweir::scene {
namespace {

using Row = std::vector<std::size_t>;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  Row before_last;
  Row last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    Row row(b.size() + 1);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::exchange(last, std::move(row));
  }
  return last.back();
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t limit = word.size() / 2 + 1;
  for (const std::string& candidate : candidates) {
    // The difference in length is a lower bound: spares the table for hopeless candidates and monstrous words.
    if (std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size()) >= limit) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= limit) continue;
    limit = distance;
    best = candidate;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : fmt::format("did you mean \"{}\"?", near);
}

std::string one_of(const std::vector<std::string>& candidates) {
  constexpr std::size_t most = 20;
  std::vector<std::string> named;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(named),
               [](const std::string& name) { return !name.empty(); });
  if (named.empty()) return "one that the scene has: it has none";
  std::vector<std::string> shown(named.begin(),
                                 named.begin() + static_cast<std::ptrdiff_t>(std::min(most, named.size())));
  const auto has_comma = [](const std::string& name) { return name.find(',') != std::string::npos; };
  if (std::any_of(shown.begin(), shown.end(), has_comma)) {
    for (std::string& name : shown) name = '"' + name + '"';
  }
  return fmt::format("one of {}{}", fmt::join(shown, ", "),
                     named.size() > most ? fmt::format(" and {} more", named.size() - most) : "");
}

}  // namespace blockweir::scene
