// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a scene file, one function each, called in this order.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "bridge/scene/names.hpp"
#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/read/table_reader.hpp"
#include "bridge/scene/read/time_record.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A scene while it is read: the file's tables, and the names that later sections refer to.
struct Reading {
  const toml::table& file;
  Problems& problems;
  Scene& scene;
  RecordSources records{};
  Names materials{"material"};
  Names blocks{"block"};
  Names bolts{"bolt"};
  bool residual_given = false;          ///< [joint] states the residual angle
  std::vector<std::string> sections{};  ///< sections asked for so far

  /// The table [name]; null if the file has none.
  const toml::table* section(const char* name);

  /// Calls read(table) for each [[name]].
  template <class Read>
  void each(const char* name, Read read) {
    for (const toml::table* table : entries(name)) {
      TableReader reader(problems, table, entry_name(name, *table));
      read(reader);
    }
  }

  /// The block, if its outline is valid; otherwise null.
  [[nodiscard]] const Block* sound_block(int index) const;

 private:
  std::vector<const toml::table*> entries(const char* name);
  static std::string entry_name(const char* name, const toml::table& table);
};

/// Reports a repeated name, with the line of the first entry, which is searched in these sections.
void refuse_second(Reading& reading, const Place& place, const char* kind, const std::string& name,
                   std::initializer_list<const char*> sections);

/// Reports a key that `set` states twice, or that it sets although the table itself varies it.
void check_settings(TableReader& table, Reading& reading, const std::vector<std::string>& set,
                    const std::vector<std::string>& own_keys = {});

/// Reports regions, cuts and joint sets with the same name. Called after read_section().
void refuse_repeated_names(Reading& reading);

/// Reads the law of a joint. `residual_given`: whether [joint] or this table states the residual angle; if not, it
/// equals the peak angle.
void read_law(TableReader& table, JointLaw& law, Reading& reading, bool& residual_given);

/// Reads the part of the law that concerns water.
void read_uplift(TableReader& table, JointLaw& law, Reading& reading);

/// Reports keys of a law that have no effect. `of_all`: the law of [joint], which other tables may complete.
void check_law(TableReader& table, const JointLaw& law, Reading& reading, bool of_all);
/// Reports drains and piezometers beyond the end of their joint, and joints that cannot form a crack of their own.
void check_cracks(Reading& reading);
/// Reports drains that cross no joint with flow, and grout regions without one.
void check_joint_flow(Reading& reading);
/// Reports uplift in a scene without water.
void check_uplift(TableReader& table, Reading& reading);
/// Reports an entry of [[joints]] whose blocks do not touch; blocks closer than `touching_m` touch.
void check_joint(TableReader& table, Reading& reading, const Joint& joint, double touching_m);

void read_heading(Reading& reading);
void read_analysis(Reading& reading);
void read_materials(Reading& reading);
void read_default_joint(Reading& reading);
/// Makes the outline valid and counter-clockwise, or empties it. Messages start with `whose` and name a vertex.
void mend_outline(std::vector<Point>& outline, const std::string& whose, Problems& problems,
                  const std::function<Place(std::size_t vertex)>& place_of);
/// Adds a valid block; reports a repeated name.
void add_block(Reading& reading, const Place& place, Block block);
/// Adds a block made by [[arch]], [[wall]] or [[heap]]; reports one that is too thin.
void add_made_block(Reading& reading, TableReader& table, Block block);
/// That generators make together.
inline constexpr int most_blocks = 100'000;
/// Reports more than `most` new blocks, or more than most_blocks in total.
bool few_enough(Reading& reading, TableReader& table, double blocks, double most = most_blocks);
/// Reports an entry that does not have exactly one of value, word and formula.
void require_one_answer(TableReader& table, Reading& reading);

/// Reports a quantity or formula that needs what the scene does not have, or that does not fit the kind of answer.
void check_answer(TableReader& table, const Reading& reading, const Expectation& e);

/// [section] with its regions, cuts and joint sets: adds their blocks and joints.
void read_section(Reading& reading);
/// [[arch]], [[wall]] and [[heap]]: each adds ordinary blocks.
void read_arches(Reading& reading);
void read_walls(Reading& reading);
void read_heaps(Reading& reading);
void read_blocks(Reading& reading);
void read_joints(Reading& reading);
void read_supports(Reading& reading);
/// [[viscous_boundary]]: faces beyond which the ground continues.
void read_viscous_boundaries(Reading& reading);
void read_point_loads(Reading& reading);
void read_face_pressures(Reading& reading);
void read_line_loads(Reading& reading);
void read_body_loads(Reading& reading);
void read_bolts(Reading& reading);
void read_base_motion(Reading& reading);
void read_water(Reading& reading);
/// [silt], [ice] and [earthquake], after the fluid. Loads that follow the reservoir's level become part of [water].
void read_silt(Reading& reading);
void read_ice(Reading& reading);
void read_earthquake(Reading& reading);
void read_fluid(Reading& reading);
/// [joint_flow], [[drain]] and [[grout]]: seepage flow through joints.
void read_joint_flow(Reading& reading);
void read_reservoir_model(TableReader& fluid, Reading& reading);
void read_column(TableReader& fluid, Reading& reading);
void read_external(TableReader& fluid, Reading& reading);
/// The keys of [fluid] for OpenFOAM only; other models refuse them.
void read_openfoam(TableReader& table, Reading& reading);
void read_water_expectations(Reading& reading);
void read_contact(Reading& reading);
void read_coupling(Reading& reading);
void read_output(Reading& reading);
void read_expectations(Reading& reading);
void read_variants(Reading& reading);
/// [[limit]], [[order]], [[map]] and [[bench]].
void read_studies(Reading& reading);
/// Sets lengths and speeds that [analysis], [contact] and [water] leave out, from the structure's size.
void resolve_lengths(Reading& reading);
/// Reports viscous boundaries that do not fit the analysis, or that a base motion cannot enter.
void check_viscous_boundaries(const Reading& reading);
/// Warns of loads that displace a viscous boundary permanently.
void check_drift(const Reading& reading);
/// Reports levels above what retains the water, or below the model.
void check_level_heights(const Reading& reading);
/// Highest value of a level over the run; for sines an upper bound.
double highest(const TimeTable& level, double duration_s);
/// Warns of keys without effect in a valid scene.
void check_effects(const Reading& reading);

/// Warns of records whose times or accelerations may be in another unit.
void check_records(const Reading& reading);
/// Warns of uplift laws that leave a part of the pressure out where a crack dips, in a valid scene.
void check_dipping_uplift(const Reading& reading);
/// Warns of reservoir loads that do not act as stated, in a valid scene.
void check_reservoir(const Reading& reading);
void check_shaken_water(const Reading& reading);
/// Warns of supports that leap from where the blocks are drawn, or later.
void check_leaps(const Reading& reading);
/// Reports a pool of model = "reservoir" that is shut in as the scene draws it.
void check_surface(const Reading& reading);
/// Call last.
void reject_unknown_sections(Reading& reading);

}  // namespace blockweir::scene
