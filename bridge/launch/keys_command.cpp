// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "bridge/channel/make_keys.hpp"
#include "bridge/launch/commands.hpp"
#include "bridge/results/shared_library.hpp"

namespace blockweir::launch {

Work keys_command(CLI::App& app) {
  const auto folder = std::make_shared<std::string>();
  app.add_option("folder", *folder, "folder for the keys; makes FOLDER/solid and FOLDER/fluid")->required();
  return [folder] {
    auto* const make_keys =
        reinterpret_cast<channel::MakeKeys*>(results::symbol_of(channel::keys_library, channel::make_keys_function));
    make_keys(*folder);
    fmt::print("{0}/solid is for the solid's machine, {0}/fluid for the fluid's: --keys FOLDER for each program\n",
               *folder);
    return 0;
  };
}

}  // namespace blockweir::launch
