// SPDX-License-Identifier: GPL-3.0-or-later
// What to say of a key that does not exist: the nearest one, and its unit where only the unit is wrong.
#include "bridge/scene/read/key_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "bridge/scene/read/key_homes.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace blockweir::scene {
namespace {

/// Endings that name a unit, ours and those that people bring along.
constexpr std::array<std::string_view, 62> units{
    "kg_per_m3", "kg_m3",    "g_per_cm3", "g_cm3",   "t_per_m3",  "t_m3",     "kn_per_m3", "kn_m3",    "n_per_m2",
    "n_m2",      "kn_per_m", "kn_m",      "n_per_m", "n_m",       "m_per_s2", "m_s2",      "mm_per_s", "km_per_h",
    "m_per_s",   "m_s",      "deg_per_s", "deg_s",   "rad_per_s", "rad_s",    "rpm",       "hz",       "gpa",
    "mpa",       "kpa",      "pa",        "mbar",    "bar",       "psi",      "ksi",       "atm",      "mm",
    "cm",        "km",       "m",         "ft",      "inch",      "in",       "ms",        "us",       "s",
    "sec",       "seconds",  "min",       "minutes", "h",         "hours",    "days",      "degrees",  "deg",
    "radians",   "rad",      "percent",   "kn",      "n",         "kg",       "g",         "t"};

/// A key is the name of a quantity, then its unit; either may be empty.
struct Quantity {
  std::string_view name;
  std::string_view unit;
};

Quantity split(std::string_view key) {
  Quantity best{key, {}};
  for (const std::string_view unit : units) {
    const bool ends = key.size() > unit.size() + 1 && key.ends_with(unit) && key[key.size() - unit.size() - 1] == '_';
    if (ends && unit.size() > best.unit.size()) best = {key.substr(0, key.size() - unit.size() - 1), unit};
  }
  return best;
}

/// kg_per_m3 as one reads it: kg/m3. Units named after people have a capital.
std::string spelled(std::string_view unit) {
  std::string text(unit);
  const auto per = text.find("_per_");
  if (per != std::string::npos) text.replace(per, 5, "/");
  for (const std::string_view person : {"n", "pa", "hz"}) {
    const bool alone = text.starts_with(person) && (text.size() == person.size() || text[person.size()] == '/');
    if (alone) text[0] = static_cast<char>(std::toupper(text[0]));
  }
  return text;
}

/// The key that begins with the word: `friction` is meant as friction_angle_deg.
std::string begun_by(std::string_view word, const std::vector<std::string>& keys) {
  const std::string start = std::string(word) + "_";
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& key) { return key.starts_with(start); });
  return found == keys.end() ? "" : fmt::format("did you mean \"{}\"?", *found);
}

/// The key that says the same quantity in another unit: by its full name, else by the end of it.
std::string same_quantity(const Quantity& found, const std::vector<std::string>& keys) {
  std::string by_end;
  for (const std::string& key : keys) {
    const Quantity known = split(key);
    if (known.unit.empty() || known.unit == found.unit) continue;
    if (known.name == found.name) return key;
    const bool ends = known.name.ends_with(std::string("_").append(found.name));
    if (ends && by_end.empty()) by_end = key;
  }
  return by_end;
}

}  // namespace

KeyAdvice key_advice(std::string_view word, const std::vector<std::string>& keys) {
  if (const std::string home = home_advice(word); !home.empty()) return {one_of(keys), home};
  const std::string twin = same_quantity(split(word), keys);
  if (twin.empty()) {
    const std::string longer = begun_by(word, keys);
    return {one_of(keys), longer.empty() ? did_you_mean(word, keys) : longer};
  }
  const std::string unit = spelled(split(twin).unit);
  return {fmt::format("{}, in {}", twin, unit), fmt::format("write {} and give the value in {}", twin, unit)};
}

}  // namespace blockweir::scene
