// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/merged_report.hpp"

#include <fmt/format.h>

#include <fstream>

namespace blockweir::process {
namespace {

using nlohmann::json;

/// Adds { name: number } of `from` to the part `into`; other entries are left out, with a warning.
void add_numbers(const json& from, const char* part, json& summary, const char* into, json& warnings) {
  if (!from.contains(part)) return;
  const json& numbers = from[part];
  if (!numbers.is_object()) {
    warnings.push_back(fmt::format("\"{}\" is not a table of numbers; left out", part));
    return;
  }
  for (const auto& [name, number] : numbers.items()) {
    if (number.is_number()) {
      summary[into]["fluid_" + name] = number;
    } else {
      warnings.push_back(fmt::format("\"{}\" of \"{}\" is not a number; left out", name, part));
    }
  }
}

/// Adds the entries of a list, all of them texts, or all objects.
void add_entries(const json& from, const char* part, bool texts, json& summary, json& warnings) {
  if (!from.contains(part)) return;
  const json& entries = from[part];
  bool fits = entries.is_array();
  for (const json& entry : entries) fits = fits && (texts ? entry.is_string() : entry.is_object());
  if (!fits) {
    warnings.push_back(fmt::format("\"{}\" is not a list of {}; left out", part, texts ? "texts" : "tables"));
    return;
  }
  for (const json& entry : entries) summary[part].push_back(entry);
}

}  // namespace

void merge_report(const std::filesystem::path& file, const std::string& name, json& summary) {
  std::ifstream stream(file);
  if (!stream) return;
  const json fluid = json::parse(stream, nullptr, /*allow_exceptions=*/false);
  json warnings = json::array();
  if (fluid.is_object()) {
    add_numbers(fluid, "seconds", summary, "profile_s", warnings);
    add_numbers(fluid, "counts", summary, "counts", warnings);
    add_entries(fluid, "checks", /*texts=*/false, summary, warnings);
    add_entries(fluid, "skips", /*texts=*/true, summary, warnings);
    add_entries(fluid, "warnings", /*texts=*/true, summary, warnings);
    if (fluid.contains("peak_memory_mb") && fluid["peak_memory_mb"].is_number()) {
      summary["peak_memory_mb"]["fluid"] = fluid["peak_memory_mb"];
    }
  } else {
    warnings.push_back("it is not a table in JSON; left out");
  }
  for (const json& warning : warnings) {
    summary["warnings"].push_back(fmt::format("report of the {}: {}", name, warning.get<std::string>()));
  }
  std::filesystem::remove(file);
}

}  // namespace blockweir::process
