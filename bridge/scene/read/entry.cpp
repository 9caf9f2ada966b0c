// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bridge/scene/read/overrides.hpp"

namespace blockweir::scene {
namespace {

/// Who wrote the entry has not written the command line's option.
std::string without_option(std::string remedy) {
  const std::string option = override_place("");
  for (std::size_t at = 0; (at = remedy.find(option, at)) != std::string::npos;) remedy.erase(at, option.size());
  return remedy;
}

/// Settings are read as those of the command line: a diagnostic on one of them is moved to the entry.
bool move_to(const SettingEntry& entry, const std::string& file, Diagnostic& d) {
  const auto& settings = entry.settings;
  const auto stated = std::find_if(settings.begin(), settings.end(),
                                   [&](const std::string& setting) { return d.file == override_place(setting); });
  if (stated == settings.end()) return false;
  d.file = file;
  d.line = entry.line;
  d.found = fmt::format("{} sets {}: {}", entry.name, *stated, d.found);
  d.remedy = without_option(std::move(d.remedy));
  return true;
}

}  // namespace

ReadScene read_entry(const std::filesystem::path& path, const SettingEntry& entry,
                     const std::vector<std::string>& all) {
  const std::string file = scene_file(path).string();
  try {
    ReadScene result = scene::read(path, all, Extent::one_scene);
    for (Diagnostic& warning : result.warnings) move_to(entry, file, warning);
    return result;
  } catch (const SceneError& error) {
    std::vector<Diagnostic> errors = error.diagnostics();
    for (Diagnostic& d : errors) {
      if (!move_to(entry, file, d)) d.found = fmt::format("with {}: {}", entry.name, d.found);
    }
    throw SceneError(std::move(errors));
  }
}

std::vector<std::string> overrides_of(const Scene& scene, const std::vector<std::string>& overrides,
                                      const std::vector<std::string>& keys) {
  const toml::table file = toml::parse(scene.text);
  const auto plain = [&file](const std::string& text) { return plain_key(file, setting_key(text)); };
  std::vector<std::string> found;
  std::copy_if(overrides.begin(), overrides.end(), std::back_inserter(found), [&](const std::string& one) {
    const std::string set = plain(one);
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
      const std::string own = plain(key);
      return set == own || set.starts_with(own + ".");
    });
  });
  return found;
}

}  // namespace blockweir::scene
