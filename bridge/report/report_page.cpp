// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/report/report_page.hpp"

#include <boost/algorithm/string/replace.hpp>

#include "bridge/picture/frames_data.hpp"
#include "bridge/picture/pictured_state.hpp"
#include "bridge/picture/section_data.hpp"
#include "bridge/report/flow_data.hpp"
#include "bridge/report/histories_data.hpp"
#include "bridge/report/page_files.hpp"

namespace blockweir::picture {

using nlohmann::json;

/// A text that names files of the run, without the path to them: the page is read elsewhere.
static std::string within(const std::filesystem::path& run, std::string text) {
  boost::replace_all(text, std::filesystem::absolute(run).lexically_normal().string() + "/", "");
  return text;
}

json report_data(const ReportParts& parts) {
  const json& summary = parts.summary;
  json data = section_data(parts.scene);
  data.update(frames_data(parts.run, summary));
  data["state"] = pictured_state(parts.scene, parts.run, data);
  data["title"] = parts.scene.title.empty() ? parts.scene.file.stem().string() : parts.scene.title;
  data["note"] = parts.scene.note;
  data["summary"] = summary;
  if (summary.contains("stopped")) data["summary"]["stopped"] = within(parts.run, summary["stopped"]);
  data["duration_s"] = parts.scene.analysis.duration_s;
  data["level"] = parts.level;
  data["safety"] = parts.safety;
  data["flow"] = flow_data(parts.run, summary);
  data["reliability"] = parts.reliability;
  data["histories"] = histories_data(parts.run);
  data["program"] = parts.program;
  data["commands"] = parts.commands;
  data["home"] = parts.home;
  data["digest"] = parts.scene.digest;
  data["scene"] = parts.scene.text;
  return data;
}

std::string report_page(const json& data) {
  std::string page = page_html;
  std::string text = data.dump();
  boost::replace_all(text, "<", "\\u003c");  // a text of the scene cannot end the script that holds it
  boost::replace_first(page, "@STYLE@", page_style);
  boost::replace_first(page, "@SCRIPT@", page_script());
  boost::replace_first(page, "@DATA@", text);
  return page;
}

}  // namespace blockweir::picture
