// SPDX-License-Identifier: GPL-3.0-or-later
// The option --variant: the same for all commands.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blockweir::launch {

inline void add_variant_option(CLI::App& app, std::string& variant) {
  const auto has_a_name = [](const std::string& name) {
    return name.find_first_not_of(" \t") != std::string::npos
               ? std::string()
               : std::string("found no name; expected that of a [[variant]]; leave --variant out for the scene itself");
  };
  app.add_option("--variant", variant, "name of one of the scene's variants")->check(has_a_name);
}

}  // namespace blockweir::launch
