// SPDX-License-Identifier: GPL-3.0-or-later
// A scene for blockweir report, and its page as a browser shows it.
#pragma once

#include <regex>

#include "tests/coupling/masonry_wall.hpp"
#include "tests/processes.hpp"

namespace blockweir::test {

class Report : public Processes {
 protected:
  void write_scene() const {
    std::ofstream(folder / "wall.toml") << R"(title = "a wall </script><b>holds</b> a pond"
analysis = { duration_s = 4 }
water = { upstream_level_m = { from = 4, rate_per_s = 0.1 } }
joint = { friction_angle_deg = 30, uplift = "triangular" }
)" << masonry_wall << R"([[joints]]
name = "base"
between = ["rock", "wall"]
[[point_load]]
block = "wall"
point_m = [0, 5]
force_n_per_m = [1000, 0]
[[bolt]]
name = "anchor"
from_block = "wall"
to_block = "rock"
from_m = [0.5, 5]
to_m = [1, -2]
stiffness_n_per_m2 = 1e6
prestress_n_per_m = 5e3
yield_n_per_m = 6e3
[[load_case]]
name = "low water"
class = "usual"
set = ["water.upstream_level_m=2"]
required_factor = 1.5
source = "a guideline"
)";
  }
  /// The page with the probe in it, opened; what the probe saw.
  [[nodiscard]] nlohmann::json opened(const std::string& page) const {
    const auto put = [&](std::string text, const std::string& before, const std::string& script) {
      return text.insert(text.rfind(before), "<script>" + script + "</script>");
    };
    std::ostringstream probe;
    probe << std::ifstream(std::string(BLOCKWEIR_SOURCE) + "/tests/coupling/report_probe.js").rdbuf();
    std::string html = put(text(page), "</body>", probe.str());
    html = put(html, "<title>",
               "window.faults = []; addEventListener('error', e => faults.push(e.message)); for (const kind of "
               "['error', 'warn']) console[kind] = text => faults.push(String(text));");
    std::ofstream(folder / "probed.html") << html;
    const std::string chromium =
        "chromium --headless --no-sandbox --disable-gpu --user-data-dir=browser --virtual-time-budget=30000 --dump-dom "
        "file://" +
        (folder / "probed.html").string();
    EXPECT_EQ(shell(chromium + " 2>browser.log"), 0)
        << "is Chromium installed (./blockweir test does)? " << text("out") << text("browser.log");
    std::smatch found;
    const std::string dom = text("out");
    if (!std::regex_search(dom, found, std::regex("<pre>([^<]*)</pre>"))) return {};
    std::string answer = found[1];
    for (const auto& [code, letter] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
      answer = std::regex_replace(answer, std::regex(code), letter);
    }
    return nlohmann::json::parse(answer, nullptr, /*allow_exceptions=*/false);
  }
};

}  // namespace blockweir::test
