// SPDX-License-Identifier: GPL-3.0-or-later
// What a run's summary says, for people.
#include <fmt/format.h>

#include <cmath>

#include "bridge/process/previous_run.hpp"
#include "bridge/process/run.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/shell_word.hpp"

namespace blockweir::process {

using nlohmann::json;

namespace {

std::string number(const json& value) {
  return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : "none";
}

std::string failure_text(const json& f, const char* word) {
  std::string text = fmt::format("{}{}\n", word, f["text"].get<std::string>());
  if (f["level_m"].is_number()) {
    const std::string name = f.value("pool", "upstream");
    const bool falls = f.value("level_falls", false);
    const std::string pool = falls                  ? fmt::format(" ({} pool, falling)", name)
                             : name == "downstream" ? " (downstream pool)"
                                                    : "";
    // The text names two joints where one opens and another bears: the head is over the first.
    const char* joint = f.value("turns_on", "").empty() ? "failed" : "opens";
    const std::string head = f["head_m"].is_number()
                                 ? fmt::format(", {:.6g} m {} the joint that {}", std::abs(f["head_m"].get<double>()),
                                               f["head_m"].get<double>() < 0 ? "below" : "above", joint)
                                 : "";
    text += fmt::format("        at a level of {}{} m{}{}, after {} s\n",
                        !f.value("level_is_bound", false) ? ""
                        : falls                           ? "at least "
                                                          : "at most ",
                        number(f["level_m"]), pool, head, number(f["time_s"]));
  } else {
    text += fmt::format("        after {} s\n", number(f["time_s"]));
  }
  for (const char* more : {"doubt", "end"}) {
    if (f.contains(more)) text += fmt::format("        {}\n", f[more].get<std::string>());
  }
  return text;
}

std::string check_text(const json& check) {
  if (check.contains("trouble")) {
    return fmt::format("OUT     {}: {}\n", check["name"].get<std::string>(), check["trouble"].get<std::string>());
  }
  const std::string got = check.contains("why_none") ? check["why_none"].get<std::string>()
                                                     : fmt::format("got {}, off by {}", results::figure(check["got"]),
                                                                   number(check["relative_error"]));
  return fmt::format("{}  {}: expected {}, {} (tolerance {})\n", check["passed"].get<bool>() ? "ok    " : "OUT   ",
                     check["name"].get<std::string>(), results::figure(check["expected"]), got,
                     number(check["tolerance"]));
}

}  // namespace

std::string report(const RunResult& result) {
  const json& s = result.summary;
  std::string text;
  const std::string outcome = s.value("outcome", "stopped");
  if (outcome == "fails") {
    text += failure_text(s["failure"], "FAILS   ");
  } else if (outcome == "moving") {
    text += fmt::format("MOVING  {}\n        {}\n", s["moving"]["text"].get<std::string>(),
                        s["margin"]["text"].get<std::string>());
  } else if (outcome == "stands") {
    text += fmt::format("STANDS  {}\n", s["margin"]["text"].get<std::string>());
  } else {
    const std::string why = s.value("stopped", "");
    const std::string_view word = "stopped ";
    text += fmt::format("STOPPED {}{}\n", why.starts_with(word) ? why.substr(word.size()) : why,
                        result.advice.empty() || !result.kept ? "" : "; " + result.advice);
    if (s.contains("reached")) text += fmt::format("        {}\n", s["reached"]["text"].get<std::string>());
    if (s.contains("failure") && s["failure"].is_object()) text += failure_text(s["failure"], "FAILED  before that: ");
  }
  if (s.contains("limit_analysis")) {
    text += fmt::format("FACTOR  {}\n", s["limit_analysis"]["text"].get<std::string>());
  }
  if (s.contains("rest")) text += fmt::format("STATIC  {}\n", s["rest"]["text"].get<std::string>());
  if (s.contains("loose")) text += fmt::format("LOOSE   {}\n", s["loose"]["text"].get<std::string>());
  if (s.contains("breach")) {
    text +=
        fmt::format("BREACH  after {} s: {}\n", number(s["breach"]["time_s"]), s["breach"]["text"].get<std::string>());
  }
  if (s.contains("base_motion")) text += fmt::format("GROUND  {}\n", s["base_motion"]["text"].get<std::string>());
  if (s.contains("added_mass")) text += fmt::format("{}\n", s["added_mass"]["text"].get<std::string>());
  for (const json& warning : s.value("warnings", json::array())) {
    text += fmt::format("WARNING {}\n", warning.get<std::string>());
  }
  for (const json& check : s.value("checks", json::array())) text += check_text(check);
  if (const std::size_t skips = s.value("skips", json::array()).size(); skips > 0 && result.kept) {
    text += fmt::format("skipped {} of work that the result does not need; \"blockweir profile {}\" lists them\n",
                        results::counted(skips, "kind"), results::shell_word(result.folder.string()));
  }
  const json simulated = s.value("simulated_s", json());
  text += fmt::format("time    {} s of wall time{}\n", number(s["wall_time_s"]),
                      simulated.is_null() ? "" : fmt::format(" for {} s simulated", number(simulated)));
  if (!result.kept) return text;
  const std::string folder = result.folder.string();
  if (!result.in_place_of.empty()) {
    text += fmt::format("        {} holds an earlier run, which was kept\n", result.in_place_of.string());
  }
  text += fmt::format("results {} {}\n", folder,
                      has_frames(result.folder)
                          ? fmt::format("(blocks.pvd opens in ParaView; \"blockweir plot {}\" draws figures)",
                                        results::shell_word(folder))
                          : "(without a frame; solid.log has the solid's own words)");
  return text;
}

}  // namespace blockweir::process
