// SPDX-License-Identifier: GPL-3.0-or-later
// What the shared library blockweir_keys does: keys.hpp, apart, as loading ZeroMQ takes the launcher a third of its
// start.
#pragma once

#include <filesystem>

namespace blockweir::channel {

constexpr const char* keys_library = "libblockweir_keys.so";
constexpr const char* make_keys_function = "blockweir_make_keys";

/// As make_keys().
using MakeKeys = void(const std::filesystem::path& folder);

}  // namespace blockweir::channel
