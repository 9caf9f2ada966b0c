// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a scene holds what an expected quantity and its formula speak of.
#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/one_block.hpp"
#include "bridge/scene/quantity_table.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

const char* words(Subject subject) {
  switch (subject) {
    case Subject::block:
    case Subject::block_if_any:
      return "a block, or a joint for the upper of its blocks";
    case Subject::block_only:
      return "a block";
    case Subject::joint:
      return "a joint";
    case Subject::bolt:
      return "a bolt";
    case Subject::arch:
      return "an arch";
    case Subject::none:
      break;
  }
  return "nothing";
}

/// Names of all parts of the scene that are such a subject.
std::vector<std::string> candidates(const Scene& scene, Subject subject) {
  std::vector<std::string> names;
  const auto add = [&](const auto& parts) {
    for (const auto& part : parts) names.push_back(part.name);
  };
  const bool block = subject == Subject::block || subject == Subject::block_if_any;
  if (block || subject == Subject::block_only) add(scene.blocks);
  if (block || subject == Subject::joint) add(scene.joints);
  if (subject == Subject::bolt) add(scene.bolts);
  if (subject == Subject::arch) add(scene.arches);
  return names;
}

/// What the scene lacks for a need; null if it lacks nothing.
const char* missing(const Scene& scene, Need need) {
  switch (need) {
    case Need::water:
      return scene.fluid == FluidModel::none ? "[water]" : nullptr;
    case Need::upstream_level:
      return scene.water.upstream_level_m ? nullptr : "upstream_level_m in [water]";
    case Need::face_pressure:
      return scene.face_pressures.empty() ? "a [[face_pressure]]" : nullptr;
    case Need::column:
      return scene.column.block < 0 ? "[fluid.column]" : nullptr;
    case Need::nothing:
      break;
  }
  return nullptr;
}

/// The answers of a quantity that is a word.
std::vector<std::string> answers_of(const std::string& quantity) {
  if (quantity == "invariants") return {"hold", "energy made", "in each other"};
  if (quantity == "stability") return {"stable", "grows"};
  return {"stands", "moving", "sliding", "overturning", "sliding and overturning", "lifting", "falling"};
}

/// One of quantity and formula, `kind`, against what the table states.
void check_one(TableReader& table, const Reading& reading, const Expectation& e, const char* kind,
               const QuantityEntry& answer) {
  const std::string what = fmt::format("{} {} in {}", kind, answer.name, table.name());
  const auto report = [&](const char* key, const std::string& found, const std::string& expected,
                          const std::string& remedy) {
    reading.problems.error(table.place(table.has(key) ? key : kind), fmt::format("{} {}", what, found), expected,
                           remedy);
  };
  const std::vector<std::string> names = candidates(reading.scene, answer.of);
  const bool held = std::find(names.begin(), names.end(), e.of) != names.end();
  const bool needless = answer.of == Subject::none || answer.of == Subject::block_if_any;
  const bool reported = e.of.empty() && e.at_m;  // a point of no block
  if (!reported && (e.of.empty() ? !needless : answer.of != Subject::none && !held)) {
    report("of", e.of.empty() ? "has no of" : fmt::format("is of \"{}\"", e.of),
           fmt::format("of = {}", words(answer.of)),
           names.empty() ? "the scene has none: use another figure" : fmt::format("name {}", one_of(names)));
  }
  if (answer.at_point && !e.at_m) {
    report("at_m", "needs at_m", "at_m = [x, y], a point of the block", "state the point, in an [[expect]]");
  }
  if (answer.one_block && held) {
    const auto joint = std::find_if(reading.scene.joints.begin(), reading.scene.joints.end(),
                                    [&](const Joint& j) { return j.name == e.of; });
    const bool of_crack = std::string(answer.name) == "cracked-through";
    const UpliftName& uplift = named(joint->law.uplift);
    if (of_crack ? uplift.law != Uplift::cracked : !uplift.share) {
      report(kind, fmt::format("does not know uplift = \"{}\", the law of joint \"{}\"", uplift.name, e.of),
             of_crack ? "\"cracked\"" : "\"none\", \"triangular\" or \"full\"",
             "state what you have calculated by hand, as value");
    }
    if (const std::string beyond = beyond_one_block(reading.scene, *joint); !beyond.empty()) {
      report(kind, beyond, "one block on a joint, with water upstream of it alone",
             "state what you have calculated by hand, as value");
    }
  }
  if (const char* lack = missing(reading.scene, answer.needs)) {
    report(kind, fmt::format("needs {}", lack), "a scene that has it", "add it, or use another figure");
  }
}

}  // namespace

void check_answer(TableReader& table, const Reading& reading, const Expectation& e) {
  const QuantityEntry* quantity = find_entry(quantities(), e.quantity);
  const QuantityEntry* formula = find_entry(formulas(), e.formula);
  if (quantity != nullptr) check_one(table, reading, e, "quantity", *quantity);
  if (formula != nullptr) check_one(table, reading, e, "formula", *formula);
  if (quantity == nullptr && formula == nullptr && !e.quantity.empty()) return;  // an unknown one has been reported
  const auto report = [&](const char* key, const std::string& found, const char* expected, const char* remedy) {
    reading.problems.error(table.place(key), fmt::format("{} in {} {}", key, table.name(), found), expected, remedy);
  };
  const bool about_nothing =
      (quantity == nullptr || quantity->of == Subject::none) && (formula == nullptr || formula->of == Subject::none);
  if (!e.of.empty() && about_nothing) {
    report("of", "has no effect: the quantity is one of the whole scene", "a quantity of a part of the scene",
           "leave of out, or use another quantity");
  }
  if (e.at_m && quantity != nullptr && !quantity->at_point) {
    report("at_m", fmt::format("has no effect: {} is none at a point", quantity->name), "a quantity at a point",
           "leave at_m out, or use another quantity");
  }
  const bool is_word = quantity != nullptr && quantity->word;
  const bool says_word = table.has("word") || (formula != nullptr && formula->word);
  const bool says_number = table.has("value") || (formula != nullptr && !formula->word);
  if (is_word ? says_number : says_word) {
    const char* key = table.has("formula") ? "formula" : table.has("word") ? "word" : "value";
    report(key,
           fmt::format("does not fit {}, which is a {}", quantity == nullptr ? "the answer" : quantity->name,
                       is_word ? "word" : "number"),
           is_word ? "word, or a formula for one" : "value, or a formula for a number", "change one of the two");
  }
  if (!is_word || e.word.empty()) return;
  const std::vector<std::string> answers = answers_of(quantity->name);
  if (std::find(answers.begin(), answers.end(), e.word) != answers.end()) return;
  reading.problems.error(table.place("word"),
                         fmt::format("word in {} is \"{}\", which {} never is", table.name(), e.word, quantity->name),
                         one_of(answers), did_you_mean(e.word, answers));
}

}  // namespace blockweir::scene
