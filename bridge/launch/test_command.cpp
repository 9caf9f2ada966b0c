// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "bridge/launch/commands.hpp"

namespace blockweir::launch {

Work test_command(CLI::App& app) {
  app.footer(
      "All options go to ctest, such as -L unit for the quick tests, -R NAME for those with a name, -N for a list of\n"
      "them, or -j4 for four at a time. The first call installs what tests need, and builds them, which takes long.");
  return []() -> int { throw std::invalid_argument("tests run in a source tree: ./blockweir test"); };
}

}  // namespace blockweir::launch
