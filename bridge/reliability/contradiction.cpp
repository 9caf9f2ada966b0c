// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/contradiction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace blockweir::study {
namespace {

using nlohmann::json;

struct Range {
  std::string method;
  double from = 0;
  double to = 1;
};

/// FORM and SORM are one: both are of the same design points.
std::vector<Range> ranges_of(const json& answer) {
  std::vector<Range> all;
  for (const auto& [method, name] : {std::pair("samples", "samples"), std::pair("importance", "importance sampling"),
                                     std::pair("subset", "subset sampling")}) {
    const json found = answer.value(method, json::object());
    if (!found.contains("interval") || !found["interval"][0].is_number() || !found["interval"][1].is_number()) continue;
    all.push_back({name, found["interval"][0], found["interval"][1]});
  }
  std::vector<double> first_order;
  for (const char* method : {"form", "sorm"}) {
    const json found = answer.value(method, json::object());
    for (const json& p : {found.value("probability", json()), found.value("at_most", json()),
                          found.value("breitung", json::object()).value("probability", json())}) {
      if (p.is_number()) first_order.push_back(p);
    }
  }
  if (first_order.empty()) return all;
  const auto [least, most] = std::minmax_element(first_order.begin(), first_order.end());
  all.push_back({answer.contains("form") ? "FORM" : "SORM", *least, *most});
  return all;
}

}  // namespace

std::string contradiction_of(const json& answer) {
  constexpr double tenfold = 10;
  const std::vector<Range> all = ranges_of(answer);
  if (all.empty()) return {};
  const Range& low =
      *std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.to < b.to; });
  const Range& high =
      *std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  if (high.from <= tenfold * low.to) return {};
  return fmt::format(
      "P is {:.3g} or less by {}, and {:.3g} or more by {}: one of them misses a way to fail; take the "
      "larger, and raise method_samples",
      low.to, low.method, high.from, high.method);
}

}  // namespace blockweir::study
