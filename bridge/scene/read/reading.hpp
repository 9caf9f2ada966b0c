// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a scene file, a function each, to be read in this order.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "bridge/scene/names.hpp"
#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/read/table_reader.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A file as tables on its way to a scene, with the names that later sections refer to.
struct Reading {
  const toml::table& file;
  Problems& problems;
  Scene& scene;
  Names materials{"material"};
  Names blocks{"block"};
  Names bolts{"bolt"};
  bool residual_given = false;          ///< [joint] states the residual angle
  std::vector<std::string> sections{};  ///< that were asked for

  /// The table [name]; null where the file has none.
  const toml::table* section(const char* name);

  /// Calls read(table) for each [[name]].
  template <class Read>
  void each(const char* name, Read read) {
    for (const toml::table* table : entries(name)) {
      TableReader reader(problems, table, entry_name(name, *table));
      read(reader);
    }
  }

  /// The outline of a block that was read soundly, else null.
  [[nodiscard]] const Block* sound_block(int index) const;

 private:
  std::vector<const toml::table*> entries(const char* name);
  static std::string entry_name(const char* name, const toml::table& table);
};

/// Reports a second entry of a name, with the line of the first, which is sought in these sections.
void refuse_second(Reading& reading, const Place& place, const char* kind, const std::string& name,
                   std::initializer_list<const char*> sections);

/// Reports a key that `set` states twice, or that the table itself varies and states.
void check_settings(TableReader& table, Reading& reading, const std::vector<std::string>& set,
                    const std::vector<std::string>& own_keys = {});

/// Reports regions, cuts and joint sets of one name. After the section, which is cut all the same.
void refuse_repeated_names(Reading& reading);

/// The law of a joint. `residual_given`: whether [joint] or this table states the residual angle; else it is the peak
/// angle.
void read_law(TableReader& table, JointLaw& law, Reading& reading, bool& residual_given);

/// The part of it on water.
void read_uplift(TableReader& table, JointLaw& law, Reading& reading);

/// Reports keys of a law that have no effect; `of_all`: the law of [joint], which others may complete.
void check_law(TableReader& table, const JointLaw& law, Reading& reading, bool of_all);
/// Reports drains and piezometers that lie beyond their joint, and joints that cannot crack by themselves.
void check_cracks(Reading& reading);
/// Reports drains that cross no joint with flow, and grout that holds none.
void check_joint_flow(Reading& reading);
/// Reports uplift without water.
void check_uplift(TableReader& table, Reading& reading);
/// Reports a joint of [[joints]] whose law acts nowhere; blocks nearer than `touching_m` touch.
void check_joint(TableReader& table, Reading& reading, const Joint& joint, double touching_m);

void read_heading(Reading& reading);
void read_analysis(Reading& reading);
void read_materials(Reading& reading);
void read_default_joint(Reading& reading);
/// Leaves a sound counter-clockwise outline, or none; messages begin with `whose`, at the place of a vertex.
void mend_outline(std::vector<Point>& outline, const std::string& whose, Problems& problems,
                  const std::function<Place(std::size_t vertex)>& place_of);
/// Takes up a block that is sound but for its name, which has to be its own.
void add_block(Reading& reading, const Place& place, Block block);
/// The same for one that [[arch]], [[wall]] or [[heap]] makes, which may be too thin.
void add_made_block(Reading& reading, TableReader& table, Block block);
/// Reports what would make more than `most` blocks, or more than 100,000 with those that are there.
bool few_enough(Reading& reading, TableReader& table, double blocks, double most = 100'000);
/// Reports what has not exactly one of value, word and formula.
void require_one_answer(TableReader& table, Reading& reading);

/// Reports a quantity or formula that the scene does not have what it speaks of, or that does not fit its answer.
void check_answer(TableReader& table, const Reading& reading, const Expectation& e);

/// [section] with its regions, cuts and joint sets: adds the blocks and the joints that they make.
void read_section(Reading& reading);
/// [[arch]], [[wall]] and [[heap]] make ordinary blocks.
void read_arches(Reading& reading);
void read_walls(Reading& reading);
void read_heaps(Reading& reading);
void read_blocks(Reading& reading);
void read_joints(Reading& reading);
void read_supports(Reading& reading);
/// [[viscous_boundary]]: faces beyond which the ground goes on.
void read_viscous_boundaries(Reading& reading);
void read_point_loads(Reading& reading);
void read_face_pressures(Reading& reading);
void read_line_loads(Reading& reading);
void read_body_loads(Reading& reading);
void read_bolts(Reading& reading);
void read_base_motion(Reading& reading);
void read_water(Reading& reading);
/// [silt], [ice] and [earthquake], after the fluid; a load that follows the reservoir's level becomes part of [water].
void read_silt(Reading& reading);
void read_ice(Reading& reading);
void read_earthquake(Reading& reading);
void read_fluid(Reading& reading);
/// [joint_flow], [[drain]] and [[grout]]: the water that flows through joints.
void read_joint_flow(Reading& reading);
void read_reservoir_model(TableReader& fluid, Reading& reading);
void read_column(TableReader& fluid, Reading& reading);
void read_external(TableReader& fluid, Reading& reading);
/// The keys of [fluid] that only OpenFOAM knows; beside another model they are refused.
void read_openfoam(TableReader& table, Reading& reading);
void read_water_expectations(Reading& reading);
void read_contact(Reading& reading);
void read_coupling(Reading& reading);
void read_output(Reading& reading);
void read_expectations(Reading& reading);
void read_variants(Reading& reading);
/// [[limit]], [[order]], [[map]] and [[bench]].
void read_studies(Reading& reading);
/// What [analysis], [contact] and [water] do not state of lengths and speeds, from the structure's size.
void resolve_lengths(Reading& reading);
/// Reports viscous boundaries that do not fit the analysis, or through which no base motion can come.
void check_viscous_boundaries(const Reading& reading);
/// Warns of loads that move a viscous boundary for good.
void check_drift(const Reading& reading);
/// Warns of what a sound scene states to no effect.
void check_effects(const Reading& reading);
/// Warns of loads of the reservoir that do not act as a sound scene states them.
void check_reservoir(const Reading& reading);
/// Reports a pool of model = "reservoir" that is shut in as the scene draws it.
void check_surface(const Reading& reading);
/// After all others.
void reject_unknown_sections(Reading& reading);

}  // namespace blockweir::scene
