// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "bridge/launch/commands.hpp"

namespace blockweir::launch {

Work test_command(CLI::App& /*app*/) {
  return []() -> int { throw std::invalid_argument("tests run in a source tree: ./blockweir test"); };
}

}  // namespace blockweir::launch
