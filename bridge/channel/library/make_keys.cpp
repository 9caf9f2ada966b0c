// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/make_keys.hpp"

#include "bridge/channel/keys.hpp"

namespace blockweir::channel {

extern "C" __attribute__((visibility("default"))) void blockweir_make_keys(const std::filesystem::path& folder) {
  make_keys(folder);
}

}  // namespace blockweir::channel
