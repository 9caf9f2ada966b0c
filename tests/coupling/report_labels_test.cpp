// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Sections of all cases and of their load cases, as a report draws them: no two labels touch.
#include "bridge/picture/section_data.hpp"
#include "bridge/picture/section_state.hpp"
#include "bridge/process/answers.hpp"
#include "bridge/study/load_case_scene.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::report_labels_test {
namespace {

using nlohmann::json;

/// Sizes of texts on paper, which are larger than those on a screen; what the page itself writes comes into one picture
/// after the other.
const std::string draw_all = R"(
document.head.append(element('style', {}, '.state svg text { font-size: 14px; } .small .state svg text { font-size: 17px; }'));
const touching = [];
for (const {name, report} of all) {
  const small = {...report, safety: [{...report, name, section: report.state}]};
  for (const [kind, figure] of [['', sectionFigure(report)], ['small', caseFigures(small, small.safety)]]) {
    const sheet = element('div', {class: kind}, figure);
    document.body.append(sheet);
    const texts = [...sheet.querySelectorAll('svg > text, svg g > text:first-child')];
    const boxes = texts.map(t => t.getBoundingClientRect());
    boxes.forEach((a, i) => boxes.slice(0, i).forEach((b, j) => {
      const apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      if (!apart) touching.push(`${name} ${kind}: "${texts[i].textContent}" on "${texts[j].textContent}"`);
    }));
    sheet.remove();
  }
}
const answer = document.createElement('pre');
answer.textContent = JSON.stringify(touching);
document.documentElement.replaceChildren(answer);
)";

class ReportLabels : public Processes {
 protected:
  void add(const std::string& name, const scene::Scene& scene) {
    json water = json::array();
    try {
      water = process::water_answer(scene, hydrostatic::make);
    } catch (const std::exception&) {
      // water that moves has no pressures of still water; the other loads act
    }
    json report = picture::section_data(scene);
    report["state"] = picture::section_state(scene, water, scene.analysis.duration_s, json::array());
    all_.push_back({{"name", name}, {"report", report}});
  }
  /// The page's own functions draw them.
  [[nodiscard]] std::string page() const {
    std::ostringstream html;
    html << "<!DOCTYPE html><meta charset=\"utf-8\"><style>";
    const std::string sources = std::string(BLOCKWEIR_SOURCE) + "/bridge/report/page/";
    html << std::ifstream(sources + "report.css").rdbuf() << "</style><body><script>";
    for (const char* file : {"elements.js", "section.js", "state.js"}) html << std::ifstream(sources + file).rdbuf();
    html << "const all = " << all_.dump() << ";\n" << draw_all << "</script></body>";
    return html.str();
  }

  json all_ = json::array();
};

TEST_F(ReportLabels, NoTwoTouchInTheSectionOfAnyCaseOrLoadCase) {
  for (const auto& entry : fs::directory_iterator(cases)) {
    if (!fs::exists(entry.path() / "scene.toml")) continue;
    const std::string name = entry.path().filename().string();
    const scene::ReadScene read = scene::read(entry.path());
    add(name, read.scene);
    for (const scene::LoadCase& load_case : read.load_cases) {
      add(name + ", " + load_case.name, study::load_case_scene(load_case, entry.path(), {}).scene);
    }
  }
  ASSERT_GT(all_.size(), 40U);
  std::ofstream(folder / "labels.html") << page();
  ASSERT_EQ(shell("chromium --headless --no-sandbox --disable-gpu --user-data-dir=browser --virtual-time-budget=60000 "
                  "--dump-dom file://" +
                  (folder / "labels.html").string() + ""),
            0)
      << "is Chromium installed (./blockweir test does)? " << text("out");
  const std::string dom = text("out");
  const std::size_t answer = dom.find("<pre>");
  ASSERT_NE(answer, std::string::npos) << dom;
  EXPECT_EQ(dom.substr(answer, dom.find("</pre>") - answer), "<pre>[]");
}

}  // namespace
}  // namespace blockweir::test::report_labels_test
