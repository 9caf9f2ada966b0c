// SPDX-License-Identifier: GPL-3.0-or-later
// `blockweir modes`: natural frequencies and mode shapes of a structure at rest, as a table and a picture.
#pragma once

#include "bridge/process/ask.hpp"

namespace blockweir::study {

struct ModesOptions : process::AskOptions {
  std::filesystem::path json{};  ///< further file for the answer
};

/// Returns the exit status. Throws as process::ask() does.
int print_modes(const ModesOptions& options);

}  // namespace blockweir::study
